// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <vector>

namespace repose {

/// The part of a wall that grains can press on.
struct WallSpan {
  Vec<2> middle{};      ///< [L]
  double length = 0.0;  ///< [L] 0 where nothing is left of the wall
};

/// The span of each of the walls that stand. A finite wall is all of its span. That of a plane lies on the grains' side
/// of the other planes; where these leave it open, it reaches as far as moving grains do along it. A plane that stands
/// across a periodic box is as long as the box.
/// Validated by tests/unit/wall_forces_test.cpp.
std::vector<WallSpan> wall_spans(const std::vector<FlatWall>& walls, const Grains<2>& grains, const Box<2>& box);

/// The moment [M L^2/T^2] of the grains on each wall about the middle of its span, counter-clockwise, by the contacts.
std::vector<double> wall_moments(const std::vector<WallSpan>& spans, const Grains<2>& grains,
                                 const Contacts<2>& contacts, const Box<2>& box);

/// Along a wall: its normal turned by +90 degrees.
inline Vec<2> along_wall(const Vec<2>& normal) { return {{-normal[1], normal[0]}}; }

}  // namespace repose
