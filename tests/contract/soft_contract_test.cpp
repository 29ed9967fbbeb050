// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/every_law.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

// Contracts of the soft method with any law, in 2D and 3D.

namespace repose {
namespace {

using testing::for_every_pair_law;
using testing::settings_2d;
using testing::SoftWorld;

template <int D>
SoftSettings<D> isolated(double time_step) {
  SoftSettings<D> settings;
  settings.time_step = time_step;
  return settings;
}

double angular(const Grain<2>& g) {
  return g.mass * (g.position[0] * g.velocity[1] - g.position[1] * g.velocity[0]) +
         0.5 * g.mass * g.radius * g.rim_velocity;
}
Vec<3> angular(const Grain<3>& g) {
  return cross(g.position, g.velocity) * g.mass + g.rim_velocity * (0.4 * g.mass * g.radius);
}

// Momentum and angular momentum of an isolated cluster are conserved to rounding: 3000 steps with forces of order 10
// change them by less than 1e-12.
template <int D, class Law>
void check_momenta(const Law& law) {
  SoftWorld<D, std::decay_t<decltype(law)>> world(law, isolated<D>(1e-3));
  const auto at = [](double x, double y) {
    Vec<D> v;
    v[0] = x;
    v[1] = y;
    if constexpr (D == 3) v[2] = 0.3 * x - 0.2 * y;
    return v;
  };
  const auto spin = [](double w) {
    if constexpr (D == 2) {
      return w;
    } else {
      return Vec<3>{{0.3 * w, -0.2 * w, w}};
    }
  };
  world.add(at(0.0, 0.0), at(0.3, 0.1), spin(1.0), 0.5);
  world.add(at(0.95, 0.1), at(-0.5, 0.2), spin(-2.0), 0.5);
  world.add(at(0.4, 0.75), at(0.0, -0.6), spin(0.5), 0.35);
  world.add(at(-0.35, 0.75), at(0.7, -0.9), spin(3.0), 0.3);
  Vec<D> momentum;
  auto spin_sum = decltype(angular(world.grains.line[0])){};
  for (const auto& g : world.grains.line) {
    momentum += g.velocity * g.mass;
    spin_sum += angular(g);
  }
  world.advance(3000);
  for (const auto& g : world.grains.line) {
    momentum -= g.velocity * g.mass;
    spin_sum -= angular(g);
  }
  EXPECT_LT(magnitude(momentum), 1e-12);
  EXPECT_LT(magnitude(spin_sum), 1e-12);
}

TEST(SoftContract, KeepsMomenta2D) {
  testing::for_all_laws([](const auto& law) { check_momenta<2>(law); });
}
// In 3D each law is tried about once.
TEST(SoftContract, KeepsMomenta3D) {
  check_momenta<3>(PairLaw{Continuous::make(36, 1.2, 0.5, 1.0), Cumulative{0.5, 1.214}});
  check_momenta<3>(any_pair_law({Hooke{2e4, 0.3}, Linear{0.5, 6e3, 0.1}, {}, {}}));
  check_momenta<3>(
      any_pair_law({Hertz{1e5, 0.3}, Mindlin{0.5, 0.8, 0.1}, RollingSpring{0.1, 500.0, 0.3}, ConstantCohesion{0.4}}));
}

// A sphere on a sphere rests at the height of a disc on a disc. On a wall a sliding sphere ends rolling at 5/7 of its
// speed.
TEST(SoftContract, SpheresInThreeDimensions) {
  auto settings = isolated<3>(1e-3);
  settings.gravity = {{0.0, 0.0, -1.0}};
  const PairLaw law{Continuous::make(36, 1.2, 0.5, 1.0), Cumulative{}};
  SoftWorld<3, PairLaw<Continuous, Cumulative>> stack(law, settings);
  stack.add({{0.0, 0.0, 0.0}}, {}, {}, 0.5, true);
  const auto top = stack.add({{0.0, 0.0, 1.001}});
  stack.advance(60000);
  EXPECT_NEAR(stack[top].position[2], 1.0, 1e-9);

  settings.walls = {Wall<3>{.point = {{0.0, 0.0, 0.0}}, .normal = {{0.0, 0.0, 1.0}}}};
  SoftWorld<3, PairLaw<Continuous, Cumulative>> floor(law, settings);
  const auto slider = floor.add({{0.0, 0.0, 0.5}}, {{0.6, 0.8, 0.0}});
  floor.advance(40000);
  EXPECT_NEAR(magnitude(floor[slider].velocity), 5.0 / 7.0, 1e-3);
  EXPECT_NEAR(floor[slider].velocity[0] / floor[slider].velocity[1], 0.75, 1e-3);
}

// Two materials: the law of each pair is taken from the table.
TEST(SoftContract, LawsByMaterial) {
  SoftSettings<2> settings;
  settings.time_step = 1e-3;
  settings.gravity = {{0.0, -1.0}};
  using Law = PairLaw<Hooke, Cumulative>;
  const Law soft_soft{Hooke{500.0, 0.5}, {}};
  const Law soft_hard{Hooke{1000.0, 0.5}, {}};
  const Law hard_hard{Hooke{4000.0, 0.5}, {}};
  SoftWorld<2, Law> world(MaterialTable<Law>({soft_soft, soft_hard, soft_hard, hard_hard}, 2), settings);
  world.add({{0.0, 0.0}}, {}, 0.0, 0.5, true, 0);
  world.add({{5.0, 0.0}}, {}, 0.0, 0.5, true, 1);
  const auto on_soft = world.add({{0.0, 1.0}}, {}, 0.0, 0.5, false, 1);
  const auto on_hard = world.add({{5.0, 1.0}}, {}, 0.0, 0.5, false, 1);
  world.advance(40000);
  EXPECT_NEAR(world[on_soft].position[1], 1.0 - 1.0 / 1000.0, 1e-9);
  EXPECT_NEAR(world[on_hard].position[1], 1.0 - 1.0 / 4000.0, 1e-9);
}

// In a periodic box a pair across the boundary moves like the same pair in the middle. The shift changes positions by
// rounding, 1e-15, which the steep start of the tangential dashpot amplifies, but to less than a millionth.
TEST(SoftContract, PeriodicPairIsAnyOtherPair) {
  const auto run = [](double shift) {
    auto settings = isolated<2>(1e-3);
    settings.box.periodic = true;
    settings.box.x_min = -5.0;
    settings.box.x_max = 5.0;
    SoftWorld<2, PairLaw<Continuous, Cumulative>> world({Continuous::make(36, 1.2, 0.5, 1.0), {}}, settings);
    world.add({{shift - 0.6, 0.0}}, {{1.0, 0.0}}, 2.0);
    world.add({{shift + 0.6, 0.3}}, {{-1.0, 0.0}}, 1.0);
    world.advance(2000);
    return std::array<double, 4>{world[0].velocity[0], world[0].velocity[1], world[0].rim_velocity,
                                 world[1].velocity[1]};
  };
  const auto middle = run(0.0);
  const auto across = run(5.0);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(across[k], middle[k], 1e-7);
  EXPECT_LT(middle[0], 0.5);  // they have collided
}

TEST(SoftContract, TooFastGrainsAreReported) {
  SoftWorld<2, PairLaw<Hooke, Cumulative>> world({Hooke{1e9, 0.5}, {}}, isolated<2>(1e-2));
  world.add({{0.0, 0.0}});
  world.add({{0.3, 0.0}});
  const auto report = world.advance(100);
  EXPECT_TRUE(report.trouble);
  EXPECT_LT(report.steps, 5);
  SoftWorld<2, PairLaw<Hooke, Cumulative>> nan({Hooke{1e3, 0.5}, {}}, isolated<2>(1e-2));
  nan.add({{0.0, 0.0}});
  nan.add({{0.0, 0.0}});  // same place: the normal is not a number
  EXPECT_TRUE(nan.advance(10).trouble);
}

// A disc thrown at a fixed one at any angle, grazing included, gains no energy. The tolerance of 1e-5 is that of the
// integration (5e-6 for an undamped impact at this step).
TEST(SoftContract, NoEnergyFromAnImpactAtAnyAngle) {
  for_every_pair_law([](const auto& law) {
    for (int degrees = 0; degrees < 90; degrees += 3) {
      for (const double spin : {0.0, 4.0}) {
        SoftWorld<2, std::decay_t<decltype(law)>> world(law, settings_2d(2e-4, 0.0));
        world.add({{0.0, 0.0}}, {}, 0.0, 0.5, true);
        const double side = 1.2 * std::sin(degrees * std::numbers::pi / 180.0);
        const auto disc = world.add({{side, 1.3}}, {{0.0, -3.0}}, spin);
        const double before = kinetic_energy(world.grains);
        for (int step = 0; step < 10000 && (step < 2000 || !world.contacts().list.empty()); step += 50) {
          world.advance(50);
        }
        EXPECT_LE(kinetic_energy(world.grains), before * (1.0 + 1e-5)) << degrees << " deg, spin " << spin;
        EXPECT_GT(magnitude(world[disc].position), 0.9);
      }
    }
  });
}

}  // namespace
}  // namespace repose
