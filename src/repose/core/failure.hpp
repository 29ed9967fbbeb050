// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace repose {

/// What a user reads of a failure: the text of an InputError or RunError, the system's reason, or one line that needs
/// no knowledge of C++. Validated by tests/cli/test_hostile.py.
std::string message_of(const std::exception& failure);

}  // namespace repose
