// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inertia_factor.hpp"
#include "repose/core/vec.hpp"

namespace repose {

/// The resistance of a grain to rotation: of a disc in 2D, of a sphere in 3D. Laws have their factors from here.
struct Inertia {
  double inverse = inverse_inertia_factor<2>;  ///< m R^2 / I

  /// The mass over that which a tangential force at the rim of a free grain meets, since it also turns the grain.
  constexpr double at_rim() const { return 1.0 + inverse; }
};

template <int D>
inline constexpr Inertia inertia_of{inverse_inertia_factor<D>};

/// The same where the number of dimensions is known at run time only.
constexpr Inertia inertia_in(int dimension) { return dimension == 3 ? inertia_of<3> : inertia_of<2>; }

/// The number of dimensions in which a contact has such a tangent: a number in 2D, a vector in 3D. A displacement about
/// the normal, which spheres alone have, is a Vec<1>.
template <class Tangential>
inline constexpr int dimension_of_tangent = 2;
template <int D, class T>
inline constexpr int dimension_of_tangent<Vec<D, T>> = 3;

}  // namespace repose
