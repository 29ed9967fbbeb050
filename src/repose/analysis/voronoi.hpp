// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/core/ordered_grains.hpp"
#include "repose/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// The part of the plane that belongs to one grain.
struct VoronoiCell {
  std::int64_t id = 0;           ///< grain
  double area = 0.0;             ///< [L^2]
  double solid_fraction = 0.0;   ///< area of the disc divided by that of its cell; NaN for an empty cell
  bool closed = false;           ///< whether it ends at neighbours or walls on all sides, and nowhere at the cut-off
  std::vector<Vec<2>> vertices;  ///< [L] counter-clockwise, around the grain's position
};

/// Radical Voronoi cells (power diagram: a point x belongs to the disc with the least |x - centre|^2 - radius^2) of the
/// grains flagged `in_heap`, by ascending id. All grains of the heap and all fixed grains bound cells, with their
/// images in a periodic box; grains in flight do not. A cell also ends at the cut-off, a regular polygon with 32 sides
/// about the centre whose inscribed circle has the radius `cut_off`, in units of the largest diameter in the heap, and
/// at walls. A finite wall takes away what it hides from the centre, and a grain whose centre it hides does not bound
/// the cell; so walls act where they stand only. Where a cell extends past the end of a wall, it ends at the line of
/// sight and is not closed; it need not be convex there. A disc buried in others may have an empty cell: area 0, no
/// vertices. Areas are accurate to about 1e-11 largest diameters squared, from the tolerance of voro++ for a vertex on
/// a plane. Cost: nearly linear in the number of grains. Source: Voro++ (Rycroft, Chaos 19, 041111, 2009). Validated by
/// tests/unit/voronoi_test.cpp.
std::vector<VoronoiCell> voronoi(const OrderedGrains<2>& grains, const std::vector<bool>& in_heap,
                                 const std::vector<FlatWall>& walls, const Box<2>& box, double cut_off = 1.5);

}  // namespace repose
