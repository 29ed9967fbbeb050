// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Impacts of rigid grains: the kinetic energy never rises, and a bounce does not depend on the time step.
#include "repose/core/random.hpp"
#include "support/rigid_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

using testing::infinity;
using testing::open_box;
using testing::plane;
using testing::rigid_2d;
using testing::RigidWorld;

constexpr double degree = std::numbers::pi / 180.0;

/// The largest rise of the kinetic energy in a step, over the kinetic energy at the start.
template <int D>
double largest_rise(RigidWorld<D>& world, long steps) {
  const double start = kinetic_energy(world.grains);
  double before = start;
  double worst = -start;
  for (long k = 0; k < steps; ++k) {
    world.advance(1);
    const double now = kinetic_energy(world.grains);
    worst = std::max(worst, now - before);
    before = now;
  }
  return worst / start;
}

// A disc is shot into a wedge of two planes, without gravity; in many of these wedges friction jams it.
TEST(RigidImpact, WedgesOfPlanesAddNoEnergy) {
  long reduced = 0;
  for (int half_angle = 15; half_angle <= 75; half_angle += 5) {
    for (const double friction : {0.1, 0.35, 0.5, 1.0, 2.0, 5.0}) {
      for (const double restitution : {0.05, 0.3, 0.5, 0.9, 1.0}) {
        for (const double spin : {-3.0, 0.0, 3.0}) {
          ImpulseLaw law;
          law.friction = friction;
          law.restitution = restitution;
          auto settings = rigid_2d(0.01, 0.0);
          const double angle = half_angle * degree;
          settings.walls = {plane({{0.0, 0.0}}, {{std::cos(angle), std::sin(angle)}}),
                            plane({{0.0, 0.0}}, {{-std::cos(angle), std::sin(angle)}})};
          RigidWorld<2> world(law, settings);
          world.add({{0.0, 0.5 / std::sin(angle) + 0.1}}, {{0.01 * spin, -2.0}}, spin);
          EXPECT_LE(largest_rise(world, 40), 1e-9)
              << half_angle << " deg, friction " << friction << ", restitution " << restitution << ", spin " << spin;
          reduced += world.method.account().reduced;
        }
      }
    }
  }
  EXPECT_GT(reduced, 100);
}

// A disc falls between two fixed discs. Kinetic and potential energy never exceed those of the start.
TEST(RigidImpact, NotchesAddNoEnergy) {
  for (const double half : {0.55, 0.75, 0.95}) {
    for (const double friction : {0.1, 0.35, 1.0, 5.0}) {
      for (const double restitution : {0.1, 0.5, 0.9}) {
        for (const double step : {1e-3, 0.01, 0.1}) {
          ImpulseLaw law;
          law.friction = friction;
          law.restitution = restitution;
          RigidWorld<2> world(law, rigid_2d(step, 1.0));
          world.add({{-half, 0.0}}, {}, 0.0, 0.5, true);
          world.add({{half, 0.0}}, {}, 0.0, 0.5, true);
          const auto disc = world.add({{0.01, 3.0}});
          double most = 0.0;
          for (long k = 0; k < std::lround(5.0 / step); ++k) {
            world.advance(1);
            // Velocities are half a step before the positions.
            auto grains = world.grains;
            for (auto& g : grains.line) g.velocity[1] -= g.fixed() ? 0.0 : 0.5 * step;
            most = std::max(most, (kinetic_energy(grains) + world[disc].position[1]) / 3.0);
          }
          EXPECT_LE(most, 1.0 + 1e-9) << half << ", " << friction << ", " << restitution << ", " << step;
        }
      }
    }
  }
}

// The wedge of the report: no admissible impulse lifts the disc (2R (0.312 - 0.95 mu) < 0), so it stops there, and the
// lost restitution is counted.
TEST(RigidImpact, AJammingNotchStopsTheDisc) {
  ImpulseLaw law;
  law.friction = 0.35;
  law.restitution = 0.9;
  RigidWorld<2> world(law, rigid_2d(0.01, 1.0));
  world.add({{-0.95, 0.0}}, {}, 0.0, 0.5, true);
  world.add({{0.95, 0.0}}, {}, 0.0, 0.5, true);
  const auto disc = world.add({{0.0, 3.0}});
  world.advance(2000);
  EXPECT_NEAR(world[disc].position[1], std::sqrt(1.0 - 0.95 * 0.95), 2e-3);
  EXPECT_NEAR(kinetic_energy(world.grains), 0.0, 1e-8);
  EXPECT_GE(world.method.account().reduced, 2);
  EXPECT_NEAR(world.method.account().restitution_lost, static_cast<double>(world.method.account().reduced), 1e-12);
}

// A gas of rough discs of two materials in a box, without gravity. In some clusters restitution gives way by a
// fraction: the sum of what is lost is then no whole number of contacts.
TEST(RigidImpact, DenseBedsAddNoEnergy) {
  int by_a_fraction = 0;
  for (const double friction : {0.3, 1.0, 5.0}) {
    for (const double restitution : {0.1, 0.7, 1.0}) {
      ImpulseLaw soft, hard;
      soft.friction = hard.friction = friction;
      soft.restitution = 0.2 * restitution;
      hard.restitution = restitution;
      auto settings = rigid_2d(0.005, 0.0);
      settings.walls = open_box(8.0);
      RigidWorld<2> world(ImpulseLaws({hard, soft, soft, hard}, 2), settings);
      for (int k = 0; k < 64; ++k) {
        const double u = uniform(7, Purpose::release_position, static_cast<std::uint64_t>(k), 0);
        const double v = uniform(7, Purpose::release_position, static_cast<std::uint64_t>(k), 1);
        world.add({{0.52 + (k % 8) * 0.99, 0.52 + (k / 8) * 1.002}}, {{4.0 * u - 2.0, 4.0 * v - 2.0}}, 4.0 * (u - v));
        world.grains.material.back() = static_cast<std::uint16_t>(k % 2);
      }
      EXPECT_LE(largest_rise(world, 100), 1e-9) << friction << ", " << restitution;
      const double lost = world.method.account().restitution_lost;
      by_a_fraction += std::fabs(lost - std::round(lost)) > 1e-6 ? 1 : 0;
    }
  }
  EXPECT_GT(by_a_fraction, 0);
}

// Spheres: a pocket of three fixed spheres far apart.
TEST(RigidImpact, PocketsOfSpheresAddNoEnergy) {
  for (const double apart : {0.6, 0.8, 0.95}) {
    for (const double friction : {0.1, 0.5, 2.0}) {
      for (const double restitution : {0.3, 0.9, 1.0}) {
        ImpulseLaw law;
        law.friction = friction;
        law.restitution = restitution;
        ContactDynamicsSettings<3> settings;
        settings.time_step = 0.01;
        RigidWorld<3> world(law, settings);
        for (int k = 0; k < 3; ++k) {
          const double angle = 120.0 * k * degree;
          world.add({{apart * std::cos(angle), apart * std::sin(angle), 0.0}}, {}, {}, 0.5, true);
        }
        world.add({{0.0, 0.0, std::sqrt(1.0 - apart * apart) + 0.1}}, {{0.05, 0.0, -2.0}}, Vec<3>{{1.0, 2.0, 3.0}});
        EXPECT_LE(largest_rise(world, 30), 1e-9) << apart << ", " << friction << ", " << restitution;
      }
    }
  }
}

// A bounce returns to e^2 of the height at any time step. The bound is 2 %; in free flight the scheme has no error.
TEST(RigidImpact, ABounceReturnsToItsHeightAtAnyStep) {
  for (const double step : {0.01, 0.05, 0.1, 0.15, 0.2}) {
    for (const double restitution : {0.3, 0.5, 0.8, 1.0}) {
      for (const double above : {0.9, 1.0, 1.07, 1.3}) {
        ImpulseLaw law;
        law.restitution = restitution;
        auto settings = rigid_2d(step, 1.0);
        settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
        RigidWorld<2> world(law, settings);
        const auto disc = world.add({{0.0, 0.5 + above}});
        while (world[disc].velocity[1] <= 0.0) world.advance(1);
        // The height of the path through the present state: velocities are half a step before the positions.
        const double speed = world[disc].velocity[1] - 0.5 * step;
        const double height = world[disc].position[1] - 0.5 + 0.5 * speed * speed;
        EXPECT_NEAR(height / above, restitution * restitution, 1e-9)
            << "step " << step << ", restitution " << restitution << ", from " << above;
      }
    }
  }
}

}  // namespace
}  // namespace repose
