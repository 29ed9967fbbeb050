// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace repose::testing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Grains under contact dynamics at positions that a test chooses. The nominal mass is 4 r^2: 1 for radius 1/2.
template <int D>
class RigidWorld {
 public:
  RigidWorld(const ImpulseLaw& law, const ContactDynamicsSettings<D>& settings) : method(ImpulseLaws(law), settings) {}
  RigidWorld(const ImpulseLaws& laws, const ContactDynamicsSettings<D>& settings) : method(laws, settings) {}

  std::int64_t add(Vec<D> position, Vec<D> velocity = {}, Spin<D> spin = {}, double radius = 0.5, bool fixed = false) {
    Grain<D> grain;
    grain.position = position;
    grain.radius = radius;
    grain.mass = 4.0 * radius * radius;
    if (!fixed) {
      grain.velocity = velocity;
      grain.rim_velocity = spin * radius;
      grain.inverse_mass = 1.0 / grain.mass;
    }
    grains.add(grain, static_cast<std::int64_t>(grains.size()), fixed);
    method.grains_added(grains);
    return grains.id.back();
  }

  StepReport advance(long steps) {
    Team alone(1);
    return method.advance(grains, method.time() + static_cast<double>(steps) * method.time_steps().length, alone);
  }
  void refresh() {
    Team alone(1);
    method.refresh(grains, alone);
  }

  /// The grain with this id.
  Grain<D>& operator[](std::int64_t id) {
    for (std::size_t k = 0; k < grains.size(); ++k) {
      if (grains.id[k] == id) return grains.line[k];
    }
    throw std::out_of_range("no such grain");
  }

  double fastest() const {
    double fastest = 0.0;
    for (const auto& grain : grains.line) {
      fastest = std::max({fastest, magnitude(grain.velocity), magnitude(grain.rim_velocity)});
    }
    return fastest;
  }

  Grains<D> grains;
  ContactDynamics<D> method;
};

inline ContactDynamicsSettings<2> rigid_2d(double time_step, double gravity,
                                           double tolerance = contact_dynamics::SolverSettings{}.tolerance) {
  ContactDynamicsSettings<2> settings;
  settings.time_step = time_step;
  settings.gravity = Vec<2>{{0.0, -gravity}};
  settings.solver.tolerance = tolerance;
  return settings;
}

/// A wall through a point; the grains are on the side of its normal.
inline Wall<2> plane(Vec<2> point, Vec<2> normal) {
  Wall<2> wall;
  wall.point = point;
  wall.normal = normal;
  return wall;
}

/// A floor at height 0 and two side walls.
inline std::vector<Wall<2>> open_box(double width) {
  return {plane({{0.0, 0.0}}, {{0.0, 1.0}}), plane({{0.0, 0.0}}, {{1.0, 0.0}}), plane({{width, 0.0}}, {{-1.0, 0.0}})};
}

}  // namespace repose::testing
