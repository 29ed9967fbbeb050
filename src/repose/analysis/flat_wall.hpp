// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/visible_part.hpp"
#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <limits>
#include <vector>

namespace repose {

/// A straight wall that bounds cells and fields: an infinite one on the side of its normal, a finite one on both sides.
struct FlatWall {
  Vec<2> point{};   ///< [L] any point on an infinite wall; the middle of a finite one
  Vec<2> normal{};  ///< unit vector, towards the grains of an infinite wall
  double half_length = std::numeric_limits<double>::infinity();  ///< [L]
};

/// The finite walls nearer than `reach` to a point, with their images in a periodic box, relative to that point.
/// Lengths of the result and `reach` are in units of `unit` [L].
std::vector<PieceOfWall> pieces_near(const Vec<2>& point, const std::vector<FlatWall>& walls, const Box<2>& box,
                                     double unit, double reach);

}  // namespace repose
