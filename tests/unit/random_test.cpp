// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace repose {
namespace {

TEST(Random, IsAFunctionOfItsNames) {
  EXPECT_EQ(uniform(7, Purpose::grain_size, 3), uniform(7, Purpose::grain_size, 3));
  std::set<double> seen;
  for (std::uint64_t seed : {0U, 1U, 2U}) {
    for (const auto purpose : {Purpose::release_position, Purpose::grain_size}) {
      for (std::uint64_t index : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 40}) {
        for (std::uint32_t draw : {0U, 1U}) seen.insert(uniform(seed, purpose, index, draw));
      }
    }
  }
  EXPECT_EQ(seen.size(), 3U * 2U * 3U * 2U);
}

// A uniform number has mean 1/2 and variance 1/12, within 4 standard errors of 1e5 draws.
TEST(Random, IsUniform) {
  constexpr int n = 100000;
  double sum = 0.0;
  double sum2 = 0.0;
  for (int k = 0; k < n; ++k) {
    const double x = uniform(11, Purpose::release_position, static_cast<std::uint64_t>(k));
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    sum2 += x * x;
  }
  const double mean = sum / n;
  EXPECT_NEAR(mean, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / n));
  EXPECT_NEAR(sum2 / n - mean * mean, 1.0 / 12.0, 4.0 * std::sqrt(1.0 / 180.0 / n));
}

// Philox4x32-10 with zero counter and key gives 6627e8d5 e169c58d ... (Salmon et al. 2011, known answers). No call of
// `uniform` has an all-zero counter, so the reference value comes from the library with the same layout.
TEST(Random, UsesTheHighBitsOfPhilox) {
  r123::Philox4x32 philox;
  const auto known = philox(r123::Philox4x32::ctr_type{{0, 0, 0, 0}}, r123::Philox4x32::key_type{{0, 0}});
  EXPECT_EQ(known[0], 0x6627e8d5U);
  const auto bits = philox(r123::Philox4x32::ctr_type{{5, 0, 2, 1}}, r123::Philox4x32::key_type{{9, 0}});
  EXPECT_NEAR(uniform(9, Purpose::release_position, 5, 2), bits[0] * 0x1.0p-32, 0x1.0p-32);
}

}  // namespace
}  // namespace repose
