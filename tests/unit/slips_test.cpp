// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/slips/slips.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

// A saw: it rises by 3 in three units of time, without motion, and falls by 2 in one, while the wall moves by 0.5.
TEST(Slips, AreTheFallsOfASaw) {
  std::vector<DriveRow> path;
  for (int k = 0; k < 21; ++k) {
    const int cycle = k / 4;
    const int within = k % 4;
    path.push_back({1.0 * k, 1.0 * cycle + within, 0.5 * cycle});
  }
  const auto found = find_slips(path, 0.1);
  ASSERT_EQ(found.size(), 4U);  // the last fall has not turned
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto cycle = static_cast<double>(k);
    EXPECT_EQ(found[k].begin, 4.0 * cycle + 3.0);
    EXPECT_EQ(found[k].end, 4.0 * cycle + 4.0);
    EXPECT_EQ(found[k].force, cycle + 3.0);
    EXPECT_EQ(found[k].drop, 2.0);
    EXPECT_EQ(found[k].slide, 0.5);
    if (k == 0) continue;
    EXPECT_EQ(found[k].waiting, 3.0);
    EXPECT_EQ(found[k].creep, 0.0);
  }
  EXPECT_TRUE(std::isnan(found[0].waiting) && std::isnan(found[0].creep));
}

TEST(Slips, SmallerTurnsThanTheHysteresisAreNone) {
  std::vector<DriveRow> path;
  for (int k = 0; k < 100; ++k) path.push_back({1.0 * k, 5.0 + 0.01 * k + (k % 2 == 0 ? 0.04 : 0.0), 0.0});
  EXPECT_EQ(find_slips(path, 0.1).size(), 0U);
  EXPECT_GT(find_slips(path, 0.01).size(), 40U);
  EXPECT_EQ(find_slips({}, 0.1).size(), 0U);
}

}  // namespace
}  // namespace repose
