// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// A straight edge that grains stay on one side of, such as a plane of the scene.
struct Edge {
  Vec<2> point{};   ///< [L]
  Vec<2> normal{};  ///< unit normal, towards the grains
};

/// The part of the plane that is closer (by power distance) to one grain than to any other.
struct VoronoiCell {
  std::int64_t id = 0;
  double area = 0.0;             ///< [L^2]
  double solid_fraction = 0.0;   ///< area of the disc over that of the cell
  bool closed = false;           ///< ends at neighbours and edges on all sides
  std::vector<Vec<2>> vertices;  ///< [L] counter-clockwise about the centre of the grain, not wrapped
};

/// Radical Voronoi cells of the grains flagged `in_heap`, by ascending id, among these, all fixed grains and the edges;
/// grains in flight do not count. Cells are cut off by a polygon of 32 sides, 1.5 largest diameters from the centre,
/// which only cells at a free surface reach. Areas are good to 1e-9 of a squared diameter (the tolerance of voro++).
std::vector<VoronoiCell> voronoi(const Grains<2>& grains, const std::vector<bool>& in_heap,
                                 const std::vector<Edge>& edges, const Box<2>& box);

}  // namespace repose
