// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace repose::theory {

/// A ray from the apex of a wedge, given by its reduced position S = x tan(slope)/z: 0 on the axis, 1 on the surface.
/// Both S and 1 - S are stored, because each is exact where it is small.
struct Ray {
  double from_axis = 0.0;     ///< S
  double from_surface = 1.0;  ///< 1 - S
};

/// The stress on a ray in the right half of a wedge, divided by rho g z, z the depth below the apex (all stresses are
/// proportional to z). Compression is positive. `shear` is positive if the material above pushes that below outward.
struct WedgeStress {
  double normal = 0.0;      ///< sigma_zz
  double shear = 0.0;       ///< sigma_xz
  double horizontal = 0.0;  ///< sigma_xx
};

/// The yield margin 1 - R/(P sin(phi)), R and P the radius and centre of Mohr's circle: 0 at the Coulomb limit,
/// negative beyond it. The stress must not be zero. Source: Bratberg (2003), eq. (15), with the friction angle as
/// theta.
inline double yield_margin(const WedgeStress& stress, double sin_friction) {
  const double radius = std::hypot(0.5 * (stress.normal - stress.horizontal), stress.shear);
  const double centre = 0.5 * (stress.normal + stress.horizontal);
  return 1.0 - radius / (centre * sin_friction);
}

}  // namespace repose::theory
