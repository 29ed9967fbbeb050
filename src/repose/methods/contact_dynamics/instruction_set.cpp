// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/instruction_set.hpp"

#include "repose/core/errors.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"

namespace repose::contact_dynamics {

bool has([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
  if (set == InstructionSet::avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return set == InstructionSet::baseline;
}

InstructionSet fastest_instruction_set() {
  static const InstructionSet fastest = has(InstructionSet::avx512) ? InstructionSet::avx512
                                        : has(InstructionSet::avx2) ? InstructionSet::avx2
                                                                    : InstructionSet::baseline;
  return fastest;
}

const Kernels& kernels_of(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return kernels_avx512();
  if (set == InstructionSet::avx2) return kernels_avx2();
#endif
  REPOSE_ASSERT(set == InstructionSet::baseline);
  return kernels_baseline();
}

}  // namespace repose::contact_dynamics
