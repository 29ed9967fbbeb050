// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// A straight edge that grains stay on one side of.
struct Edge {
  Vec<2> point{};   ///< [L] any point on it
  Vec<2> normal{};  ///< of length one, towards the grains
};

/// The part of the plane that is nearer to one grain than to any other.
struct VoronoiCell {
  std::int64_t id = 0;           ///< grain
  double area = 0.0;             ///< [L^2]
  double solid_fraction = 0.0;   ///< area of the disc over that of its cell; not a number for an empty cell
  bool closed = false;           ///< ends at neighbours or edges on all sides, nowhere at the cut-off
  std::vector<Vec<2>> vertices;  ///< [L] counter-clockwise, around the grain's place as stored (not wrapped)
};

/// Radical Voronoi cells (power diagram: a point x belongs to the disc with the least |x - centre|^2 - radius^2) of the
/// grains flagged `in_heap`, by ascending id. Neighbours are all grains of the heap and all fixed grains, with their
/// images in a periodic box; grains in flight are left out. A cell ends at the edges and at the cut-off: a regular
/// polygon of 32 sides about the centre, with an inscribed circle of radius `cut_off` in largest diameters in the heap.
/// A disc buried in others may have an empty cell: area 0, no vertices. Areas are good to about 1e-11 largest diameters
/// squared, the tolerance of voro++ for a vertex on a plane. Cost: near linear in the number of grains. Source: Voro++
/// (Rycroft, Chaos 19, 041111, 2009). Validated by tests/unit/voronoi_test.cpp.
std::vector<VoronoiCell> voronoi(const Grains<2>& grains, const std::vector<bool>& in_heap,
                                 const std::vector<Edge>& edges, const Box<2>& box, double cut_off = 1.5);

}  // namespace repose
