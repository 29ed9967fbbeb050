// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/neighbours/pair_list.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

// The results are the same to the bit for any number of threads.

namespace repose {
namespace {

using testing::SoftWorld;

/// The state, by id, of grains in a box after some time. They collapse, and some are fast.
template <int D, class Law>
std::vector<double> crowd(const Law& law, int threads, bool periodic, bool synchronised) {
  SoftSettings<D> settings;
  settings.time_step = 1e-3;
  settings.gravity[up<D>] = -1.0;
  settings.synchronised = synchronised;
  settings.box.periodic = periodic;
  settings.box.x_min = -8.0;
  settings.box.x_max = 8.0;
  Vec<D> floor_normal;
  floor_normal[up<D>] = 1.0;
  Vec<D> along;
  along[0] = 1.0;
  Vec<D> shelf;
  shelf[up<D>] = 5.3;
  Vec<D> lid;
  lid[up<D>] = 30.0;
  settings.walls = {Wall<D>{.point = {}, .normal = floor_normal},
                    Wall<D>{.point = shelf, .normal = floor_normal, .half_length = 3.0, .opens_at = 1.2},
                    Wall<D>{.point = lid, .normal = -floor_normal}};
  settings.walls[1].motion = {.kind = WallMotion<D>::Kind::velocity, .direction = along, .speed = 0.4};
  settings.walls[2].motion = {
      .kind = WallMotion<D>::Kind::spring, .direction = -floor_normal, .speed = 9.0, .stiffness = 60.0, .mass = 20.0};
  settings.audit = std::is_same_v<Law, AnyPairLaw>;
  SoftWorld<D, Law> world(law, settings, threads);
  const int count = 300;
  for (int k = 0; k < count; ++k) {
    const auto number = [&](std::uint32_t draw) {
      return uniform(1, Purpose::release_position, static_cast<std::uint64_t>(k), draw);
    };
    Vec<D> position;
    Vec<D> velocity;
    position[0] = (k % 15) - 7.0 + 0.1 * number(0);
    position[up<D>] = 0.7 + 1.05 * (k / 15) + 0.1 * number(1);
    velocity[0] = 2.0 * number(2) - 1.0;
    velocity[up<D>] = k % 37 == 0 ? -10.0 : 0.0;
    world.add(position, velocity, {}, 0.35 + 0.15 * number(3), k < 5);
  }
  world.set_loads({{40, floor_normal * 2.0}, {41, along * -3.0}});
  world.advance(1500);
  std::vector<double> state;
  for (const auto& wall : world.method().walls()) {
    state.push_back(wall.displacement);
    state.push_back(wall.speed);
  }
  for (const auto& impulse : world.take_wall_impulses()) state.push_back(impulse[up<D>]);
  for (const auto k : by_id(world.grains)) {
    const auto& grain = world.grains.line[k];
    for (int axis = 0; axis < D; ++axis) {
      state.push_back(grain.position[axis]);
      state.push_back(grain.velocity[axis]);
      state.push_back(world.grains.reaction[k][axis]);
    }
    state.push_back(magnitude(grain.rim_velocity));
  }
  for (const auto& contact : world.contacts().list) {
    state.push_back(contact.normal_force);
    state.push_back(magnitude(contact.slip));
  }
  if (settings.audit) {
    const auto energy = world.energy();
    for (const double entry : {energy.damping, energy.friction, energy.walls, energy.walls_work, energy.loads_work,
                               energy.elastic, energy.kinetic, energy.lost}) {
      state.push_back(entry);
    }
  }
  return state;
}

void expect_same(const std::vector<double>& one, const std::vector<double>& many, const std::string& what) {
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t k = 0; k < one.size(); ++k) ASSERT_EQ(one[k], many[k]) << what << ", number " << k;
}

/// Checks every kernel: the fused one of these laws, and the general one, which is its reference, with and without the
/// energy budget.
template <int D, class Normal>
void check_bits(const Normal& normal, bool periodic, bool synchronised) {
  const Cumulative tangential{0.5, 1.214};
  const auto one = crowd<D>(PairLaw{normal, tangential}, 1, periodic, synchronised);
  ASSERT_GT(one.size(), 2000U);
  for (const int threads : {2, 3, 4, 7}) {
    expect_same(one, crowd<D>(PairLaw{normal, tangential}, threads, periodic, synchronised),
                std::to_string(threads) + " threads");
  }
  const auto general = any_pair_law({normal, tangential, {}, {}});
  auto reference = crowd<D>(general, 1, periodic, synchronised);
  expect_same(reference, crowd<D>(general, 3, periodic, synchronised), "general kernel, 3 threads");
  reference.resize(one.size());
  expect_same(reference, one, "general kernel and fused");
}

/// A wide periodic layer, in which pairs across the boundary lie too far apart in memory for the ring. The layer may be
/// shifted along x.
std::vector<double> wide_layer(int threads, double along) {
  constexpr int columns = 700;
  constexpr int rows = 50;
  SoftSettings<2> settings;
  settings.time_step = 1e-3;
  settings.gravity = {{0.3, -1.0}};
  settings.box.periodic = true;
  settings.box.x_min = 0.0;
  settings.box.x_max = columns;
  using Law = PairLaw<Hooke, Cumulative>;
  Grains<2> grains;
  for (int k = 0; k < columns * rows; ++k) {
    Grain<2> grain;
    const double shift = 0.02 * uniform(2, Purpose::release_position, static_cast<std::uint64_t>(k));
    grain.position = {{k / rows + 0.5 + shift + along, 0.99 * (k % rows)}};
    grain.radius = 0.5;
    grain.mass = 1.0;
    grain.inverse_mass = k % rows == 0 ? 0.0 : 1.0;
    grains.add(grain, k, grain.fixed());
  }
  static_assert(columns * rows > static_cast<int>(PairList<2>::far));
  const auto method = make_kernel<2>(MaterialTable(Law{Hooke{2e4, 0.3}, Cumulative{0.5, 1.214}}), settings);
  Team team(threads);
  method->grains_added(grains);
  method->advance(grains, 30 * settings.time_step, team);
  std::vector<double> state;
  for (const auto k : by_id(grains)) {
    state.push_back(grains.line[k].velocity[0]);
    state.push_back(grains.line[k].velocity[1]);
    state.push_back(grains.line[k].rim_velocity);
    state.push_back(grains.reaction[k][1]);
  }
  return state;
}

TEST(SoftThreads, SameBitsForFarPairs) {
  const auto one = wide_layer(1, 0.0);
  // With the boundary elsewhere, other pairs are far pairs. The motion is the same except for rounding, which beginning
  // contacts amplify (to at most 5e-5, in one grain). A missing force would change the two columns at the boundary by
  // 0.1, which is 0.005 in the root mean square of all grains.
  const auto moved = wide_layer(1, 350.0);
  double squares = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) squares += std::pow(one[k] - moved[k], 2);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(one.size())), 1e-5);
  for (const int threads : {2, 3}) {
    expect_same(one, wide_layer(threads, 0.0), std::to_string(threads) + " threads");
  }
}

TEST(SoftThreads, SameBitsOpen) { check_bits<2>(Continuous::make(36, 1.2, 0.5, 1.0), false, false); }
TEST(SoftThreads, SameBitsPeriodic) { check_bits<2>(Hooke{2e4, 0.3}, true, false); }
TEST(SoftThreads, SameBitsSynchronised) { check_bits<2>(Hooke{2e4, 0.3}, true, true); }
TEST(SoftThreads, SameBits3D) { check_bits<3>(Continuous::make(36, 1.2, 0.5, 1.0), true, false); }

}  // namespace
}  // namespace repose
