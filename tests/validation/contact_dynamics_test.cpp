// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "support/rigid_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

using testing::open_box;
using testing::rigid_2d;
using testing::RigidWorld;

// Claim: the floor and walls of a box carry the weight of 1000 discs at rest to 1e-6. Source: statics. Discs of
// diameter 0.8 to 1, friction 0.5, fall into a box 40 wide; seed 7. Tolerance: the residual is 1e-6 of g dt per
// contact, with either sign; the remaining motion enters the same balance.
TEST(ContactDynamicsBox, CarriesTheWeightOf1000Discs) {
  ImpulseLaw law;
  law.friction = 0.5;
  auto settings = rigid_2d(0.05, 1.0);
  settings.solver.most_sweeps = 500;  // enough while the discs fall; at rest few are needed
  settings.walls = open_box(40.0);
  RigidWorld<2> world(law, settings);
  double weight = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const auto index = static_cast<std::uint64_t>(k);
    const double size = 0.4 + 0.1 * uniform(7, Purpose::grain_size, index);
    const double shift = 0.05 * uniform(7, Purpose::release_position, index);
    world.add({{0.6 + (k % 39) + shift, 0.6 + 1.05 * (k / 39)}}, {}, 0.0, size);
    weight += 4.0 * size * size;
  }
  ASSERT_FALSE(world.advance(900).trouble);
  world.method.take_wall_impulses();
  const long unconverged = world.method.account().unconverged;
  ASSERT_FALSE(world.advance(20).trouble);
  EXPECT_EQ(world.method.account().unconverged, unconverged);
  const auto taken = world.method.take_wall_impulses();
  const Vec<2> sum = taken[0] + taken[1] + taken[2];
  const double carried = weight * 0.05 * 20.0;
  EXPECT_NEAR(-sum[1] / carried, 1.0, 1e-6);
  EXPECT_NEAR(sum[0] / carried, 0.0, 1e-6);
  EXPECT_LT(kinetic_energy(world.grains) / 1000.0, 1e-6);
}

}  // namespace
}  // namespace repose
