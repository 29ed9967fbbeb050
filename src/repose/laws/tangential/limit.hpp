// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/laws/touch.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

/// The limit [M L/T^2] of friction at this slip [L/T], of laws whose friction does not depend on it.
template <class Law, class Tangential>
REPOSE_FN double coulomb_limit(const Law& law, const NormalForce<double>& normal, const Tangential& /*slip_velocity*/) {
  return coulomb_limit(law, normal);
}

/// The tangent a, shortened to a length of at most `longest` >= 0.
REPOSE_FN double limited(double a, double longest) { return std::copysign(std::min(std::fabs(a), longest), a); }
template <int D>
REPOSE_FN Vec<D> limited(const Vec<D>& a, double longest) {
  const double length = magnitude(a);
  return length > longest ? a * (longest / length) : a;
}

/// The unit tangent along a. If a is zero, it is zero in 3D and +-1 in 2D.
REPOSE_FN double direction(double a) { return std::copysign(1.0, a); }
template <int D>
REPOSE_FN Vec<D> direction(const Vec<D>& a) {
  const double length = magnitude(a);
  return length > 0.0 ? a * (1.0 / length) : Vec<D>{};
}

}  // namespace repose
