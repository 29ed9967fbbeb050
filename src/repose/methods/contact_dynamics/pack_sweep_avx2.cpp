// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX2__)
#include "repose/methods/contact_dynamics/pack_kernel.hpp"

namespace repose::contact_dynamics {

void sweep_avx2(const PackSweep& sweep) { sweep_packs(sweep); }

}  // namespace repose::contact_dynamics
#endif
