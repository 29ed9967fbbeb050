// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/packs.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// The arguments of Packs::sweep_both_ways.
struct PackSweep {
  const ContactPack* packs;
  std::size_t count;
  double* impulses;
  Body<2>* bodies;
  double* changes;
  const double* fractions;
  bool rolling;
};

// One source, pack_kernel.hpp, compiled for each instruction set.
void sweep_baseline(const PackSweep& sweep);
void sweep_avx2(const PackSweep& sweep);
void sweep_avx512(const PackSweep& sweep);

}  // namespace repose::contact_dynamics
