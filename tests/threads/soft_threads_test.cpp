// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "support/every_law.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

// The results are the same to the bit for any number of threads.

namespace repose {
namespace {

using testing::SoftWorld;

/// A crowd of grains in a box that falls together; a few fast ones. Returns its state after some time, by id.
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
  settings.planes = {{{}, floor_normal, false}};
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
  world.advance(1500);
  std::vector<double> state;
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
    state.push_back(magnitude(contact.history));
  }
  return state;
}

template <int D>
void check_bits(const NormalLaw& normal, bool periodic, bool synchronised) {
  with_pair_law(normal, Cumulative{0.5, 1.214}, [&](const auto& law) {
    const auto one = crowd<D>(law, 1, periodic, synchronised);
    ASSERT_GT(one.size(), 2000U);
    for (const int threads : {2, 3, 4, 7}) {
      const auto many = crowd<D>(law, threads, periodic, synchronised);
      ASSERT_EQ(one.size(), many.size());
      for (std::size_t k = 0; k < one.size(); ++k) ASSERT_EQ(one[k], many[k]) << threads << " threads, number " << k;
    }
  });
}

TEST(SoftThreads, SameBitsOpen) { check_bits<2>(Continuous::make(36, 1.2, 0.5, 1.0), false, false); }
TEST(SoftThreads, SameBitsPeriodic) { check_bits<2>(Hooke{2e4, 0.3}, true, false); }
TEST(SoftThreads, SameBitsSynchronised) { check_bits<2>(Hooke{2e4, 0.3}, true, true); }
TEST(SoftThreads, SameBits3D) { check_bits<3>(Continuous::make(36, 1.2, 0.5, 1.0), true, false); }

}  // namespace
}  // namespace repose
