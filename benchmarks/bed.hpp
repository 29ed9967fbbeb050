// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <string>

namespace repose::bench {

/// A bed of grains with its periodic box.
struct Bed {
  Grains<2> grains;
  Box<2> box;
};

/// Reads a LAMMPS data file (atom_style sphere, see beds/README.md). Type 2 is fixed; masses are d^2. `copies` copies
/// of the bed stand side by side along x.
Bed read_bed(const std::string& path, int copies);

}  // namespace repose::bench
