// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace repose {

/// The shape of a wall. In two dimensions every wall is straight, and nothing needs to be said.
template <int D>
struct WallShape {};

/// The shape of a wall in three dimensions, in axes that move with the wall: `side`, `across` = normal x side, and the
/// normal.
template <>
struct WallShape<3> {
  enum class Kind {
    disc,       ///< round and flat; its radius is the wall's `half_length`, infinite for a plane
    rectangle,  ///< flat
    triangle,   ///< flat
    frustum     ///< what a straight line sweeps as it turns about the normal: a cylinder, a cone or a flat ring
  };
  Kind kind = Kind::disc;
  Vec<3> side{};  ///< unit vector along the wall, perpendicular to its normal; zero: any will do
  /// [L] relative to the wall's point. Of a rectangle the first is its corner along side and across. A triangle has
  /// three, as (along side, along across), counter-clockwise about the normal. Of a frustum the first two are the ends
  /// of the line, as (distance from the axis, place along the normal).
  std::array<Vec<2>, 3> corners{};
};

/// The name of a kind of shape, and the kind of a name.
std::string_view shape_name(WallShape<3>::Kind kind);
std::optional<WallShape<3>::Kind> shape_of_name(std::string_view name);

/// A unit vector perpendicular to another, always the same one for the same bits.
Vec<3> any_perpendicular(const Vec<3>& unit);

/// The shortest line from a shape to a place.
struct NearestOnShape {
  double height = 0.0;  ///< [L] its length
  Vec<3> normal{};      ///< unit vector from the shape to the place
  bool at_end = false;  ///< whether it begins on an edge, at a corner or on a rim
};

/// The shortest line from a shape that is no disc to the place that lies at `from_point` [L] relative to the wall's
/// point; `normal` and `side` are the wall's axes now. All shapes have two sides. Where several lines are the shortest
/// (on the axis of a frustum) it takes the one from `side`, and on the wall itself one of the two directions.
/// Validated by tests/unit/walls_3d_test.cpp.
NearestOnShape nearest_on(const WallShape<3>& shape, const Vec<3>& normal, const Vec<3>& side,
                          const Vec<3>& from_point);

/// Whether a straight way from one place to another passes through a shape. Both are relative to the wall's point and
/// along its axes: side, across, normal. A start on the shape does not count. `half_length` [L] is the radius of a
/// disc.
bool passes_through(const WallShape<3>& shape, double half_length, const Vec<3>& from, const Vec<3>& to);

/// Half the extent [L] of a shape along each axis of space, about the wall's point.
Vec<3> half_extent(const WallShape<3>& shape, double half_length, const Vec<3>& normal, const Vec<3>& side);

/// The area [L^2] of one side of a shape.
double area_of(const WallShape<3>& shape, double half_length);

}  // namespace repose
