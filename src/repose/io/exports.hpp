// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"
#include "repose/io/vtk_file.hpp"
#include "repose/io/whole_file.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

/// The grains and contacts at one time. Contacts name grains that exist.
template <int D>
struct Moment {
  double time = 0.0;  ///< [T]
  std::int64_t step = 0;
  OrderedGrains<D> grains;
  Contacts<D> contacts;
  /// [M/T^2], in space [M/(L T^2)]: xx, xy, ... of each grain, row by row, and the area [L^2] or volume [L^3] that it
  /// is a mean over; empty for methods without forces.
  std::vector<std::array<double, std::size_t{D}* D>> stress = {};
  std::vector<double> extent = {};
};

/// The grains as points with all their properties and the stress.
template <int D>
VtkPolyData grains_for_vtk(const Moment<D>& moment);

/// The contacts as lines from centre to centre, or from a centre to the wall. Across a periodic side a line ends at the
/// nearest image, outside the box. Without `forces` they have partners and overlaps alone.
template <int D>
VtkPolyData contacts_for_vtk(const Moment<D>& moment, const Box<D>& box, bool forces);

/// A wall as a line [L].
struct WallLine {
  Vec<2> from{};
  Vec<2> to{};
  std::int64_t number = 0;
};

/// A wall in space as triangles [L] between its points.
struct WallSurface {
  std::vector<Vec<3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::int64_t number = 0;
};

VtkPolyData walls_for_vtk(const std::vector<WallLine>& walls);
VtkPolyData walls_for_vtk(const std::vector<WallSurface>& walls);

/// Adds the grains as a snapshot of a LAMMPS text dump, whose items have the order in which LAMMPS writes them. The
/// written box is as wide as a periodic box, or as the grains.
template <int D>
void add_grains_for_lammps(WholeFile& file, const Moment<D>& moment, const Box<D>& box);

/// Adds the contacts between grains as a snapshot of a LAMMPS local dump, which OVITO reads as bonds; `Width` [L] goes
/// with the normal force.
template <int D>
void add_contacts_for_lammps(WholeFile& file, const Moment<D>& moment, const Box<D>& box);

}  // namespace repose
