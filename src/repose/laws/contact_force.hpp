// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/displacement.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/pair_law.hpp"
#include "repose/laws/touch.hpp"

#include <type_traits>

namespace repose {

/// The forces of one contact on its first grain.
template <class Tangential, class T = double>
struct ContactForce {
  NormalForce<T> normal;    ///< without cohesion
  T attraction{};           ///< [M L/T^2] cohesive force, >= 0, to be subtracted from the normal force
  Tangential tangential{};  ///< [M L/T^2]
  Tangential rolling{};     ///< [M L/T^2] rolling torque divided by the roll radius; opposite on the second grain
  T twisting{};             ///< [M L/T^2] torque along the normal, likewise; of spheres
};

/// What a contact keeps of its past: displacements [L], and whether it is bonded.
template <class Tangential>
struct ContactHistory {
  Tangential slip{};    ///< slip displacement
  Tangential roll{};    ///< rolling displacement
  bool bonded = false;  ///< it holds grains that do not overlap; for laws of cohesion that make bonds
  double twist = 0.0;   ///< displacement about the normal, of spheres; for laws that resist twisting
};

/// Whether a law resists twisting where contacts have such tangents.
template <class Law, class Tangential>
inline constexpr bool resists_twisting = dimension_of_tangent<Tangential> == 3 && Law::twists;

/// Evaluates all laws of a pair in reach, and advances its history by dt. The roll velocity is the roll radius times
/// the angular velocity of the first grain minus that of the second, without its part along the normal, which is the
/// twist velocity. Friction and the resistance to rolling and twisting depend on the normal force without cohesion.
template <class Law, class T, class Tangential>
REPOSE_FN ContactForce<Tangential, T> contact_force(const Law& law, const Touch<T>& touch,
                                                    const Tangential& slip_velocity, const Tangential& roll_velocity,
                                                    const std::type_identity_t<T>& dt,
                                                    ContactHistory<Tangential>& history,
                                                    const std::type_identity_t<T>& twist_velocity = T(0.0)) {
  ContactForce<Tangential, T> force{
      normal_force(law.normal, touch), attraction(law.cohesion, touch, history.bonded), {}, {}, {}};
  if constexpr (Law::coheres) {
    if (touch.engagement < 0.0) {  // bonded beyond the reach of the normal law, which is no law there
      force.normal = {};
      history.slip = Tangential{};
      history.roll = Tangential{};
      history.twist = 0.0;
      return force;
    }
  }
  force.tangential = tangential_force(law.tangential, touch, force.normal, slip_velocity, dt, history.slip);
  force.rolling = rolling_force(law.rolling, touch, force.normal, roll_velocity, dt, history.roll);
  if constexpr (resists_twisting<Law, Tangential>) {
    force.twisting = twisting_force(law.twisting, touch, force.normal, twist_velocity, dt, history.twist);
  }
  return force;
}

/// The time [T] by which displacements advance before the force. A contact without displacements that was out of reach
/// a step ago has existed since it entered the reach; half a step instead would be an error of first order.
template <class Law, class T, class Tangential>
REPOSE_FN T time_before_force(const Law&, const HalfSteps& times, const Touch<T>& touch,
                              const ContactHistory<Tangential>& history) {
  const auto entered = touch.engagement < 2.0 * times.before * touch.closing_speed;
  auto displaced = magnitude(history.slip) > T(0.0) || magnitude(history.roll) > T(0.0);
  if constexpr (resists_twisting<Law, Tangential>) displaced = displaced || history.twist != 0.0;
  return choose(entered && !displaced, touch.engagement / touch.closing_speed, T(times.before));
}

/// The same from velocities at the time of the force. The history then belongs to the middle between two forces.
template <class Law, class T, class Tangential>
REPOSE_FN ContactForce<Tangential, T> contact_force(const Law& law, const Touch<T>& touch,
                                                    const Tangential& slip_velocity, const Tangential& roll_velocity,
                                                    const HalfSteps& times, ContactHistory<Tangential>& history,
                                                    const std::type_identity_t<T>& twist_velocity = T(0.0)) {
  const T before = time_before_force(law, times, touch, history);
  const auto force = contact_force(law, touch, slip_velocity, roll_velocity, before, history, twist_velocity);
  if constexpr (Law::coheres) {
    if (touch.engagement < 0.0) return force;
  }
  history.slip = displaced(law.tangential, touch, slip_velocity, times.after, history.slip);
  history.roll = displaced(law.rolling, touch, roll_velocity, times.after, history.roll);
  if constexpr (resists_twisting<Law, Tangential>) {
    history.twist = twisted(law.twisting, touch, twist_velocity, times.after, history.twist);
  }
  return force;
}

}  // namespace repose
