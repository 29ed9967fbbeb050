// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// Makes the program safe from what it is started with. Closed standard streams become /dev/null, so that no file that
/// it writes takes their place; a full disk and a reader that leaves are failures of a write, not signals that kill;
/// and memory ends where that of the machine does, with a failure and not with the kill of some process.
void settle_in();

}  // namespace repose
