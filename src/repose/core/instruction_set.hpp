// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace repose {

/// The sets of vector instructions that kernels are compiled for. All give the same bits.
enum class InstructionSet {
  scalar,    ///< one number after the other
  baseline,  ///< what every processor of the kind has: SSE2 on x86-64
  avx2,
  avx512
};

std::string_view name_of(InstructionSet set);

/// Whether this processor has the instructions, and the program the kernels for them.
bool has(InstructionSet set);

/// The set that kernels use: the widest that the processor has, or the one that the environment variable
/// REPOSE_INSTRUCTION_SET names. Throws InputError for a name that is none, or a set that the processor lacks.
InstructionSet chosen_instruction_set();

}  // namespace repose
