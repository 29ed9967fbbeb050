// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/visible_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace repose {

namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr double same_angle = 1e-11;    // two directions from the origin
constexpr double narrow_gap = 1e-3;     // between two pieces
constexpr double same_distance = 1e-9;  // relative

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// What a screen is: a side of one of the two outlines, or a piece of wall.
enum class ScreenKind : std::uint8_t { all, seen, piece };

/// A side of an outline or a piece of wall, as seen from the origin.
struct Screen {
  Vec<2> from{};
  Vec<2> to{};  // counter-clockwise of `from`
  double first = 0.0;
  double width = 0.0;  // angles of `from`, and from there to `to`
  bool bounded = true;
  ScreenKind kind = ScreenKind::piece;

  bool covers(double angle) const {
    double past = angle - first;
    if (past < 0.0) past += whole_turn;
    return past < width;
  }
  double distance(const Vec<2>& direction) const { return cross(from, to - from) / cross(direction, to - from); }
};

double angle_of(const Vec<2>& point) { return std::atan2(point[1], point[0]); }

Screen screen_of(Vec<2> from, Vec<2> to) {
  if (cross(from, to) < 0.0) std::swap(from, to);
  Screen screen{.from = from, .to = to, .first = angle_of(from)};
  screen.width = angle_of(to) - screen.first;
  if (screen.width < 0.0) screen.width += whole_turn;
  if (screen.width > std::numbers::pi) screen.width = 0.0;  // end-on, and rounding reversed the ends
  return screen;
}

/// The directions in which the nearest screen may change, ascending.
std::vector<double> directions_of_change(const std::vector<Screen>& screens) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < screens.size(); ++k) {
    const auto& a = screens[k];
    angles.push_back(a.first);
    angles.push_back(angle_of(a.to));
    if (a.kind != ScreenKind::piece) continue;
    for (std::size_t j = 0; j < screens.size(); ++j) {
      const auto& b = screens[j];
      if (j == k || (b.kind == ScreenKind::piece && j < k)) continue;
      const Vec<2> along = a.to - a.from;
      const Vec<2> other = b.to - b.from;
      const double turn = cross(along, other);
      if (turn == 0.0) continue;
      const double place = cross(b.from - a.from, other) / turn;
      if (place > 0.0 && place < 1.0) angles.push_back(angle_of(a.from + along * place));
    }
  }
  std::sort(angles.begin(), angles.end());
  std::vector<double> distinct;
  for (const double angle : angles) {
    if (distinct.empty() || angle - distinct.back() > same_angle) distinct.push_back(angle);
  }
  return distinct;
}

/// An interval of directions in which one screen is the nearest.
struct View {
  const Screen* screen = nullptr;
  double width = 0.0;
  Vec<2> start{};
  Vec<2> end{};
};

/// The screen in which a view ends: where a piece stands in that direction, the piece or the outline by the seen
/// neighbours, whichever is nearer; elsewhere the outline by all.
const Screen* screen_at(double angle, const Vec<2>& direction, const std::vector<Screen>& screens) {
  std::array<const Screen*, 3> nearest{};
  std::array<double, 3> distance{};
  for (const auto& screen : screens) {
    if (!screen.covers(angle)) continue;
    const auto kind = static_cast<std::size_t>(screen.kind);
    const double at = screen.distance(direction);
    if (nearest[kind] != nullptr && at >= distance[kind]) continue;
    nearest[kind] = &screen;
    distance[kind] = at;
  }
  const auto [all, seen, piece] = nearest;
  if (piece == nullptr || seen == nullptr) return all;
  return distance[2] < distance[1] ? piece : seen;
}

std::vector<View> views_of(const std::vector<Screen>& screens) {
  std::vector<View> views;
  const auto angles = directions_of_change(screens);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double begin = angles[k];
    const double end = k + 1 < angles.size() ? angles[k + 1] : angles[0] + whole_turn;
    const auto direction = [](double angle) { return Vec<2>{{std::cos(angle), std::sin(angle)}}; };
    double middle = 0.5 * (begin + end);
    if (middle > std::numbers::pi) middle -= whole_turn;
    const auto* screen = screen_at(middle, direction(middle), screens);
    if (screen == nullptr) continue;
    const auto at = [&](double angle) { return direction(angle) * screen->distance(direction(angle)); };
    if (!views.empty() && views.back().screen == screen) {
      views.back().width += end - begin;
      views.back().end = at(end);
    } else {
      views.push_back({screen, end - begin, at(begin), at(end)});
    }
  }
  return views;
}

bool surrounds_origin(const Outline& outline) {
  for (std::size_t k = 0; k < outline.vertices.size(); ++k) {
    const auto& from = outline.vertices[k];
    const Vec<2> along = outline.vertices[(k + 1) % outline.vertices.size()] - from;
    const double length = magnitude(along);
    if (length > same_distance && cross(from, along) <= same_distance * length) return false;
  }
  return true;
}

bool meet(const Vec<2>& a, const Vec<2>& b) {
  return magnitude(a - b) <= std::max(same_distance, narrow_gap * std::min(magnitude(a), magnitude(b)));
}

}  // namespace

double distance_to(const PieceOfWall& piece) {
  const Vec<2> along = piece.to - piece.from;
  const double place = std::clamp(-dot(piece.from, along) / squared(along), 0.0, 1.0);
  return magnitude(piece.from + along * place);
}

bool hides(const PieceOfWall& piece, const Vec<2>& point) {
  constexpr double rounding = 1e-9;
  const Vec<2> along = piece.to - piece.from;
  const double turn = cross(point, along);
  if (std::fabs(turn) <= rounding * magnitude(point) * magnitude(along)) return false;  // end-on
  const double at_point = cross(piece.from, along) / turn;
  const double at_piece = cross(piece.from, point) / turn;
  return at_point > rounding && at_point < 1.0 - rounding && at_piece > -rounding && at_piece < 1.0 + rounding;
}

VisiblePart visible_part(const Outline& all, const Outline& seen, const std::vector<PieceOfWall>& pieces) {
  if (!surrounds_origin(seen)) return {all.vertices, false};
  std::vector<Screen> screens;
  const auto add = [&](const Vec<2>& from, const Vec<2>& to, ScreenKind kind, bool bounded) {
    auto screen = screen_of(from, to);
    screen.kind = kind;
    screen.bounded = bounded;
    if (screen.width > same_angle) screens.push_back(screen);
  };
  const auto add_sides = [&](const Outline& outline, ScreenKind kind) {
    const auto count = outline.vertices.size();
    for (std::size_t k = 0; k < count; ++k)
      add(outline.vertices[k], outline.vertices[(k + 1) % count], kind, outline.bounded[k] != 0);
  };
  add_sides(surrounds_origin(all) ? all : seen, ScreenKind::all);
  add_sides(seen, ScreenKind::seen);
  for (const auto& piece : pieces) add(piece.from, piece.to, ScreenKind::piece, true);

  const auto views = views_of(screens);
  const auto view = [&](std::size_t k) -> const View& { return views[k % views.size()]; };
  const auto is_piece = [&](std::size_t k) { return view(k).screen->kind == ScreenKind::piece; };
  const auto is_narrow_gap = [&](std::size_t k) {
    return view(k).width < narrow_gap && !is_piece(k) && is_piece(k + views.size() - 1) && is_piece(k + 1);
  };
  VisiblePart part;
  part.closed = true;
  for (std::size_t k = 0; k < views.size(); ++k) {
    part.vertices.push_back(view(k).start);
    const bool meets_next = meet(view(k).end, view(k + 1).start);
    if (magnitude(view(k).end - view(k + 1).start) > same_distance) part.vertices.push_back(view(k).end);
    if (is_narrow_gap(k)) continue;
    part.closed &= view(k).screen->bounded && (meets_next || is_narrow_gap(k + 1));
  }
  return part;
}

}  // namespace repose
