// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

constexpr double most_damping = 20.0;

/// The state of a pair on the line of its centres.
struct Approach {
  double distance;  // [L]
  double speed;     // [L/T] closing speed
};

Approach operator+(const Approach& a, const Approach& b) { return {a.distance + b.distance, a.speed + b.speed}; }
Approach operator*(double s, const Approach& a) { return {s * a.distance, s * a.speed}; }

}  // namespace

Impact head_on(const AnyNormal& law, const ImpactConditions& c) {
  const double within = reach(law) * c.diameter;
  const auto force = [&](const Approach& at) {
    return normal_force(law, make_touch(at.distance, 1.0 / at.distance, c.diameter, within, at.speed, c.mass,
                                        1.0 / c.reduced_mass, 0.5 * c.diameter));
  };
  const auto change = [&](const Approach& at) {
    const double push = at.distance < within ? force(at).total : 0.0;
    return Approach{-at.speed, -push / c.reduced_mass};
  };
  const double energy = 0.5 * c.reduced_mass * c.speed * c.speed;
  const double stiffness =
      std::visit([&](const auto& one) { return stiffness_at(one, c.mass, c.diameter, energy); }, law.law);
  constexpr double phase = 2e-3;  // frequency at the stiffest moment times the step of the fourth-order integrator
  const double step = phase * std::sqrt(c.reduced_mass / stiffness);
  constexpr long most_steps = 4'000'000;
  Impact impact;
  Approach at{within * (1.0 - 1e-15), c.speed};
  for (long n = 0; n < most_steps && at.distance < within; ++n) {
    const double overlap = c.diameter - at.distance;
    if (overlap > 0.0) impact.duration += step;
    impact.overlap = std::max(impact.overlap, overlap);
    impact.force = std::max(impact.force, force(at).total);
    const auto k1 = change(at);
    const auto k2 = change(at + 0.5 * step * k1);
    const auto k3 = change(at + 0.5 * step * k2);
    const auto k4 = change(at + step * k3);
    at = at + (step / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  impact.restitution = -at.speed / c.speed;
  return impact;
}

NormalLaw with_restitution(const NormalLaw& law, double mass, double diameter) {
  return std::visit(
      [&](auto made) -> NormalLaw {
        if (made.damping_kind != DampingKind::restitution) return made;
        ImpactConditions conditions{.mass = mass, .reduced_mass = 0.5 * mass, .diameter = diameter, .speed = 1.0};
        if constexpr (std::decay_t<decltype(made)>::restitution_depends_on_speed) {
          conditions.speed = made.impact_speed;
        } else {
          // Restitution does not depend on the speed: any impact will do that is neither too deep nor too shallow.
          conditions.speed = 0.1 * std::sqrt(stiffness_at(made, mass, diameter, 1e-4) * diameter * diameter / mass);
        }
        const auto restitution = [&](double damping) {
          made.damping = damping;
          return head_on({made}, conditions).restitution;
        };
        double low = 0.0;
        double high = most_damping;
        if (!(restitution(high) <= made.restitution)) {
          made.damping = std::numeric_limits<double>::quiet_NaN();
          return made;
        }
        for (int n = 0; n < 48; ++n) {
          const double middle = 0.5 * (low + high);
          (restitution(middle) > made.restitution ? low : high) = middle;
        }
        made.damping = made.restitution == 1.0 ? 0.0 : 0.5 * (low + high);
        return made;
      },
      law);
}

double static_overlap(const AnyNormal& law, double mass, double diameter, double force) {
  const auto carried = [&](double distance) {
    return normal_force(law, make_touch(distance, 1.0 / distance, diameter, reach(law) * diameter, 0.0, mass)).elastic;
  };
  double low = 1e-3 * diameter;
  double high = reach(law) * diameter;
  if (!(carried(low) >= force)) return std::numeric_limits<double>::infinity();
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (carried(middle) > force ? low : high) = middle;
  }
  return diameter - 0.5 * (low + high);
}

}  // namespace repose
