// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One sphere after the other by the critical-angle rule, against closed forms.
#include "repose/core/numbers.hpp"
#include "repose/methods/deposition/deposition.hpp"
#include "repose/methods/deposition/spheres_columns.hpp"
#include "support/deposited_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace repose {
namespace {

using namespace testing;
using deposition::spheres::on_floor;
using Rest = deposition::spheres::Rest;

/// The end of one sphere of diameter 1 that drops at (x, y) on fixed ones.
Rest dropped(const std::vector<Grain<3>>& base, double x, double y, double angle_deg = 0.0,
             SphereDepositionSettings settings = {}) {
  settings.critical_angle_deg = angle_deg;
  settings.count = 1;
  Grains<3> grains;
  for (const auto& grain : base) grains.add(grain, static_cast<std::int64_t>(grains.size()), true);
  deposition::spheres::Columns columns(settings, grains);
  for (std::size_t k = 0; k < base.size(); ++k) columns.add(static_cast<std::int32_t>(k));
  return deposition::spheres::Roller(settings, columns).drop(x, y, 0.5);
}

// Three and four touching spheres, from all places above them: heights sqrt(2/3) and sqrt(1/2).
TEST(SphereDeposition, PocketOfThreeAndFour) {
  const double h = std::sqrt(3.0) / 2.0;
  const std::vector<Grain<3>> three{fixed_sphere({{0.0, 0.0, 0.0}}), fixed_sphere({{1.0, 0.0, 0.0}}),
                                    fixed_sphere({{0.5, h, 0.0}})};
  const std::vector<Grain<3>> four{fixed_sphere({{0.0, 0.0, 0.0}}), fixed_sphere({{1.0, 0.0, 0.0}}),
                                   fixed_sphere({{0.0, 1.0, 0.0}}), fixed_sphere({{1.0, 1.0, 0.0}})};
  for (int k = 0; k < 40; ++k) {
    const double u = 0.3 + 0.01 * k;
    const double v = 0.1 + 0.017 * k;
    const auto on_three = dropped(three, 0.2 + 0.6 * u, 0.1 + 0.4 * v);
    ASSERT_EQ(on_three.kind, Rest::Kind::rest);
    expect_position(on_three.position, {{0.5, h / 3.0, std::sqrt(2.0 / 3.0)}}, 1e-14);
    const auto on_four = dropped(four, u, v);
    ASSERT_EQ(on_four.kind, Rest::Kind::rest);
    expect_position(on_four.position, {{0.5, 0.5, std::sqrt(0.5)}}, 1e-14);
    for (const auto& rest : {on_three, on_four}) {
      EXPECT_TRUE(std::all_of(rest.supports.begin(), rest.supports.end(), [](auto number) { return number >= 0; }));
    }
  }
  // In the middle it lands on all at once.
  expect_position(dropped(three, 0.5, h / 3.0).position, {{0.5, h / 3.0, std::sqrt(2.0 / 3.0)}}, 1e-8);
  expect_position(dropped(four, 0.5, 0.5).position, {{0.5, 0.5, std::sqrt(0.5)}}, 1e-14);
}

// Balances that only rounding would end: exactly on top, and above the line of two.
TEST(SphereDeposition, UnstableBalancesEndInOneWay) {
  SphereDepositionSettings floor;
  floor.floor = -0.5;
  const auto top = dropped({fixed_sphere({{0.0, 0.0, 0.0}})}, 0.0, 0.0, 0.0, floor);
  expect_position(top.position, {{1.0, 0.0, 0.0}}, 1e-15);  // along +x, past the equator, straight down
  EXPECT_NE(std::find(top.supports.begin(), top.supports.end(), on_floor), top.supports.end());
  const std::vector<Grain<3>> two{fixed_sphere({{-0.5, 0.0, 0.0}}), fixed_sphere({{0.5, 0.0, 0.0}})};
  const auto saddle = dropped(two, 0.0, 0.0, 0.0, floor);
  expect_position(saddle.position, {{0.0, std::sqrt(3.0) / 2.0, 0.0}}, 1e-14);
  EXPECT_EQ(saddle.kind, Rest::Kind::rest);
  // At any critical angle above 0 they hold.
  EXPECT_EQ(dropped(two, 0.0, 0.0, 1e-3).position[2], std::sqrt(0.75));
  EXPECT_EQ(dropped({fixed_sphere({{0.0, 0.0, 0.0}})}, 0.0, 0.0, 1e-3).position[2], 1.0);
}

// On one support a sphere sticks by the angle of the contact. On two it sticks by the inclination of the circle: that
// angle times the cosine of the tilt of their line, in sines. Angles 1e-6 off the critical one lie on its two sides.
TEST(SphereDeposition, CriticalAngleOnOneAndOnTwo) {
  constexpr double critical = 35.0;
  constexpr double little = 1e-6;
  for (const double direction : {0.0, 1.0, 2.5, 4.0}) {
    for (const double off : {-little, little}) {
      const double aside = std::sin(radians(critical) + off);
      const auto rest = dropped({fixed_sphere({{0.0, 0.0, 0.0}})}, aside * std::cos(direction),
                                aside * std::sin(direction), critical);
      EXPECT_EQ(rest.kind, off < 0.0 ? Rest::Kind::rest : Rest::Kind::lost);
    }
  }
  for (const double tilt : {0.0, 0.2, 0.35}) {
    const Vec<3> line{{std::cos(tilt), 0.0, std::sin(tilt)}};
    for (const double off : {-little, little}) {
      // The place on the circle about the middle of two touching spheres at an angle from its top.
      const double sine = std::sin(radians(critical)) / std::cos(tilt) + off;
      const double cosine = std::sqrt(1.0 - sine * sine);
      const Vec<3> place = Vec<3>{{-line[2] * cosine, sine, line[0] * cosine}} * std::sqrt(0.75);
      const auto rest = dropped({fixed_sphere(line * -0.5), fixed_sphere(line * 0.5)}, place[0], place[1], critical);
      EXPECT_EQ(rest.kind, off < 0.0 ? Rest::Kind::rest : Rest::Kind::lost) << tilt;
      if (off > 0.0) continue;
      expect_position(rest.position, place, 1e-9);
      EXPECT_GE(rest.supports[1], 0);
    }
  }
}

/// Where a sphere of diameter 1 comes to rest, or to the floor, that creeps down in small steps, each pushed out of the
/// fixed spheres near it as little as possible.
Vec<3> crept(const std::vector<Grain<3>>& base, double x, double y, double floor) {
  constexpr double step = 2e-4;
  struct Push {
    Vec<3> normal;
    double gap;
    double size = 0.0;
  };
  Vec<3> place{{x, y, 2.6}};
  double since = place[2];
  for (int k = 1; place[2] > floor + 0.5; ++k) {
    std::vector<Push> near;
    for (const auto& grain : base) {
      const Vec<3> apart = place - grain.position;
      const double square = dot(apart, apart);
      if (square < 1.01) near.push_back({apart * (1.0 / std::sqrt(square)), std::sqrt(square) - 1.0});
    }
    Vec<3> move{{0.0, 0.0, -step}};
    double change = step;
    while (change > 1e-6 * step) {
      change = 0.0;
      for (auto& push : near) {
        const double size = std::max(0.0, push.size - (dot(push.normal, move) + push.gap));
        change = std::max(change, std::abs(size - push.size));
        move += push.normal * (size - push.size);
        push.size = size;
      }
    }
    place += move;
    if (k % 200 != 0) continue;
    if (since - place[2] < 1e-5 * 200 * step) break;
    since = place[2];
  }
  return place;
}

// The way over a disordered heap of fixed spheres is that of a sphere that creeps down in small steps. It ends in the
// same place within 0.005, some 25 steps. All 200 do; at the watershed between two ways a step may decide otherwise.
TEST(SphereDeposition, RollsAsItWouldCreep) {
  SphereDepositionSettings settings;
  settings.floor = -3.0;
  std::vector<Grain<3>> base;
  for (std::uint64_t k = 0; k < 14; ++k) {
    const auto place = [&](std::uint32_t axis) { return uniform(9, Purpose::release_position, k, axis) - 0.5; };
    base.push_back(fixed_sphere({{3.0 * place(0), 3.0 * place(1), 3.0 * place(2)}}));
  }
  int agree = 0;
  int lower = 0;
  constexpr int drops = 200;
  for (std::uint64_t k = 0; k < drops; ++k) {
    const double x = 3.0 * uniform(2, Purpose::release_position, k) - 1.5;
    const double y = 3.0 * uniform(2, Purpose::release_position, k, 1) - 1.5;
    const auto rest = dropped(base, x, y, 0.0, settings);
    ASSERT_EQ(rest.kind, Rest::Kind::rest);
    const Vec<3> off = rest.position - crept(base, x, y, settings.floor);
    agree += magnitude(off) < 0.005 ? 1 : 0;
    lower += magnitude(rest.position - Vec<3>{{x, y, rest.position[2]}}) > 0.1 ? 1 : 0;
  }
  EXPECT_GE(agree, drops - 2);
  EXPECT_GE(lower, drops / 2);  // they roll
}

// A sphere in a corner rests on two walls and one sphere: its place follows from the distances.
TEST(SphereDeposition, CornerOfTwoWalls) {
  auto settings = SpherePacker{.periodic = false}.settings();
  settings.floor = -2.0;
  const auto rest = dropped({fixed_sphere({{0.9, 0.8, 0.0}})}, 0.6, 0.55, 0.0, settings);
  expect_position(rest.position, {{0.5, 0.5, std::sqrt(1.0 - 0.16 - 0.09)}}, 1e-14);
  auto supports = rest.supports;
  std::sort(supports.begin(), supports.end());
  EXPECT_EQ(supports,
            (std::array<std::int32_t, 3>{deposition::spheres::on_wall(2), deposition::spheres::on_wall(0), 0}));
}

// A pocket of three across the corner of a periodic box holds a sphere dropped on either side of the edges.
TEST(SphereDeposition, PeriodicImages) {
  const auto settings = SpherePacker{.width = 6.0}.settings();
  const double h = std::sqrt(3.0) / 2.0;
  const std::vector<Grain<3>> three{fixed_sphere({{5.6, 5.7, 1.0}}), fixed_sphere({{0.6, 5.7, 1.0}}),
                                    fixed_sphere({{0.1, 5.7 + h - 6.0, 1.0}})};
  for (const double x : {5.85, 5.99, 0.01, 0.3}) {
    for (const double y : {5.9, 0.0, 0.1}) {
      const auto rest = dropped(three, x, y, 0.0, settings);
      ASSERT_EQ(rest.kind, Rest::Kind::rest);
      expect_position(settings.box.wrapped(rest.position), {{0.1, 5.7 + h / 3.0, 1.0 + std::sqrt(2.0 / 3.0)}}, 1e-14);
    }
  }
}

// Dropped over the disc that a sphere covers, first touches have uniform sin^2 of the contact angle: mean 1/2, and no
// part of the distribution is off by more than 1.63/sqrt(n) (Kolmogorov-Smirnov, 1 %).
TEST(SphereDeposition, FirstTouchesOnOneSphere) {
  SphereDepositionSettings settings;
  settings.critical_angle_deg = 90.0;
  settings.drop_radius = 1.0;
  settings.drop_centre = {2.0, -3.0};
  settings.count = 1;
  constexpr int n = 4000;
  std::vector<double> squares;
  Team team(1);
  for (int k = 0; k < n; ++k) {
    settings.draw = [k](std::int64_t, std::span<DroppedSphere> spheres) {
      const auto index = static_cast<std::uint64_t>(k);
      spheres[0] = {{uniform(3, Purpose::release_position, index), uniform(3, Purpose::release_position, index, 1)}};
      spheres[0].radius = 0.5;
      spheres[0].mass = 1.0;
    };
    Grains<3> grains;
    grains.add(fixed_sphere({{2.0, -3.0, 1.0}}), 0, true);
    const auto method = make_sphere_deposition(settings);
    method->grains_added(grains);
    ASSERT_FALSE(method->advance(grains, 1.0, team).trouble);
    ASSERT_EQ(grains.size(), 2U);
    const Vec<3> n_contact = grains.line[1].position - grains.line[0].position;
    EXPECT_NEAR(magnitude(n_contact), 1.0, 1e-14);
    squares.push_back(1.0 - n_contact[2] * n_contact[2]);
  }
  std::sort(squares.begin(), squares.end());
  double off = 0.0;
  for (int k = 0; k < n; ++k) off = std::max(off, std::abs(squares[static_cast<std::size_t>(k)] - (k + 0.5) / n));
  EXPECT_LT(off, 1.63 / std::sqrt(n));
  EXPECT_GT(off, 1e-4);  // of random numbers, not of a lattice
}

// Between walls one diameter apart spheres move as discs do, and land where the method for discs puts them. Rounding
// grows about threefold a layer, from 1e-16, over some 10 layers at 0 degrees.
TEST(SphereDeposition, SlotOfOneDiameterHoldsDiscs) {
  for (const double angle : {0.0, 20.0, 50.0, 70.0, 90.0}) {
    for (const bool periodic : {true, false}) {
      const SpherePacker packer{.width = 17.3, .count = 200, .angle_deg = angle, .seed = 5};
      auto settings = packer.settings();
      settings.box.periodic = periodic;
      settings.box.periodic_y = false;
      settings.box.y_max = 1.0;
      Grains<3> spheres;
      const auto method = make_sphere_deposition(settings);
      method->grains_added(spheres);
      Team team(1);
      ASSERT_FALSE(method->advance(spheres, 1e9, team).trouble);

      DepositionSettings flat;
      flat.critical_angle_deg = angle;
      flat.box.periodic = periodic;
      flat.box.x_min = 0.0;
      flat.box.x_max = 17.3;
      flat.floor = 0.0;
      flat.count = packer.count;
      flat.draw = [](std::int64_t k, std::span<DroppedDisc> discs) {
        for (auto& disc : discs) {
          disc = {uniform(5, Purpose::release_position, static_cast<std::uint64_t>(k++)), 0.5, 1.0};
        }
      };
      Grains<2> discs;
      const auto flat_method = make_deposition(flat);
      flat_method->grains_added(discs);
      ASSERT_FALSE(flat_method->advance(discs, 1e9, team).trouble);
      ASSERT_EQ(discs.size(), spheres.size());
      for (std::size_t k = 0; k < discs.size(); ++k) {
        const auto& disc = discs.line[k].position;
        expect_position(spheres.line[k].position, {{disc[0], 0.5, disc[1]}}, 1e-9, k);
      }
    }
  }
}

// Dropped on one spot over a square base, spheres meet many supports at once, and roll on circles that a third one
// touches all along. They spread over the floor around the base without overlap.
TEST(SphereDeposition, DroppedOnOneSpot) {
  SphereDepositionSettings settings = SpherePacker{.count = 2500}.settings();
  settings.box = {};
  settings.floor = -0.5;
  settings.drop_radius = 0.0;
  settings.drop_centre = {5.5, 5.5};
  auto grains = square_base(11);
  const auto method = make_sphere_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  ASSERT_FALSE(method->advance(grains, 1e9, team).trouble);
  EXPECT_EQ(grains.size(), 121U + 2500U);
  EXPECT_LT(deepest_overlap(grains, settings.box), 1e-11);
}

// A pile on a round base without a floor: what rolls off is lost and counted.
TEST(SphereDeposition, OpenPile) {
  SphereDepositionSettings settings = SpherePacker{.count = 3000}.settings();
  settings.critical_angle_deg = 10.0;
  settings.box = {};
  settings.floor = -std::numeric_limits<double>::infinity();
  settings.drop_radius = 2.0;
  Grains<3> grains;
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      if (i * i + j * j <= 64)
        grains.add(fixed_sphere({{1.0 * i, 1.0 * j, 0.0}}), static_cast<std::int64_t>(grains.size()), true);
    }
  }
  const auto base = grains.size();
  const auto method = make_sphere_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  ASSERT_FALSE(method->advance(grains, 1e9, team).trouble);
  EXPECT_TRUE(method->complete());
  EXPECT_EQ(method->made(), 3000);
  EXPECT_LT(grains.size() - base, 3000U);
  EXPECT_GT(grains.size() - base, 500U);
  for (std::size_t k = base; k < grains.size(); ++k) {
    EXPECT_GT(grains.line[k].position[2], 0.0);
    EXPECT_LT(std::hypot(grains.line[k].position[0], grains.line[k].position[1]), 9.0);
  }
}

// Without a floor or a base a periodic box loses no sphere: that is trouble, not an endless loop.
TEST(SphereDeposition, FallWithoutEndIsTrouble) {
  auto settings = SpherePacker{}.settings();
  settings.floor = -std::numeric_limits<double>::infinity();
  Grains<3> grains;
  const auto method = make_sphere_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  const auto report = method->advance(grains, 1.0, team);
  EXPECT_TRUE(report.trouble);
  EXPECT_EQ(report.steps, 0);
}

}  // namespace
}  // namespace repose
