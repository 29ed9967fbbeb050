// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/ordered_grains.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The walls that bound cells in space, each infinite.
struct CellWalls {
  struct Plane {
    Vec<3> point{};   ///< [L]
    Vec<3> normal{};  ///< unit vector, towards the grains
  };
  /// A cylinder with the grains inside.
  struct Cylinder {
    Vec<3> point{};       ///< [L] on the axis
    Vec<3> axis{};        ///< unit vector
    double radius = 0.0;  ///< [L]
  };

  std::vector<Plane> planes{};
  std::vector<Cylinder> cylinders{};
};

/// The part of space that belongs to one grain.
struct SphereCell {
  std::int64_t id = 0;          ///< grain
  std::size_t place = 0;        ///< of the grain among the ordered ones
  double volume = 0.0;          ///< [L^3]
  double solid_fraction = 0.0;  ///< volume of the sphere divided by that of its cell; NaN for an empty cell
  bool closed = false;          ///< whether it ends at neighbours or walls on all sides, and nowhere at the cut-off
};

/// Radical Voronoi cells (a point x belongs to the sphere with the least |x - centre|^2 - radius^2) of the grains
/// flagged `in_heap`, by ascending id. All grains of the heap and all fixed grains bound cells, with their images in a
/// periodic box; grains in flight do not. A cell also ends at walls, and at the cut-off: a polyhedron with 26 faces
/// about the centre whose inscribed sphere has the radius `cut_off`, in units of the largest diameter in the heap. A
/// sphere buried in others, or with its centre behind a wall, may have an empty cell: volume 0.
///
/// A cell ends at planes exactly. At a cylinder it ends at tangent planes a quarter of the largest diameter d apart,
/// which leave at most a sliver (d/8)^2/(2 R) thick beyond a cylinder of radius R. Volumes are accurate to about 1e-10
/// of d^3 otherwise, from the tolerance of voro++ for a vertex on a plane. Cost: linear in the number of grains, about
/// 20 microseconds each. Source: Voro++ (Rycroft, Chaos 19, 041111, 2009). Validated by
/// tests/unit/sphere_cells_test.cpp.
std::vector<SphereCell> sphere_cells(const OrderedGrains<3>& grains, const std::vector<bool>& in_heap,
                                     const CellWalls& walls, const Box<3>& box, double cut_off = 1.5);

}  // namespace repose
