// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <cstdint>

namespace repose::deposition::spheres {

/// The number of a support: that of a grain in memory order, or one of these.
inline constexpr std::int32_t nothing = -1;
inline constexpr std::int32_t on_floor = -2;
/// The upright walls, in the order x_min, x_max, y_min, y_max.
constexpr std::int32_t on_wall(int wall) { return -3 - wall; }

// Tolerances, relative to the sum of the radii or the sine of an angle.
constexpr double touching = 1e-11;  ///< a gap up to this is a touch
constexpr double steep = 1e-11;     ///< a motion into a support is one by more than this sine
constexpr double grazing = 1e-6;    ///< [rad] a touch that would last for less than this on either side is passed

/// What a moving sphere touches: a sphere of the packing (or an image of it), or a plane.
struct Support {
  Vec<3> centre{};     ///< [L] of a sphere; the unit normal of a plane, which points to the moving sphere
  double reach = 0.0;  ///< [L] the sum of both radii; for a plane, where the moving centre touches it along the normal
  std::int32_t number = nothing;

  bool flat() const { return number < nothing; }
  bool is(const Support& other) const { return number == other.number && centre == other.centre; }

  /// The unit vector from the support to a moving sphere with its centre here.
  Vec<3> normal(const Vec<3>& place) const {
    if (flat()) return centre;
    const Vec<3> apart = place - centre;
    return apart * (1.0 / magnitude(apart));
  }
  double gap(const Vec<3>& place) const {
    return flat() ? dot(centre, place) - reach : magnitude(place - centre) - reach;
  }
};

/// An order of supports that decides between equal touches.
inline bool before(const Support& a, const Support& b) {
  if (a.number != b.number) return a.number < b.number;
  for (const int k : {0, 1}) {
    if (a.centre[k] != b.centre[k]) return a.centre[k] < b.centre[k];
  }
  return false;
}

/// The supports that a sphere touches at one place. More than twelve equal spheres cannot touch one. Paths meet
/// supports one after the other, so even of many smaller spheres only a few are listed at once.
struct Touched {
  static constexpr int most = 16;
  std::array<Support, most> list{};
  int count = 0;

  void add(const Support& support) {
    for (int k = 0; k < count; ++k) {
      if (list[static_cast<std::size_t>(k)].is(support)) return;
    }
    if (count < most) list[static_cast<std::size_t>(count++)] = support;
  }
  const Support& operator[](int k) const { return list[static_cast<std::size_t>(k)]; }
};

}  // namespace repose::deposition::spheres
