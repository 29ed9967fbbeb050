// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/packs.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// What Packs::sweep_to_and_fro is told.
struct PackSweep {
  const ContactPack* packs;
  std::size_t count;
  double* impulses;
  Body<2>* bodies;
  double* changes;
  const double* shares;
  bool rolling;
};

// One source, pack_kernel.hpp, compiled for each set of instructions.
void sweep_baseline(const PackSweep& sweep);
void sweep_avx2(const PackSweep& sweep);
void sweep_avx512(const PackSweep& sweep);

}  // namespace repose::contact_dynamics
