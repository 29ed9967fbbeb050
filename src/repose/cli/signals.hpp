// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace repose {

/// True after Ctrl-C, SIGTERM or SIGUSR1, once `catch_signals` was called.
extern std::atomic<bool> interrupted;

/// From now on the first Ctrl-C, SIGTERM or SIGUSR1, by which batch systems announce the end of the time, sets
/// `interrupted`; a second one kills the program.
void catch_signals();

}  // namespace repose
