// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/choose.hpp"
#include "repose/core/inline.hpp"

#include <limits>

namespace repose {

/// The geometry and motion of a pair, which is all that a force law sees of it. Signs: overlap > 0 touching,
/// closing_speed > 0 approaching.
template <class T>
struct Touch {
  T distance;          ///< [L] between the centres
  T inverse_distance;  ///< [1/L]
  T diameter;          ///< [L] mean of the two diameters: the distance at which rigid grains would touch
  T overlap;           ///< [L] diameter - distance
  T engagement;        ///< [L] cutoff distance - distance, > 0: depth of the pair within the reach of the normal law
  T closing_speed;     ///< [L/T]
  T mass;              ///< [M] 2 m_i m_j / (m_i + m_j) of the nominal masses; for equal grains, the mass of one
  T inverse_mass;      ///< [1/M] 1 / m_i + 1 / m_j, where a fixed partner has infinite mass
  T roll_radius;       ///< [L] 2 R_i R_j / (R_i + R_j); for equal grains, the radius of one
  T effective_radius;  ///< [L] R* = R_i R_j / (R_i + R_j) of elastic contacts; the radius of a grain on a flat wall

  /// [M] m_i m_j / (m_i + m_j), where a fixed partner has infinite mass. Few laws need it, and it costs a division.
  REPOSE_FN T reduced_mass() const { return T(1.0) / inverse_mass; }
};

/// A touch from its independent numbers; `within` [L] is the distance below which the normal law acts. Without the last
/// two numbers, both grains are free and of one size.
template <class T>
REPOSE_FN Touch<T> make_touch(T distance, T inverse_distance, T diameter, T within, T closing_speed, T mass,
                              T inverse_mass, T roll_radius) {
  return {distance, inverse_distance, diameter,    diameter - distance, within - distance, closing_speed,
          mass,     inverse_mass,     roll_radius, T(0.5) * roll_radius};
}
template <class T>
REPOSE_FN Touch<T> make_touch(T distance, T inverse_distance, T diameter, T within, T closing_speed, T mass) {
  return make_touch(distance, inverse_distance, diameter, within, closing_speed, mass, T(2.0) / mass,
                    T(0.5) * diameter);
}

/// A normal force and its parts.
template <class T>
struct NormalForce {
  T elastic;      ///< [M L/T^2] >= 0, a function of the distance alone
  T total;        ///< [M L/T^2] with damping; positive pushes the grains apart
  T stiffness{};  ///< [M/T^2] -d(elastic)/d(distance)
};

/// The total force, set to zero if it is negative and `attraction` is off: dry grains do not attract each other.
template <class T>
REPOSE_FN T without_attraction(bool attraction, T force) {
  return larger(force, T(attraction ? -std::numeric_limits<double>::infinity() : 0.0));
}

}  // namespace repose
