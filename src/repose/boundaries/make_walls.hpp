// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

// Finite walls of three dimensions. Normals and directions need not be unit vectors; lengths are in [L].

Wall<3> disc_wall(const Vec<3>& centre, const Vec<3>& normal, double radius);

/// A rectangle between two sides that begin at a corner and are perpendicular. The normal is that of side_a x side_b.
Wall<3> rectangle_wall(const Vec<3>& corner, const Vec<3>& side_a, const Vec<3>& side_b);

/// A triangle whose corners are counter-clockwise about its normal.
Wall<3> triangle_wall(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c);

/// A cylinder or a cone without lids, about the axis between two different places, with a radius at each of them.
Wall<3> frustum_wall(const Vec<3>& from, const Vec<3>& to, double radius_from, double radius_to);

/// A disc with a round hole in its middle.
Wall<3> ring_wall(const Vec<3>& centre, const Vec<3>& normal, double inner_radius, double outer_radius);

/// The triangles of a surface in its order, each by the numbers of its vertices.
std::vector<Wall<3>> surface_walls(const std::vector<Vec<3>>& vertices,
                                   const std::vector<std::array<std::uint32_t, 3>>& facets);

/// The area [L^2] of one side of a wall; infinite of a plane.
double area(const Wall<3>& wall);

}  // namespace repose
