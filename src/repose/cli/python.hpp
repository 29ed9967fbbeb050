// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose {

/// Replaces the program by `python3 -m MODULE ARGUMENTS` of the Python package, which python/repose/start.py runs. Ends
/// the program where standard output has failed. Throws RunError if Python does not start.
[[noreturn]] void hand_over_to_python(const std::string& module, const std::vector<std::string>& arguments);

}  // namespace repose
