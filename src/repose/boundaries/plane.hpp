// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

namespace repose {

/// A fixed, infinite plane; grains are on the side its normal points to.
template <int D>
struct Plane {
  Vec<D> point{};
  Vec<D> normal{};
  /// An ordinary plane meets a grain at its rim and acts by the pair law, as a grain of the same size and mass would.
  /// A smooth one stands for a row of grain centres (Baxter et al. 1997): it acts at the height of the centre, holds a
  /// grain at rest one diameter above it, and has no friction.
  bool smooth = false;

  /// Height of a centre above the plane [L].
  REPOSE_FN double height(const Vec<D>& position) const { return dot(position - point, normal); }

  /// The distance that a pair law sees [L]: that of the centre to the mirror grain, or to the row of centres.
  REPOSE_FN double distance(double height, double radius) const { return smooth ? height : height + radius; }
};

}  // namespace repose
