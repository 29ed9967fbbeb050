// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose {

/// Becomes `python3 -m MODULE ARGUMENTS` of the Python package, which draws; only returns by throwing RunError.
[[noreturn]] void hand_over_to_python(const std::string& module, const std::vector<std::string>& arguments);

}  // namespace repose
