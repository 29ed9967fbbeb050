// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/instruction_set.hpp"

#include "repose/core/errors.hpp"

#include <array>
#include <cstdlib>
#include <string>

namespace repose {

namespace {

constexpr const char* variable = "REPOSE_INSTRUCTION_SET";
constexpr std::array all = {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2,
                            InstructionSet::avx512};

InstructionSet widest() {
  auto found = InstructionSet::baseline;
  for (const auto set : all) {
    if (has(set)) found = set;
  }
  return found;
}

InstructionSet named(std::string_view name) {
  for (const auto set : all) {
    if (name_of(set) != name) continue;
    if (has(set)) return set;
    throw InputError(std::string(variable) + " = " + std::string(name) + ": this processor does not have it");
  }
  throw InputError(std::string(variable) + " = " + std::string(name) + ": must be scalar, baseline, avx2 or avx512");
}

}  // namespace

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::scalar:
      return "scalar";
    case InstructionSet::baseline:
      return "baseline";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      break;
  }
  return "avx512";
}

bool has(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (set == InstructionSet::avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
#endif
  return set == InstructionSet::scalar || set == InstructionSet::baseline;
}

InstructionSet chosen_instruction_set() {
  const char* const name = std::getenv(variable);
  return name == nullptr || *name == '\0' ? widest() : named(name);
}

}  // namespace repose
