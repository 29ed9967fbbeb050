// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// A piece of wall, by its ends relative to the centre of a cell.
struct PieceOfWall {
  Vec<2> from{};
  Vec<2> to{};
};

/// The distance from the origin to the nearest point of a piece.
double distance_to(const PieceOfWall& piece);

/// Whether a piece crosses the line from the origin to a point. A point on the piece is not hidden by it; the ends of
/// the piece belong to it, so that no line passes between two pieces that meet.
bool hides(const PieceOfWall& piece, const Vec<2>& point);

/// A convex outline around the origin, counter-clockwise. Side k runs from vertex k to the next one.
struct Outline {
  std::vector<Vec<2>> vertices;
  std::vector<std::uint8_t> bounded;  ///< for each side, 1: a neighbour or wall lies there; 0: the cut-off
};

/// The part of a cell that a view from the origin reaches.
struct VisiblePart {
  std::vector<Vec<2>> vertices;  ///< counter-clockwise
  bool closed = false;           ///< whether it ends at neighbours or walls on all sides
};

/// The part of a cell that no piece hides from the origin. `all` is the outline by all neighbours, `seen` that by the
/// neighbours whose centres no piece hides. In the directions in which a piece stands, the part ends at the piece or at
/// `seen`, whichever is nearer, and elsewhere at `all`. Past the end of a piece it follows the line of sight, and is
/// not closed there. Gaps between two pieces that are narrower than 1e-3, as an angle at the origin, leave it closed.
/// If the origin lies outside of `seen`, `all` is returned and not closed.
VisiblePart visible_part(const Outline& all, const Outline& seen, const std::vector<PieceOfWall>& pieces);

}  // namespace repose
