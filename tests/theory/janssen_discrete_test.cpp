// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen_discrete.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace repose::theory {
namespace {

// One cell after the other by (30), the balance of forces, with more digits than the closed form.
TEST(JanssenDiscrete, ClosedFormIsTheRecursion) {
  for (const auto* direction : {"rest", "pushed-up"}) {
    for (const double k_mu : {1e-18, 1e-9, 1e-3, 0.1, 0.3, 0.49}) {
      const JanssenDiscrete stack{.k_mu = k_mu, .layers = 200, .direction = direction};
      const long double sense =
          stack.direction == "rest" ? -1.0L : 1.0L;  // sign of the force of the walls on the cell, downward
      long double force = 0.0L;
      for (int layer = 1; layer <= 150; ++layer) {
        force = (force + 3.0L) / (1.0L - sense * 2.0L * static_cast<long double>(k_mu));
        const auto expected = static_cast<double>(force);
        ASSERT_NEAR(force_below(stack, layer), expected, 2e-13 * expected) << direction << k_mu << ' ' << layer;
        // The force on the cell carries the cells above, its three grains, and the walls.
        const double above = layer == 1 ? 0.0 : force_below(stack, layer - 1);
        const double here = force_below(stack, layer);
        ASSERT_NEAR(here, above + 3.0 + static_cast<double>(sense) * 2.0 * k_mu * here, 1e-12 * here);
      }
    }
  }
}

// The same with other forces of the cell pressing on the walls.
TEST(JanssenDiscrete, OtherLoadsOfTheWalls) {
  for (const auto* direction : {"rest", "pushed-up"}) {
    for (const double k_mu : {1e-12, 0.1, 0.45}) {
      const JanssenDiscrete mean{.k_mu = k_mu, .direction = direction, .wall_load = "mean"};
      const JanssenDiscrete above{.k_mu = k_mu, .direction = direction, .wall_load = "above"};
      const double walls = (mean.direction == "rest" ? -2.0 : 2.0) * k_mu;
      for (int layer = 1; layer <= 40; ++layer) {
        const double m_0 = layer == 1 ? 0.0 : force_below(mean, layer - 1);
        const double m_1 = force_below(mean, layer);
        ASSERT_NEAR(m_1, m_0 + 3.0 + walls * 0.5 * (m_0 + m_1), 1e-13 * m_1) << direction << k_mu << ' ' << layer;
        const double a_0 = layer == 1 ? 0.0 : force_below(above, layer - 1);
        const double a_1 = force_below(above, layer);
        ASSERT_NEAR(a_1, a_0 + 3.0 + walls * a_0, 1e-13 * a_1) << direction << k_mu << ' ' << layer;
      }
    }
    // The ratio for the mean is even in K mu. The ratio for the other end is that for the other direction.
    const auto ratio = [&](const char* load) {
      return discrete_lengths({.k_mu = 0.1, .direction = direction, .wall_load = load}).ratio;
    };
    EXPECT_NEAR(ratio("mean"), std::log(1.1 / 0.9) / 0.2, 1e-14);
    EXPECT_NEAR(ratio("above"), std::string{direction} == "rest" ? 1.11572 : 0.91161, 5e-6);
  }
}

TEST(JanssenDiscrete, WithoutFrictionTheWholeWeight) {
  for (const auto* direction : {"rest", "pushed-up"}) {
    const JanssenDiscrete stack{.k_mu = 0.0, .layers = 7, .direction = direction};
    EXPECT_EQ(evaluate(stack).column("force").values.back(), 21.0);
    EXPECT_EQ(discrete_lengths(stack).ratio, 1.0);
  }
}

// The thesis prints 1.1 for K mu = 0.1.
TEST(JanssenDiscrete, RatioOfTheLengths) {
  EXPECT_NEAR(discrete_lengths({.k_mu = 0.1, .direction = "pushed-up"}).ratio, 1.11572, 5e-6);
  EXPECT_NEAR(discrete_lengths({.k_mu = 0.1, .direction = "rest"}).ratio, 0.91161, 5e-6);
  for (const auto* direction : {"rest", "pushed-up"}) {
    const JanssenDiscrete stack{.k_mu = 0.23, .direction = direction};
    const auto lengths = discrete_lengths(stack);
    const double sense = stack.direction == "rest" ? 1.0 : -1.0;
    const double expected =
        sense * 3.0 * lengths.lambda_1 * (1.0 - std::exp(-sense * 12.0 / lengths.lambda_2));  // (38)
    EXPECT_NEAR(force_below(stack, 12), expected, 1e-13 * expected) << direction;
    EXPECT_NEAR(lengths.lambda_1 / lengths.lambda_2, lengths.ratio, 1e-15);
  }
}

TEST(JanssenDiscrete, RefusesAJamAndAnOverflow) {
  EXPECT_EQ(relations(JanssenDiscrete{.k_mu = 0.5, .direction = "pushed-up"}).size(), 1u);
  EXPECT_TRUE(relations(JanssenDiscrete{.k_mu = 0.4999, .layers = 50, .direction = "pushed-up"}).empty());
  EXPECT_EQ(relations(JanssenDiscrete{.k_mu = 0.4999, .layers = 500, .direction = "pushed-up"}).size(), 1u);
  EXPECT_TRUE(relations(JanssenDiscrete{.k_mu = 5.0, .layers = 500}).empty());
  EXPECT_EQ(relations(JanssenDiscrete{.k_mu = 0.5, .wall_load = "above"}).size(), 1u);
  EXPECT_TRUE(relations(JanssenDiscrete{.k_mu = 5.0, .direction = "pushed-up", .wall_load = "above"}).empty());
  EXPECT_EQ(relations(JanssenDiscrete{.k_mu = 1.0, .direction = "pushed-up", .wall_load = "mean"}).size(), 1u);
  EXPECT_EQ(relations(JanssenDiscrete{.k_mu = 1.0, .wall_load = "mean"}).size(), 1u);
  EXPECT_TRUE(relations(JanssenDiscrete{.k_mu = 0.99, .wall_load = "mean"}).empty());
}

}  // namespace
}  // namespace repose::theory
