// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace repose {

/// True once Ctrl-C or SIGTERM has come, after `catch_signals`.
extern std::atomic<bool> interrupted;

/// The first Ctrl-C ends the work in good order; a second one kills it.
void catch_signals();

}  // namespace repose
