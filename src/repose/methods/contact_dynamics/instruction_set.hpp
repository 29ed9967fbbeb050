// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose::contact_dynamics {

/// The vector instructions that the solver uses. The results are the same to the bit.
enum class InstructionSet { baseline, avx2, avx512 };

bool has(InstructionSet set);
InstructionSet fastest_instruction_set();

}  // namespace repose::contact_dynamics
