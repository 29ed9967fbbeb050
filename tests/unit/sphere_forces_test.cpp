// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/chains.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/force_statistics.hpp"
#include "repose/analysis/heap.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

// A face-centred cubic crystal in which all contacts push alike: twelve for each sphere inside, and no anisotropy. The
// fabric of all contacts is isotropic by the cubic symmetry of each sphere's own twelve.
TEST(SphereForces, NetworkOfACrystal) {
  const auto centres = fcc_centres(4, 4);
  Grains<3> grains;
  for (const auto& centre : centres) grains.add(unit_sphere(centre), static_cast<std::int64_t>(grains.size()));
  Contacts<3> contacts;
  std::vector<bool> inside;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    bool is_inside = true;
    for (int axis = 0; axis < 3; ++axis) is_inside = is_inside && centres[i][axis] > 0.5 && centres[i][axis] < 4.5;
    inside.push_back(is_inside);
    for (std::size_t j = 0; j < i; ++j) {
      if (magnitude(centres[i] - centres[j]) < 1.01) contacts.list.push_back(sphere_contact(grains, i, j, 2.0));
    }
  }
  const auto network = measure_force_network(grains, contacts, inside, 0.5);
  EXPECT_EQ(network.contacts, contacts.size());
  EXPECT_NEAR(*network.coordination, 12.0, 1e-12);
  EXPECT_EQ(network.connectivity[12], 1.0);
  EXPECT_NEAR(*network.anisotropy, 0.0, 1e-12);
  EXPECT_EQ(measure_force_network(grains, contacts, inside, 3.0).contacts, 0U);
  EXPECT_FALSE(measure_force_network(grains, contacts, inside, 3.0).anisotropy);
  EXPECT_NEAR(mean_normal_force(contacts), 2.0, 1e-12);
}

// A pyramid at rest: the residual is nothing, and that of the same forces in doubled gravity is 1 for each grain.
TEST(SphereForces, ResidualOfAPyramid) {
  const SquarePyramid pyramid(4);
  EXPECT_NEAR(force_residual(pyramid.grains, pyramid.contacts, {{0.0, 0.0, -1.0}}), 0.0, 1e-12);
  EXPECT_NEAR(force_residual(pyramid.grains, pyramid.contacts, {{0.0, 0.0, -2.0}}), 0.5, 1e-12);
  const auto in_heap = supported(pyramid.grains, pyramid.contacts);
  EXPECT_EQ(std::count(in_heap.begin(), in_heap.end(), true), 30);
  const auto network = measure_force_network(pyramid.grains, pyramid.contacts, in_heap, -1.0);
  // 14 upper spheres with 4 contacts below them, 16 with one: 56 x 2 + 16 ends.
  EXPECT_NEAR(*network.coordination, (56.0 * 2.0 + 16.0) / 30.0, 1e-12);
  // <n_z^2> is 1/2 over the 56 and 1 over the 16: 11/18, so that the deviator is 3/2 (11/18 - 1/3) = 5/12.
  EXPECT_NEAR(*network.anisotropy, 5.0 / 12.0, 1e-12);
  EXPECT_NEAR(*network.direction_deg, 90.0, 1e-5);
}

// Exponential forces in random directions: P(f) = exp(-f), and the density of |cos(theta)| is 1. Tolerance: four times
// the error of a bin.
TEST(SphereForces, StatisticsOfRandomForces) {
  constexpr std::size_t count = 20000;
  Contacts<3> contacts;
  for (std::uint64_t k = 0; k < count; ++k) {
    Contact<3> contact;
    contact.normal = random_direction(k);
    contact.normal_force = -3.0 * std::log(1.0 - random_number(k, 7));
    contact.sliding = k % 4 == 0;
    contacts.list.push_back(contact);
  }
  const auto statistics = measure_force_statistics(contacts, 0.0);
  ASSERT_TRUE(statistics);
  EXPECT_NEAR(statistics->mean, 3.0, 0.1);
  for (std::size_t k = 0; k < 20; ++k) {
    const double expected = std::exp(-statistics->f[k]) * std::sinh(0.05) / 0.05;
    EXPECT_NEAR(statistics->density[k], expected, 4.0 * statistics->error[k] + 0.01 * expected) << k;
  }
  EXPECT_TRUE(statistics->direction_deg.empty());
  ASSERT_EQ(statistics->direction_cosine.size(), 20U);
  double sum = 0.0;
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_NEAR(statistics->direction_cosine[k], 0.05 * static_cast<double>(k) + 0.025, 1e-12);
    EXPECT_NEAR(statistics->direction_all[k], 1.0, 4.0 / std::sqrt(count / 20.0)) << k;
    sum += statistics->direction_strong[k] * 0.05;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(statistics->strong_fraction, std::exp(-1.0), 0.015);
  EXPECT_NEAR(statistics->sliding_fraction, 0.25, 1e-12);
  EXPECT_FALSE(measure_force_statistics<3>({}, 0.0));
}

// A chain along the diagonal of a box, through both of its periodic sides: four contacts of length 1 along (1, 1, 1),
// so 4 sqrt(2/3) wide, 4/sqrt(3) high, and arctan(1/sqrt(2)) steep. A level triangle beside it is as wide as its sides.
TEST(SphereForces, Chains) {
  const auto box = level_periodic_box(4.0, 4.0);
  const double step = 1.0 / std::sqrt(3.0);
  Grains<3> grains;
  for (int k = 0; k < 5; ++k) {
    const double at = 2.5 + step * k;
    grains.add(unit_sphere(box.wrapped({{at, at, 1.0 + step * k}})), 10 - k);
  }
  Contacts<3> contacts;
  for (int k = 0; k < 4; ++k) {
    Contact<3> contact;
    contact.first = 9 - k;
    contact.second = 10 - k;
    contact.normal = {{step, step, step}};
    contact.normal_force = 3.0;
    contacts.list.push_back(contact);
  }
  for (int k = 0; k < 3; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / 3.0 + 0.3;
    grains.add(unit_sphere({{2.0 + step * std::cos(turn), 2.0 + step * std::sin(turn), 20.0}}), 20 + k);
  }
  for (std::size_t k = 0; k < 3; ++k) contacts.list.push_back(sphere_contact(grains, 5 + k, 5 + (k + 1) % 3, 3.0));
  Contact<3> weak;
  weak.first = 10;
  weak.second = 20;
  weak.normal = {{1.0, 0.0, 0.0}};
  weak.normal_force = 0.5;
  contacts.list.push_back(weak);
  contacts.sort();
  const auto chains = find_chains(grains, contacts, 0.1, box);
  ASSERT_EQ(chains.list.size(), 2U);
  EXPECT_EQ(chains.list[0].contacts, 4U);
  EXPECT_EQ(chains.list[0].grains, 5U);
  EXPECT_NEAR(chains.list[0].width, 4.0 * std::sqrt(2.0 / 3.0), 1e-12);
  EXPECT_NEAR(chains.list[0].height, 4.0 * step, 1e-12);
  EXPECT_NEAR(chains.list[0].direction_deg, std::atan(std::sqrt(0.5)) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_EQ(chains.list[1].contacts, 3U);
  EXPECT_NEAR(chains.list[1].width, 1.0, 1e-12);
  EXPECT_NEAR(chains.list[1].height, 0.0, 1e-12);
  EXPECT_NEAR(chains.list[1].direction_deg, 0.0, 1e-9);
}

}  // namespace
}  // namespace repose
