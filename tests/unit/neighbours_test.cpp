// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/neighbours/near_pairs.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace repose {
namespace {

using IdPair = std::pair<std::int64_t, std::int64_t>;

template <int D>
Grains<D> random_grains(std::uint64_t seed, int count, double width, double largest_speed, int large = 0) {
  Grains<D> grains;
  for (int k = 0; k < count; ++k) {
    const auto number = [&](std::uint32_t draw) {
      return uniform(seed, Purpose::release_position, static_cast<std::uint64_t>(k), draw);
    };
    Grain<D> grain;
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::uint32_t>(axis);
      grain.position[axis] = width * (number(a) - 0.5);
      grain.velocity[axis] = largest_speed * std::pow(2.0 * number(10 + a) - 1.0, 9);  // a few fast, many slow
    }
    grain.radius = k < large ? 0.5 + 6.0 * number(22) : 0.3 + 0.2 * number(20);
    grain.mass = 1.0;
    grain.inverse_mass = number(21) < 0.1 ? 0.0 : 1.0;
    if (grain.fixed()) grain.velocity = {};
    grains.add(grain, k);
  }
  return grains;
}

template <int D>
std::set<IdPair> touching(const Grains<D>& grains, const Box<D>& box, double cutoff) {
  std::set<IdPair> pairs;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    for (std::size_t j = i + 1; j < grains.size(); ++j) {
      if (grains.line[i].fixed() && grains.line[j].fixed()) continue;
      const auto d = separation(grains.line[i].position, grains.line[j].position, box);
      if (magnitude(d) < cutoff * (grains.line[i].radius + grains.line[j].radius)) {
        pairs.insert(std::minmax(grains.id[i], grains.id[j]));
      }
    }
  }
  return pairs;
}

template <int D>
std::set<IdPair> listed(const Grains<D>& grains, const PairList<D>& pairs) {
  std::set<IdPair> found;
  for (std::uint32_t i = 0; i < pairs.rows(); ++i) {
    for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) {
      EXPECT_GT(pairs.partner[k], i);
      EXPECT_TRUE(k == pairs.row_start[i] || pairs.partner[k] > pairs.partner[k - 1]) << "not ascending";
      EXPECT_TRUE(found.insert(std::minmax(grains.id[i], grains.id[pairs.partner[k]])).second) << "listed twice";
    }
  }
  return found;
}

template <int D>
void move(Grains<D>& grains, double dt) {
  for (auto& grain : grains.line) grain.position += grain.velocity * dt;
}

/// The axes along which a box is periodic; y in 3D alone.
struct Wraps {
  bool x = false;
  bool y = false;
};

Wraps any_wraps() { return {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()}; }

/// A box about the origin, endless along the axes that do not wrap. Its depth is a little less than its width.
template <int D>
Box<D> box_of(double width, const Wraps& wraps) {
  const auto half = [](bool periodic, double length) { return periodic ? 0.5 * length : 1e9; };
  Box<D> box;
  box.periodic = wraps.x;
  box.x_max = half(wraps.x, width);
  box.x_min = -box.x_max;
  if constexpr (D == 3) {
    box.periodic_y = wraps.y;
    box.y_max = half(wraps.y, 0.9 * width);
    box.y_min = -box.y_max;
  }
  return box;
}

/// Moves grains uniformly, rebuilds the list by its own rules, and compares it with brute force at every step.
template <int D>
void check_against_brute_force(std::uint64_t seed, int count, double width, const Wraps& wraps, double horizon,
                               int large = 0) {
  const auto box = box_of<D>(width, wraps);
  const double cutoff = 1.2;
  const double dt = 0.01;
  Grains<D> grains = random_grains<D>(seed, count, width, 12.0, large);
  PairList<D> pairs({.cutoff = cutoff, .skin = 0.3, .horizon = horizon, .gravity = 0.0});
  Team team(2);
  for (int step = 0; step < 40; ++step) {
    if (pairs.may_be_stale() && pairs.stale(grains)) pairs.build(grains, box, team);
    const auto all = listed(grains, pairs);
    for (const auto& pair : touching(grains, box, cutoff)) {
      ASSERT_TRUE(all.contains(pair)) << "pair " << pair.first << ", " << pair.second << " missed in step " << step;
    }
    double fastest = 0.0;
    for (const auto& grain : grains.line) fastest = std::max(fastest, magnitude(grain.velocity));
    move(grains, dt);
    pairs.moved(dt * fastest);
  }
}

RC_GTEST_PROP(PairListProperty, MissesNoPair2D, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto wraps = any_wraps();
  const auto count = *rc::gen::inRange(1, 150);
  const auto width = *rc::gen::element(4.0, 7.0, 12.0, 30.0);
  check_against_brute_force<2>(seed, count, width, wraps, *rc::gen::element(0.0, 0.1, 1.0));
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(PairListProperty, MissesNoPair3D, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto count = *rc::gen::inRange(1, 150);
  const auto width = *rc::gen::element(4.0, 7.0, 12.0);
  check_against_brute_force<3>(seed, count, width, any_wraps(), *rc::gen::element(0.0, 0.1));
  RC_ASSERT(!::testing::Test::HasFailure());
}

// A few large grains are searched for apart from the cells, which are as small as most grains.
RC_GTEST_PROP(PairListProperty, MissesNoPairOfLargeGrains, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto wraps = any_wraps();
  const auto count = *rc::gen::inRange(20, 150);
  const auto large = *rc::gen::inRange(1, 12);
  const auto width = *rc::gen::element(20.0, 40.0);
  const auto horizon = *rc::gen::element(0.0, 0.1);
  check_against_brute_force<2>(seed, count, width, wraps, horizon, large);
  check_against_brute_force<3>(seed, count, width, wraps, horizon, large);
  RC_ASSERT(!::testing::Test::HasFailure());
}

// The search for pairs among places visits every pair in reach once, across the periodic boundaries too; boxes are as
// narrow as one, two and three cells.
template <int D>
void check_near_pairs(double width, const Wraps& wraps) {
  const double reach = 0.9;
  const auto box = box_of<D>(width, wraps);
  std::vector<Vec<D>> places;
  for (const auto& grain : random_grains<D>(3, 250, 4.0, 0.0).line) places.push_back(box.wrapped(grain.position));
  std::map<IdPair, int> visits;
  for_near_pairs(places, box, reach, [&](std::uint32_t i, std::uint32_t j) { ++visits[std::minmax(i, j)]; });
  int near = 0;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    EXPECT_FALSE(visits.contains({i, i}));
    for (std::uint32_t j = i + 1; j < places.size(); ++j) {
      const auto found = visits.find({i, j});
      EXPECT_LE(found == visits.end() ? 0 : found->second, 1);
      if (magnitude(separation(places[i], places[j], box)) >= reach) continue;
      ++near;
      EXPECT_TRUE(found != visits.end()) << i << ", " << j;
    }
  }
  EXPECT_GT(near, 200);
}

TEST(NearPairs, VisitEveryPairOnce) {
  for (const double width : {1.7, 2.1, 3.0, 4.0}) {
    for (const auto& wraps : {Wraps{false, false}, Wraps{true, false}, Wraps{false, true}, Wraps{true, true}}) {
      check_near_pairs<2>(width, wraps);
      check_near_pairs<3>(width, wraps);
    }
  }
}

// Slip displacements stay with their pair through any reordering. In 3D the vector changes sign if the pair is stored
// in the other order.
template <int D>
void check_slip() {
  const Box<D> box;
  Grains<D> grains = random_grains<D>(5, 200, 8.0, 12.0);
  PairList<D> pairs({.cutoff = 1.2, .skin = 0.3, .horizon = 0.1, .gravity = 0.0});
  Team team(1);
  pairs.build(grains, box, team);
  std::map<IdPair, Tangent<D>> by_pair;
  for (std::uint32_t i = 0; i < pairs.rows(); ++i) {
    for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) {
      const auto a = grains.id[i];
      const auto b = grains.id[pairs.partner[k]];
      Tangent<D> mark{};
      if constexpr (D == 2) {
        mark = static_cast<double>(k + 1);
      } else {
        mark = {{static_cast<double>(k + 1), 1.0, -2.0}};
      }
      pairs.slip[k] = mark;
      by_pair[{std::min(a, b), std::max(a, b)}] = a < b ? mark : swapped(mark);
    }
  }
  std::size_t compared = 0;
  std::size_t swaps = 0;
  for (int round = 0; round < 5; ++round) {
    move(grains, 0.02);
    pairs.build(grains, box, team);
    std::map<IdPair, Tangent<D>> now;
    for (std::uint32_t i = 0; i < pairs.rows(); ++i) {
      for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) {
        const auto a = grains.id[i];
        const auto b = grains.id[pairs.partner[k]];
        swaps += a > b ? 1 : 0;
        const IdPair pair{std::min(a, b), std::max(a, b)};
        now[pair] = a < b ? pairs.slip[k] : swapped(pairs.slip[k]);
        const auto before = by_pair.find(pair);
        EXPECT_EQ(now[pair], before != by_pair.end() ? before->second : Tangent<D>{});
        ++compared;
      }
    }
    by_pair = now;
  }
  EXPECT_GT(compared, 500U);
  EXPECT_GT(swaps, 50U);
}

TEST(PairList, KeepsSlipDisplacements2D) { check_slip<2>(); }
TEST(PairList, KeepsSlipDisplacements3D) { check_slip<3>(); }

// A grain that falls freely past a settled heap causes almost no builds, because its larger allowance covers its path.
TEST(PairList, FreeFlightForcesNoRebuild) {
  const auto builds = [](double horizon) {
    Grains<2> grains;
    for (int k = 0; k < 400; ++k) {
      Grain<2> grain;
      grain.position = {{static_cast<double>(k % 40), static_cast<double>(k / 40)}};
      grain.radius = 0.5;
      grain.mass = grain.inverse_mass = 1.0;
      grains.add(grain, k);
    }
    Grain<2> falling = grains.line[0];
    falling.position = {{20.0, 100.0}};
    grains.add(falling, 400);
    PairList<2> pairs({.cutoff = 1.2, .skin = 0.3, .horizon = horizon, .gravity = 1.0});
    Team team(1);
    const double dt = 0.001;
    for (int step = 0; step < 12000; ++step) {
      if (pairs.may_be_stale() && pairs.stale(grains)) pairs.build(grains, Box<2>{}, team);
      for (auto& grain : grains.line) {
        if (grain.position[1] < 50.0) continue;
        grain.velocity[1] -= dt;
        grain.position[1] += grain.velocity[1] * dt;
        pairs.moved(dt * magnitude(grain.velocity));
      }
    }
    return pairs.builds();
  };
  EXPECT_GT(builds(0.0), 250);
  EXPECT_LT(builds(0.256), 60);
}

TEST(PairList, DropsGrainsThatLeft) {
  Grains<2> grains = random_grains<2>(1, 50, 10.0, 0.0);
  Box<2> box;
  box.floor = 0.0;
  std::size_t inside = 0;
  for (const auto& grain : grains.line) inside += grain.fixed() || grain.position[1] >= 0.0 ? 1 : 0;
  ASSERT_LT(inside, 50U);
  PairList<2> pairs({.cutoff = 1.2, .skin = 0.3, .horizon = 0.0, .gravity = 0.0});
  Team team(1);
  pairs.build(grains, box, team);
  EXPECT_EQ(grains.size(), inside);
  EXPECT_EQ(pairs.rows(), inside);
}

}  // namespace
}  // namespace repose
