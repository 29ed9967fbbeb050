// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// The memory of this machine, or of the container that the program runs in [bytes].
double machine_memory();

/// The number of hardware threads, at least 1.
int machine_threads();

}  // namespace repose
