// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_statistics.hpp"

#include "repose/core/random.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// A network made by hand: a row of fixed discs (0 to 4) with two columns on it.
///
///        7   9
///        6   8        10 (alone)
///        5===11       11 stands between the columns and touches 5 weakly
///   0  1 2 3 4
struct Network {
  Grains<2> grains;
  Contacts<2> contacts;
};
Network network() {
  Network made;
  auto& grains = made.grains;
  for (int k = 0; k < 5; ++k) grains.add(unit_disc(k, 0.0, true), k);
  grains.add(unit_disc(1.0, 1.0), 5);
  grains.add(unit_disc(1.0, 2.0), 6);
  grains.add(unit_disc(1.0, 3.0), 7);
  grains.add(unit_disc(3.0, 1.0), 8);
  grains.add(unit_disc(3.0, 2.0), 9);
  grains.add(unit_disc(9.0, 1.0), 10);
  grains.add(unit_disc(2.0, 1.0), 11);
  const auto add = [&](std::size_t a, std::size_t b, double force, bool sliding = false) {
    made.contacts.list.push_back(contact_between(grains, a, b, force, sliding));
  };
  // Above the threshold of 0.5: forces 6, 5, 4, 6, 5, 1, 1; mean 4.
  add(5, 1, 6.0);        // strong: chain A
  add(6, 5, 5.0, true);  // strong: chain A
  add(7, 6, 4.0);        // equal to the mean: not strong
  add(8, 3, 6.0);        // strong: chain B
  add(9, 8, 5.0);        // strong: chain B
  add(11, 5, 1.0, true);
  add(8, 11, 1.0);
  add(11, 2, 0.2, true);  // below the threshold: does not count at all
  return made;
}

TEST(ForceStatistics, HandMadeNetwork) {
  const auto made = network();
  const auto statistics = measure_force_statistics(made.contacts, 0.5);
  ASSERT_TRUE(statistics);
  EXPECT_DOUBLE_EQ(statistics->mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics->strong_fraction, 4.0 / 7.0);
  EXPECT_DOUBLE_EQ(statistics->sliding_fraction, 2.0 / 7.0);
  // f: 0.25 twice, 1 once, 1.25 twice, 1.5 twice, in bins of 0.1 from the threshold of 0.5/4.
  EXPECT_DOUBLE_EQ(statistics->bin_width, 0.1);
  EXPECT_DOUBLE_EQ(statistics->f[0], 0.175);
  const auto at = [&](double f) { return static_cast<std::size_t>((f - 0.125) / 0.1); };
  EXPECT_NEAR(statistics->density[at(0.25)], 2.0 / 0.7, 1e-12);
  EXPECT_NEAR(statistics->density[at(1.25)], 2.0 / 0.7, 1e-12);
  EXPECT_NEAR(statistics->error[at(1.25)], std::sqrt(2.0) / 0.7, 1e-12);
  EXPECT_EQ(statistics->density[at(0.55)], 0.0);
  double integral = 0.0;
  for (const double density : statistics->density) integral += density * statistics->bin_width;
  EXPECT_NEAR(integral, 1.0, 1e-12);
  // Two of seven contacts are horizontal, the others vertical; all strong ones are vertical.
  EXPECT_NEAR(statistics->direction_all[0], 2.0 / 35.0, 1e-12);
  EXPECT_NEAR(statistics->direction_all[18], 5.0 / 35.0, 1e-12);
  EXPECT_NEAR(statistics->direction_strong[18], 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(statistics->direction_deg[18], 90.0);
}

// n exponential forces over their mean: P(f) = exp(-f) up to terms of order 1/n. In bins of 0.1 the mean of exp(-f)
// differs from its value at the centre by 0.04 %. Tolerance: 5 standard errors of the count; 30 bins exceed it with
// probability 2e-5.
TEST(ForceStatistics, ExponentialForces) {
  constexpr std::uint64_t count = 40000;
  Contacts<2> contacts;
  for (std::uint64_t k = 0; k < count; ++k) {
    Contact<2> contact;
    contact.normal = {{1.0, 0.0}};
    contact.normal_force = -std::log(1.0 - uniform(5, Purpose::grain_size, k));
    contacts.list.push_back(contact);
  }
  const auto statistics = measure_force_statistics(contacts, -1.0);
  ASSERT_TRUE(statistics);
  for (std::size_t k = 0; k < 30; ++k) {
    const double expected = std::exp(-statistics->f[k]);
    const double error = std::sqrt(expected / (static_cast<double>(count) * 0.1));
    EXPECT_NEAR(statistics->density[k], expected, 5.0 * error) << statistics->f[k];
    EXPECT_NEAR(statistics->error[k], error, 0.2 * error);
  }
}

TEST(ForceStatistics, AHugeForceWidensTheBins) {
  Contacts<2> contacts;
  for (int k = 0; k < 9999; ++k) contacts.list.push_back({.normal = {{0.0, 1.0}}, .normal_force = 1.0});
  contacts.list.push_back({.normal = {{0.0, 1.0}}, .normal_force = 1e9});
  const auto statistics = measure_force_statistics(contacts, 0.5);
  ASSERT_TRUE(statistics);
  EXPECT_LE(statistics->f.size(), 1000U);
  double integral = 0.0;
  for (const double density : statistics->density) integral += density * statistics->bin_width;
  EXPECT_NEAR(integral, 1.0, 1e-12);
}

TEST(ForceStatistics, NoneWithoutForces) { EXPECT_FALSE(measure_force_statistics({}, 0.0)); }

}  // namespace
}  // namespace repose
