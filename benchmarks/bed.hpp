// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <string>

namespace repose::bench {

/// A bed of grains with its periodic box.
template <int D>
struct Bed {
  Grains<D> grains;
  Box<D> box;
};

/// Discs have the mass d^2, spheres d^3.
template <int D>
double mass_of(double diameter) {
  return D == 2 ? diameter * diameter : diameter * diameter * diameter;
}

/// Reads a LAMMPS data file (atom_style sphere, see beds/README.md). Type 2 is fixed. `copies` copies of the bed stand
/// side by side along x. Throws std::runtime_error.
template <int D>
Bed<D> read_bed(const std::string& path, int copies);

/// Writes such a file.
template <int D>
void write_bed(const Bed<D>& bed, const std::string& path);

}  // namespace repose::bench
