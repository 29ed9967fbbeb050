// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/contact_force.hpp"
#include "repose/laws/registry.hpp"

#include <algorithm>
#include <variant>

namespace repose {

// Laws chosen at run time, one of each kind, with the interface of a law. They run every combination that has no kernel
// of its own, and are the reference for those that have one.

struct AnyNormal {
  NormalLaw law;
};
REPOSE_FN double reach(const AnyNormal& chosen) {
  return std::visit([](const auto& law) { return reach(law); }, chosen.law);
}
REPOSE_FN NormalForce<double> normal_force(const AnyNormal& chosen, const Touch<double>& touch) {
  return std::visit([&](const auto& law) { return normal_force(law, touch); }, chosen.law);
}

inline double elastic_energy(const AnyNormal& chosen, double mass, double diameter, double distance) {
  return std::visit([&](const auto& law) { return elastic_energy(law, mass, diameter, distance); }, chosen.law);
}

/// The law of a contact with this effective radius [L]; for the others the law itself.
inline NormalLaw at_radius(const NormalLaw& law, double effective_radius) {
  return std::visit([&](const auto& one) -> NormalLaw { return at_radius(one, effective_radius); }, law);
}

struct AnyTangential {
  TangentialLaw law;
};
template <class Tangential>
REPOSE_FN Tangential tangential_force(const AnyTangential& chosen, const Touch<double>& touch,
                                      const NormalForce<double>& normal, const Tangential& slip_velocity, double dt,
                                      Tangential& slip) {
  return std::visit([&](const auto& law) { return tangential_force(law, touch, normal, slip_velocity, dt, slip); },
                    chosen.law);
}
template <class Tangential>
REPOSE_FN Tangential displaced(const AnyTangential& chosen, const Touch<double>& touch, const Tangential& velocity,
                               double dt, const Tangential& slip) {
  return std::visit([&](const auto& law) { return displaced(law, touch, velocity, dt, slip); }, chosen.law);
}
REPOSE_FN double coulomb_limit(const AnyTangential& chosen, const NormalForce<double>& normal) {
  return std::visit([&](const auto& law) { return coulomb_limit(law, normal); }, chosen.law);
}
template <class Tangential>
REPOSE_FN double coulomb_limit(const AnyTangential& chosen, const NormalForce<double>& normal,
                               const Tangential& slip_velocity) {
  return std::visit([&](const auto& law) { return coulomb_limit(law, normal, slip_velocity); }, chosen.law);
}

template <class Tangential>
double stored_energy(const AnyTangential& chosen, const Touch<double>& touch, const NormalForce<double>& normal,
                     const Tangential& slip) {
  return std::visit([&](const auto& law) { return stored_energy(law, touch, normal, slip); }, chosen.law);
}

struct AnyRolling {
  RollingLaw law;
};
template <class Tangential>
REPOSE_FN Tangential rolling_force(const AnyRolling& chosen, const Touch<double>& touch,
                                   const NormalForce<double>& normal, const Tangential& roll_velocity, double dt,
                                   Tangential& roll) {
  return std::visit([&](const auto& law) { return rolling_force(law, touch, normal, roll_velocity, dt, roll); },
                    chosen.law);
}

template <class Tangential>
REPOSE_FN Tangential displaced(const AnyRolling& chosen, const Touch<double>& touch, const Tangential& velocity,
                               double dt, const Tangential& roll) {
  return std::visit([&](const auto& law) { return displaced(law, touch, velocity, dt, roll); }, chosen.law);
}

template <class Tangential>
double stored_energy(const AnyRolling& chosen, const Touch<double>& touch, const NormalForce<double>& normal,
                     const Tangential& roll) {
  return std::visit([&](const auto& law) { return stored_energy(law, touch, normal, roll); }, chosen.law);
}

struct AnyCohesion {
  CohesionLaw law;
};
REPOSE_FN double attraction(const AnyCohesion& chosen, const Touch<double>& touch, bool& bonded) {
  return std::visit([&](const auto& law) { return attraction(law, touch, bonded); }, chosen.law);
}

inline double cohesion_energy(const AnyCohesion& chosen, const Touch<double>& touch, bool bonded) {
  return std::visit([&](const auto& law) { return cohesion_energy(law, touch, bonded); }, chosen.law);
}

inline double energy_of_break(const AnyCohesion& chosen, const Touch<double>& touch) {
  return std::visit([&](const auto& law) { return energy_of_break(law, touch); }, chosen.law);
}

inline double reach_of_bonds(const AnyCohesion& chosen, double smallest_diameter) {
  return std::visit([&](const auto& law) { return reach_of_bonds(law, smallest_diameter); }, chosen.law);
}

struct AnyTwisting {
  TwistingLaw law;
};
REPOSE_FN double twisting_force(const AnyTwisting& chosen, const Touch<double>& touch,
                                const NormalForce<double>& normal, double twist_velocity, double dt, double& twist) {
  return std::visit([&](const auto& law) { return twisting_force(law, touch, normal, twist_velocity, dt, twist); },
                    chosen.law);
}

REPOSE_FN double twisted(const AnyTwisting& chosen, const Touch<double>& touch, double twist_velocity, double dt,
                         double twist) {
  return std::visit([&](const auto& law) { return twisted(law, touch, twist_velocity, dt, twist); }, chosen.law);
}

inline double energy_of_twist(const AnyTwisting& chosen, const Touch<double>& touch, const NormalForce<double>& normal,
                              double twist) {
  return std::visit([&](const auto& law) { return energy_of_twist(law, touch, normal, twist); }, chosen.law);
}

using AnyPairLaw = PairLaw<AnyNormal, AnyTangential, AnyRolling, AnyCohesion, AnyTwisting>;

/// Energy [M L^2/T^2] stored by the normal force and the cohesion of a pair in reach.
inline double elastic_energy(const AnyPairLaw& law, const Touch<double>& touch, bool bonded) {
  const AnyNormal normal{at_radius(law.normal.law, touch.effective_radius)};
  return elastic_energy(normal, touch.mass, touch.diameter, touch.distance) +
         cohesion_energy(law.cohesion, touch, bonded);
}

inline AnyPairLaw any_pair_law(const ContactLaws& laws) {
  return {{laws.normal}, {laws.tangential}, {laws.rolling}, {laws.cohesion}, {laws.twisting}};
}

}  // namespace repose
