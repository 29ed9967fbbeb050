// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/io/vtk_file.hpp"

#include <cstdint>
#include <string>

namespace repose {

/// Grains (by ascending id) and contacts of one moment.
struct Moment {
  double time = 0.0;  ///< [T]
  std::int64_t step = 0;
  Grains<2> grains;
  Contacts<2> contacts;
};

/// The grains as points with all that is known of them.
VtkPolyData grains_for_vtk(const Moment& moment);

/// The contacts as lines from centre to centre, or from a centre to the wall. Across a periodic side a line goes to the
/// nearest image, beyond the side.
VtkPolyData contacts_for_vtk(const Moment& moment, const Box<2>& box);

/// The grains as a snapshot of a LAMMPS text dump, to be put behind others. `box` is as wide as the simulation or,
/// where it is open, as the grains.
std::string grains_for_lammps(const Moment& moment, const Box<2>& box);

/// The contacts of grains with each other as a snapshot of a LAMMPS local dump, which OVITO reads as bonds.
std::string contacts_for_lammps(const Moment& moment, const Box<2>& box);

/// A group of an HDF5 file as a table: its datasets of `rows` rows, a column for each of their columns.
std::string csv_of(const Hdf5Reader& file, const std::string& group, std::size_t rows);

}  // namespace repose
