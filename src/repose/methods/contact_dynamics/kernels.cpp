// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/kernels.hpp"

namespace repose::contact_dynamics {

const Kernels& kernels_of([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return kernels_avx512();
  if (set == InstructionSet::avx2) return kernels_avx2();
#endif
  return kernels_baseline();
}

}  // namespace repose::contact_dynamics
