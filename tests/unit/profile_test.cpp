// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/profile.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace repose {
namespace {

void work(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

Profile::Line line_of(Profile& profile, const std::string& name) {
  for (const auto& line : profile.lines()) {
    if (line.name == name) return line;
  }
  return {};
}

TEST(Profile, StagesWithinCountForThemselves) {
  const auto start = std::chrono::steady_clock::now();
  Profile profile;
  {
    const Profile::Stage outer(&profile, "outer");
    work(5);
    for (int k = 0; k < 3; ++k) {
      const Profile::Stage inner(&profile, "inner");
      work(5);
    }
  }
  work(5);
  EXPECT_EQ(line_of(profile, "outer").calls, 1);
  EXPECT_EQ(line_of(profile, "inner").calls, 3);
  // Sleep lasts at least as long as asked for.
  EXPECT_GE(line_of(profile, "outer").seconds, 0.005);
  EXPECT_GE(line_of(profile, "inner").seconds, 0.015);
  double sum = 0.0;
  for (const auto& line : profile.lines()) sum += line.seconds;
  const auto passed = std::chrono::steady_clock::now() - start;
  EXPECT_GE(sum, 0.025);
  EXPECT_LE(sum, std::chrono::duration<double>(passed).count());
  EXPECT_EQ(profile.lines().back().name, "other");
}

TEST(Profile, StageWithoutProfileDoesNothing) {
  const Profile::Stage stage(nullptr, "stage");
  Profile profile;
  EXPECT_EQ(profile.lines().size(), 1U);
}

}  // namespace
}  // namespace repose
