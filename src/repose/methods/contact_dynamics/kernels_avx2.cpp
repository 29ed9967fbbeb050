// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX2__)
#include "repose/methods/contact_dynamics/motion_kernel.hpp"
#include "repose/methods/contact_dynamics/pack_kernel.hpp"

namespace repose::contact_dynamics {

const Kernels& kernels_avx2() {
  static constexpr Kernels all{sweep_forward,  sweep_back,        separate_energies,
                               start_impulses, motion_kernels<2>, motion_kernels<3>};
  return all;
}

}  // namespace repose::contact_dynamics
#endif
