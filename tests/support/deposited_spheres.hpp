// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/random.hpp"
#include "repose/methods/deposition/spheres.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace repose::testing {

/// Spheres of diameters 1 - spread to 1 on a floor at height 0, in a square box, periodic or between walls.
struct SpherePacker {
  double width = 6.0;
  std::int64_t count = 200;
  double angle_deg = 0.0;
  double spread = 0.0;
  bool periodic = true;
  std::uint64_t seed = 1;
  bool mirrored = false;  // x and y exchanged
  bool snapped = false;
  std::array<double, 2> origin{};

  SphereDepositionSettings settings() const {
    SphereDepositionSettings s;
    s.critical_angle_deg = angle_deg;
    s.box.periodic = s.box.periodic_y = periodic;
    s.box.x_min = origin[0];
    s.box.x_max = origin[0] + width;
    s.box.y_min = origin[1];
    s.box.y_max = origin[1] + width;
    s.floor = 0.0;
    s.snapped = snapped;
    s.count = count;
    s.draw = [seed = seed, spread = spread, mirrored = mirrored](std::int64_t k, std::span<DroppedSphere> spheres) {
      for (auto& sphere : spheres) {
        const auto index = static_cast<std::uint64_t>(k++);
        sphere.place = {uniform(seed, Purpose::release_position, index),
                        uniform(seed, Purpose::release_position, index, 1)};
        if (mirrored) std::swap(sphere.place[0], sphere.place[1]);
        sphere.radius = 0.5 * (1.0 - spread * uniform(seed, Purpose::grain_size, index));
        sphere.mass = 8.0 * sphere.radius * sphere.radius * sphere.radius;
      }
    };
    return s;
  }

  Grains<3> pack(bool brute_force = false) const {
    Grains<3> grains;
    const auto method =
        brute_force ? make_sphere_deposition_by_brute_force(settings()) : make_sphere_deposition(settings());
    method->grains_added(grains);
    Team team(1);
    EXPECT_FALSE(method->advance(grains, static_cast<double>(count), team).trouble);
    EXPECT_TRUE(method->complete());
    return grains;
  }
};

inline Grain<3> fixed_sphere(const Vec<3>& place, double radius = 0.5) {
  Grain<3> grain;
  grain.position = place;
  grain.radius = radius;
  grain.mass = 1.0;
  return grain;
}

/// The spheres of a square, touching, at height 0.
inline Grains<3> square_base(int side) {
  Grains<3> grains;
  for (int k = 0; k < side * side; ++k) grains.add(fixed_sphere({{k / side + 0.5, k % side + 0.5, 0.0}}), k, true);
  return grains;
}

inline double deepest_overlap(const Grains<3>& grains, const Box<3>& box) {
  double deepest = -1.0;
  for (std::size_t a = 0; a < grains.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double distance = magnitude(separation(grains.line[a].position, grains.line[b].position, box));
      deepest = std::max(deepest, grains.line[a].radius + grains.line[b].radius - distance);
    }
  }
  return deepest;
}

inline void expect_position(const Vec<3>& a, const Vec<3>& b, double tolerance, std::size_t k = 0) {
  for (int i = 0; i < 3; ++i) ASSERT_NEAR(a[i], b[i], tolerance) << "sphere " << k << " axis " << i;
}

}  // namespace repose::testing
