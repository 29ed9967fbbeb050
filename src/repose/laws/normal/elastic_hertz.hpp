// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/normal/damping.hpp"
#include "repose/laws/normal/hertz.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// Hertz's law from the elastic constants of the materials: F = 4/3 E* sqrt(R*) overlap^(3/2), with R* the effective
/// radius of the pair, or of a grain and a flat wall. The modulus E* belongs to the pair of materials, so no key gives
/// it. Source: Johnson, Contact Mechanics (1985), eq. (4.23).
/// Validated by tests/unit/elasticity_test.cpp (force, impacts of unequal spheres) and tests/cli/test_si.py.
struct ElasticHertz {
  double modulus = 1e5;     ///< E* [M/(L T^2)] > 0
  double damping = 0.5;     ///< >= 0; its meaning depends on damping_kind
  bool attraction = false;  ///< whether the dashpot may make the total force attractive
  DampingKind damping_kind = DampingKind::of_critical;
  double restitution = 0.0;  ///< requested restitution, if damping_kind is restitution

  static constexpr std::string_view name = "hertz";
  static constexpr bool restitution_depends_on_speed = false;
};

inline void parameters(ElasticHertz& law, Parameters& to, const LawScales& scales) {
  damping_parameters(law, to, scales);
}

/// The law of a contact with this effective radius [L], as one that does not depend on it. Every other law is its own.
template <class Law>
REPOSE_FN Law at_radius(const Law& law, double /*effective_radius*/) {
  return law;
}
/// k of F = k overlap^(3/2).
template <class T>
REPOSE_FN T hertz_stiffness(const ElasticHertz& law, const T& effective_radius) {
  return (4.0 / 3.0) * law.modulus * root(effective_radius);
}
REPOSE_FN Hertz at_radius(const ElasticHertz& law, double effective_radius) {
  return {hertz_stiffness(law, effective_radius), law.damping, law.attraction, law.damping_kind, law.restitution};
}

REPOSE_FN double reach(const ElasticHertz&) { return 1.0; }

template <class T>
REPOSE_FN NormalForce<T> normal_force(const ElasticHertz& law, const Touch<T>& touch) {
  return hertz_force(law, hertz_stiffness(law, touch.effective_radius), touch);
}

// For two grains of one size, whose effective radius is a quarter of the diameter.

inline double elastic_energy(const ElasticHertz& law, double mass, double diameter, double distance) {
  return elastic_energy(at_radius(law, 0.25 * diameter), mass, diameter, distance);
}

inline double stiffness_at(const ElasticHertz& law, double mass, double diameter, double energy) {
  return stiffness_at(at_radius(law, 0.25 * diameter), mass, diameter, energy);
}

}  // namespace repose
