// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/laws/contact_force.hpp"
#include "repose/laws/touch.hpp"
#include "repose/methods/soft/push.hpp"

namespace repose::soft {

/// Sums and differences of two grains, from which the geometry of the pair follows. T is double, or a pack of numbers
/// for several pairs.
template <int D, class T>
struct PairMotion {
  Vec<D, T> separation;     ///< [L] position of the first minus that of the second, by the nearest image
  Vec<D, T> velocity;       ///< [L/T] of the first minus that of the second
  Spin<D, T> rim_velocity;  ///< [L/T] sum
  T radii;                  ///< [L] sum
  T nominal_inverse_mass;   ///< [1/M] sum, in which fixed grains have a mass too
  T inverse_mass;           ///< [1/M] sum, in which fixed grains have none
};

/// The geometry and relative motion of a pair in reach.
template <int D, class T = double>
struct PairGeometry {
  Touch<T> touch;
  Vec<D, T> normal;             ///< unit vector from the second to the first
  Tangent<D, T> slip_velocity;  ///< [L/T]
  Tangent<D, T> roll_velocity;  ///< [L/T]
  T lever;                      ///< distance of a centre from the contact point over the radius of that grain
  T twist_velocity{};           ///< [L/T] of spheres about the normal: roll radius times relative spin
};

/// The pair as a law sees it; `within` [L] is the reach of the law. The lever of each grain is its fraction
/// r s_i / (s_i + s_j) of the distance r. With the whole distance, as printed in Baxter et al. (6) and (13), a rigid
/// rotation would count as slip.
template <int D, class T>
REPOSE_FN PairGeometry<D, T> pair_geometry(const PairMotion<D, T>& pair, const T& distance2, const T& within,
                                           const T& roll_radius) {
  // One division for three quotients: it costs as much as all their products.
  const T area = distance2 * pair.radii;
  const T quotient = T(1.0) / (area * pair.nominal_inverse_mass);
  const T inverse_area = quotient * pair.nominal_inverse_mass;
  const T distance = root(distance2);
  const T inverse = inverse_area * pair.radii * distance;
  const Vec<D, T> normal = pair.separation * inverse;
  const T lever = inverse_area * distance2 * distance;
  const T mass = T(2.0) * (quotient * area);
  const Tangent<D, T> slip =
      tangential(pair.velocity, normal) - spin_cross(Spin<D, T>(pair.rim_velocity * lever), normal);
  return {make_touch(distance, inverse, pair.radii, within, -dot(pair.velocity, normal), mass, pair.inverse_mass,
                     roll_radius),
          normal,
          slip,
          Tangent<D, T>{},
          lever,
          T(0.0)};
}

/// Converts the forces of a contact to the push on its first grain, and on its second with the force negated.
template <int D, class T>
REPOSE_FN void to_push(const PairGeometry<D, T>& pair, const ContactForce<Tangent<D, T>, T>& force, Vec<D, T>& push,
                       Spin<D, T>& rim_torque) {
  push = pair.normal * (force.normal.total - force.attraction) + in_space(force.tangential, pair.normal);
  rim_torque = normal_cross(pair.normal, force.tangential) * -pair.lever;
}

}  // namespace repose::soft
