// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/laws/touch.hpp"

namespace repose {

/// The limit [M L/T^2] of friction at this slip [L/T], of laws whose friction does not depend on it.
template <class Law, class T, class Tangential>
REPOSE_FN auto coulomb_limit(const Law& law, const NormalForce<T>& normal, const Tangential& /*slip_velocity*/) {
  return coulomb_limit(law, normal);
}

/// The tangent a, shortened to a length of at most `longest` >= 0.
template <class T>
REPOSE_FN T limited(const T& a, const T& longest) {
  return with_sign_of(smaller(magnitude(a), longest), a);
}
template <int D, class T>
REPOSE_FN Vec<D, T> limited(const Vec<D, T>& a, const T& longest) {
  const T length = magnitude(a);
  return a * choose(length > longest, longest / length, T(1.0));
}

/// The unit tangent along a. If a is zero, it is zero in 3D and +-1 in 2D.
template <class T>
REPOSE_FN T direction(const T& a) {
  return with_sign_of(T(1.0), a);
}
template <int D, class T>
REPOSE_FN Vec<D, T> direction(const Vec<D, T>& a) {
  const T length = magnitude(a);
  return a * choose(length > T(0.0), T(1.0) / length, T(0.0));
}

}  // namespace repose
