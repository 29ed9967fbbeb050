// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"
#include "repose/methods/soft/soft.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>

namespace repose::testing {

/// A rotation in space, as the images of the three axes.
struct Rotation {
  std::array<Vec<3>, 3> axis{Vec<3>{{1.0, 0.0, 0.0}}, Vec<3>{{0.0, 1.0, 0.0}}, Vec<3>{{0.0, 0.0, 1.0}}};

  Vec<3> operator()(const Vec<3>& a) const { return axis[0] * a[0] + axis[1] * a[1] + axis[2] * a[2]; }
};

/// A random number from 0 to 1, of this seed and draw.
inline double number(std::uint64_t seed, std::uint32_t draw) {
  return uniform(seed, Purpose::release_position, 0, draw);
}

/// A random unit vector, from draws `draw` and the next.
inline Vec<3> random_direction(std::uint64_t seed, std::uint32_t draw = 0) {
  const double height = 2.0 * number(seed, draw) - 1.0;
  const double angle = 2.0 * std::numbers::pi * number(seed, draw + 1);
  const double width = std::sqrt(1.0 - height * height);
  return {{width * std::cos(angle), width * std::sin(angle), height}};
}

/// A random rotation.
inline Rotation random_rotation(std::uint64_t seed) {
  const Vec<3> up = random_direction(seed, 100);
  const Vec<3> other = random_direction(seed, 102);
  const Vec<3> across = cross(up, other) * (1.0 / magnitude(cross(up, other)));
  return {{across, cross(up, across), up}};
}

/// Spheres of mass 1 and radius 1/2, unless another is given, under any method in 3D.
class Spheres {
 public:
  explicit Spheres(std::unique_ptr<Method<3>> method, int threads = 1)
      : method_(std::move(method)), team_(std::make_unique<Team>(threads)) {}
  Spheres(const ContactLaws& laws, const SoftSettings<3>& settings, int threads = 1)
      : Spheres(make_soft<3>(MaterialLaws{1, {laws}}, settings), threads) {}
  Spheres(const ImpulseLaw& law, const ContactDynamicsSettings<3>& settings, int threads = 1)
      : Spheres(make_contact_dynamics<3>(ImpulseLaws(law), settings), threads) {}

  std::int64_t add(const Vec<3>& position, const Vec<3>& velocity = {}, const Vec<3>& spin = {}, double radius = 0.5,
                   bool fixed = false) {
    Grain<3> grain;
    grain.position = position;
    grain.radius = radius;
    grain.mass = 8.0 * radius * radius * radius;
    if (!fixed) {
      grain.velocity = velocity;
      grain.rim_velocity = spin * radius;
      grain.inverse_mass = 1.0 / grain.mass;
    }
    grains.add(grain, static_cast<std::int64_t>(grains.size()), fixed);
    method_->grains_added(grains);
    return grains.id.back();
  }

  StepReport advance(long steps) {
    return method_->advance(grains, method_->time() + static_cast<double>(steps) * method_->time_steps().length,
                            *team_);
  }
  Contacts<3> contacts() const { return method_->contacts(grains); }
  void refresh() { method_->refresh(grains, *team_); }
  Method<3>& method() { return *method_; }

  /// The grain with this id.
  Grain<3>& operator[](std::int64_t id) { return grains.line[by_id(grains).at(static_cast<std::size_t>(id))]; }

  Grains<3> grains;

 private:
  std::unique_ptr<Method<3>> method_;
  std::unique_ptr<Team> team_;
};

/// The angular velocity [1/T] of a grain.
inline Vec<3> spin_of(const Grain<3>& grain) { return grain.rim_velocity * (1.0 / grain.radius); }

inline Wall<3> endless_plane(const Vec<3>& point, const Vec<3>& normal) {
  Wall<3> wall;
  wall.point = point;
  wall.normal = normal;
  return wall;
}

inline SoftSettings<3> soft_3d(double time_step, const Vec<3>& gravity = {}) {
  SoftSettings<3> settings;
  settings.time_step = time_step;
  settings.gravity = gravity;
  return settings;
}

inline ContactDynamicsSettings<3> rigid_3d(double time_step, const Vec<3>& gravity = {}, double tolerance = 1e-12) {
  ContactDynamicsSettings<3> settings;
  settings.time_step = time_step;
  settings.gravity = gravity;
  settings.solver.tolerance = tolerance;
  return settings;
}

}  // namespace repose::testing
