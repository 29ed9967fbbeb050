// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/hybrid/hybrid.hpp"

#include <cmath>
#include <cstdint>

namespace repose::testing {

/// Settings in units of mass, diameter and gravity, for a stiffness in grain weights per diameter.
inline HybridSettings hybrid_settings(double stiffness) {
  HybridSettings settings;
  settings.gravity = Vec<2>{{0.0, -1.0}};
  settings.time_step = 0.02 * std::sqrt(1e4 / stiffness);
  settings.spring.stiffness = stiffness;
  settings.well_width = 1e-3;
  settings.slow = 1e-3;
  settings.weight = 1.0;
  settings.skin = 0.3;
  return settings;
}

/// Discs under the hybrid method at places that a test chooses. The mass is 4 r^2: 1 for radius 1/2.
class HybridWorld {
 public:
  HybridWorld(const ImpulseLaw& law, const HybridSettings& with) : settings(with), method(ImpulseLaws(law), with) {}

  void add(Vec<2> position, Vec<2> velocity = {}, double radius = 0.5, bool fixed = false) {
    Grain<2> grain;
    grain.position = position;
    grain.radius = radius;
    grain.mass = 4.0 * radius * radius;
    if (!fixed) {
      grain.velocity = velocity;
      grain.inverse_mass = 1.0 / grain.mass;
    }
    grains.add(grain, static_cast<std::int64_t>(grains.size()), fixed);
  }

  /// A pile of touching discs with this many in its lowest row, which stands on height 0; flat slopes keep the lattice
  /// centres below them.
  void add_pile(int base, double slope_deg = 60.0) {
    const double rise = 0.5 * std::sqrt(3.0);
    const double slope = slope_deg < 60.0 ? std::tan(slope_deg * 3.14159265358979323846 / 180.0) : 1e9;
    for (int row = 0; row < base; ++row) {
      for (int k = 0; k < base - row; ++k) {
        const double x = k + 0.5 * row;
        if (row * rise > slope * std::min(x, base - 1 - x) + 1e-9) continue;
        add({{x - 0.5 * (base - 1), 0.5 + row * rise}});
      }
    }
  }

  void start() { method.grains_added(grains); }
  StepReport advance(long steps) {
    Team alone(1);
    const double until = method.time() + static_cast<double>(steps) * settings.time_step;
    StepReport all;
    do {
      const auto report = method.advance(grains, until, alone);
      all.steps += report.steps;
      all.trouble = all.trouble || report.trouble;
    } while (method.time() < until - 0.5 * settings.time_step && !all.trouble);
    return all;
  }

  double energy() const {
    double sum = kinetic_energy(grains) + method.elastic_energy(grains);
    for (const auto& grain : grains.line) {
      if (!grain.fixed()) sum -= grain.mass * dot(settings.gravity, grain.position);
    }
    return sum;
  }

  HybridSettings settings;
  Grains<2> grains;
  Hybrid method;
};

inline Wall<2> level_ground() {
  Wall<2> wall;
  wall.normal = Vec<2>{{0.0, 1.0}};
  return wall;
}

}  // namespace repose::testing
