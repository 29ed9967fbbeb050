// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/pack_kernel.hpp"

namespace repose::contact_dynamics {

void sweep_baseline(const PackSweep& sweep) { sweep_packs(sweep); }

}  // namespace repose::contact_dynamics
