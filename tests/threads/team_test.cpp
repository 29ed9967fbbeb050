// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/team.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace repose {
namespace {

TEST(Team, EveryMemberWorksAndWaits) {
  for (const int threads : {1, 2, 3, 5}) {
    Team team(threads);
    std::vector<int> value(static_cast<std::size_t>(threads), 0);
    std::vector<int> seen(static_cast<std::size_t>(threads), 0);
    for (int round = 1; round <= 100; ++round) {
      team.run([&](int member) {
        value[static_cast<std::size_t>(member)] = round;
        team.wait();
        seen[static_cast<std::size_t>(member)] = std::accumulate(value.begin(), value.end(), 0);
        team.wait();
      });
      for (const int sum : seen) ASSERT_EQ(sum, round * threads);
    }
  }
}

TEST(Team, RangesCoverEverythingOnce) {
  for (const std::size_t count : {0U, 1U, 5U, 64U, 1001U}) {
    for (const int members : {1, 2, 3, 7}) {
      std::size_t next = 0;
      for (int member = 0; member < members; ++member) {
        const auto range = range_of(count, member, members);
        EXPECT_EQ(range.begin, next);
        EXPECT_LE(range.begin, range.end);
        next = range.end;
      }
      EXPECT_EQ(next, count);
    }
  }
}

}  // namespace
}  // namespace repose
