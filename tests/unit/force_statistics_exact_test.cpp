// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_statistics.hpp"
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace repose {
namespace {

Contact<2> contact_at(double force, double normal_deg, bool sliding = false) {
  Contact<2> c;
  const double angle = normal_deg * std::numbers::pi / 180.0;
  c.normal = {{std::cos(angle), std::sin(angle)}};
  c.normal_force = force;
  c.sliding = sliding;
  return c;
}

Contacts<2> exponential_forces(std::size_t count) {
  Contacts<2> contacts;
  for (std::size_t k = 0; k < count; ++k) {
    const double fraction = uniform(5, Purpose::grain_size, k);
    const double angle = 360.0 * uniform(6, Purpose::grain_size, k);
    contacts.list.push_back(contact_at(-3.0 * std::log(1.0 - fraction), angle));
  }
  return contacts;
}

double integral(const std::vector<double>& density, double bin_width) {
  double sum = 0.0;
  for (const double value : density) sum += value * bin_width;
  return sum;
}

// Four contacts with mean force 1 count: f = 0.25, 0.25, 0.75, 2.75 in the bins 1, 1, 6, 26 from the threshold on. One
// slides, one is above the mean. The fifth also slides but is not above the threshold. Tolerance: rounding of sums of
// four numbers.
TEST(ForceStatisticsExact, HandMade) {
  Contacts<2> contacts;
  contacts.list = {contact_at(0.25, 180.0), contact_at(2.75, -85.0), contact_at(0.25, 95.0, true),
                   contact_at(0.75, 33.0), contact_at(0.125, 33.0, true)};
  // An axis just below the horizontal counts as horizontal.
  contacts.list[0].normal = {{1.0, -1e-18}};
  const auto statistics = measure_force_statistics(contacts, 0.125);
  ASSERT_TRUE(statistics);
  EXPECT_NEAR(statistics->mean, 1.0, 1e-15);
  EXPECT_EQ(statistics->bin_width, 0.1);
  ASSERT_EQ(statistics->density.size(), 27U);
  ASSERT_EQ(statistics->f.size(), 27U);
  ASSERT_EQ(statistics->error.size(), 27U);
  for (std::size_t k = 0; k < 27; ++k) {
    const double count = k == 1 ? 2.0 : k == 6 || k == 26 ? 1.0 : 0.0;
    EXPECT_NEAR(statistics->f[k], 0.125 + 0.1 * static_cast<double>(k) + 0.05, 1e-12);
    EXPECT_NEAR(statistics->density[k], count / 0.4, 1e-12) << k;
    EXPECT_NEAR(statistics->error[k], std::sqrt(count) / 0.4, 1e-12) << k;
  }
  ASSERT_EQ(statistics->direction_deg.size(), 36U);
  for (std::size_t k = 0; k < 36; ++k) {
    const double count = k == 19 ? 2.0 : k == 0 || k == 7 ? 1.0 : 0.0;  // -85 and 95 degrees are the same axis
    EXPECT_EQ(statistics->direction_deg[k], 5.0 * static_cast<double>(k));
    EXPECT_NEAR(statistics->direction_all[k], count / 20.0, 1e-15) << k;
    EXPECT_NEAR(statistics->direction_strong[k], k == 19 ? 0.2 : 0.0, 1e-15) << k;
  }
  EXPECT_NEAR(statistics->sliding_fraction, 0.25, 1e-15);
  EXPECT_NEAR(statistics->strong_fraction, 0.25, 1e-15);
}

// The axes of lattices, off by rounding either way, stay in one bin each.
TEST(ForceStatisticsExact, AxesOfLatticesAreNoEdges) {
  for (int axis = 0; axis < 180; axis += 15) {
    Contacts<2> contacts;
    for (const double off : {-1e-9, 0.0, 1e-9}) contacts.list.push_back(contact_at(1.0, axis + off));
    const auto statistics = measure_force_statistics(contacts, 0.0);
    ASSERT_TRUE(statistics);
    for (std::size_t k = 0; k < 36; ++k) {
      EXPECT_NEAR(statistics->direction_all[k], statistics->direction_deg[k] == axis ? 0.2 : 0.0, 1e-15) << axis;
    }
  }
}

// Exponential forces above a threshold c fall as exp(-(f - c)) from there on: the first bin is as full as the others,
// within four standard errors of its count of 9500, 4 %. A bin from 0 would hold half as many.
TEST(ForceStatisticsExact, TheThresholdIsNoDownturn) {
  const auto statistics = measure_force_statistics(exponential_forces(100000), 0.15);
  ASSERT_TRUE(statistics);
  const double mean = 3.15;  // of forces above 0.15, whose excess has the mean 3
  const double width = 0.1 * mean / 3.0;
  const double expected = (1.0 - std::exp(-width)) / 0.1;
  EXPECT_NEAR(statistics->f[0], 0.15 / mean + 0.05, 1e-3);
  EXPECT_NEAR(statistics->density[0], expected, 0.04 * expected);
}

// Rounding of sums of 1e5 terms stays far below 1e-12, because each is a whole number over a common denominator.
TEST(ForceStatisticsExact, IntegralIsOne) {
  const auto statistics = measure_force_statistics(exponential_forces(100000), 0.6);
  ASSERT_TRUE(statistics);
  EXPECT_NEAR(integral(statistics->density, statistics->bin_width), 1.0, 1e-12);
  EXPECT_NEAR(integral(statistics->direction_all, 5.0), 1.0, 1e-12);
  EXPECT_NEAR(integral(statistics->direction_strong, 5.0), 1.0, 1e-12);
}

// Exponential forces: P(f) = exp(-f), averaged over a bin. The B bins with 100 expected counts or more have, with the
// reported errors, a chi-squared of B within 4 sqrt(2 B), so errors that are too small or too large both fail. The mean
// is within 4 standard errors, and so is the fraction above it (binomial error). The density of each of the 36
// directions, which is uniform, is within 4.5 standard errors.
TEST(ForceStatisticsExact, ExponentialForces) {
  constexpr std::size_t count = 100000;
  const auto statistics = measure_force_statistics(exponential_forces(count), 0.0);
  ASSERT_TRUE(statistics);
  const auto n = static_cast<double>(count);
  EXPECT_NEAR(statistics->mean, 3.0, 4.0 * 3.0 / std::sqrt(n));
  double chi_squared = 0.0;
  double bins = 0.0;
  for (std::size_t k = 0; k < statistics->f.size(); ++k) {
    const double expected =
        (std::exp(-statistics->f[k] + 0.05) - std::exp(-statistics->f[k] - 0.05)) / statistics->bin_width;
    if (expected * n * statistics->bin_width < 100.0) break;
    chi_squared += std::pow((statistics->density[k] - expected) / statistics->error[k], 2);
    bins += 1.0;
  }
  EXPECT_GT(bins, 40.0);
  EXPECT_NEAR(chi_squared, bins, 4.0 * std::sqrt(2.0 * bins));
  const double strong = std::exp(-1.0);
  EXPECT_NEAR(statistics->strong_fraction, strong, 4.0 * std::sqrt(strong * (1.0 - strong) / n));
  for (const double density : statistics->direction_all) {
    EXPECT_NEAR(density, 1.0 / 180.0, 4.5 * std::sqrt(35.0 / n) / 180.0);
  }
}

// A failed run may leave forces that are not numbers. They do not count.
TEST(ForceStatisticsExact, ForcesThatAreNotNumbers) {
  Contacts<2> contacts;
  contacts.list = {contact_at(std::numeric_limits<double>::infinity(), 0.0)};
  EXPECT_FALSE(measure_force_statistics(contacts, 0.0));
  contacts.list.push_back(contact_at(std::numeric_limits<double>::quiet_NaN(), 0.0));
  contacts.list.push_back(contact_at(2.0, 0.0));
  const auto statistics = measure_force_statistics(contacts, 0.0);
  ASSERT_TRUE(statistics);
  EXPECT_EQ(statistics->mean, 2.0);
}

// None of ten equal forces is above their mean, independently of the rounding of a sum of tenths.
TEST(ForceStatisticsExact, EqualForcesAreNotStrong) {
  Contacts<2> contacts;
  for (int k = 0; k < 10; ++k) contacts.list.push_back(contact_at(1.0, 45.0));
  const auto statistics = measure_force_statistics(contacts, 0.0);
  ASSERT_TRUE(statistics);
  EXPECT_EQ(statistics->mean, 1.0);
  EXPECT_EQ(statistics->strong_fraction, 0.0);
}

}  // namespace
}  // namespace repose
