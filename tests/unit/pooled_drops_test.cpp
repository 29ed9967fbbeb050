// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/pooled_drops.hpp"

#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace repose {
namespace {

/// Four members of as many drops each, by the inverse of their distribution function.
template <class Inverse>
PooledDrops pooled(std::uint64_t count, const Inverse& inverse) {
  SweepPlan plan;
  plan.points.push_back({"without", {}, {}});
  plan.points.push_back({"slips", {}, {}});
  SweepTable table;
  for (std::size_t seed = 0; seed < 4; ++seed) {
    MemberRow row{1, static_cast<std::int64_t>(seed), "finished", {}, {}};
    for (std::uint64_t k = 0; k < count; ++k) {
      row.drops.push_back(inverse(uniform(seed + 70, Purpose::release_position, k, 0)));
    }
    table.members.push_back(row);
  }
  table.members.push_back({0, 1, "finished", {}, {}});
  const auto all = pool_drops(plan, table);
  EXPECT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().point, "slips");
  EXPECT_EQ(all.front().members, 4U);
  EXPECT_NE(drops_csv(all).find("\nslips,4," + std::to_string(4 * count) + ","), std::string::npos);
  return all.front();
}

// One member of 3000 has too few; four together carry a power law, and refute one where the drops are exponential.
TEST(PooledDrops, ManyMembersDecideWhatOneCannot) {
  const auto power = pooled(3000, [](double u) { return std::pow(1.0 - u, -1.0 / 0.8); });
  EXPECT_NEAR(power.fit.exponent, 1.8, 3.0 * power.fit.error);
  EXPECT_EQ(power.fit.verdict, "power law");
  const auto exponential = pooled(300, [](double u) { return -std::log1p(-u); });
  EXPECT_NE(exponential.fit.verdict, "power law");
  EXPECT_EQ(exponential.fit.verdict.substr(0, 12), "no power law");
}

}  // namespace
}  // namespace repose
