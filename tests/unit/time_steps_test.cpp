// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/time_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// Times and whole steps. Steps of lengths that no double has exactly must not shift anything by one.

namespace repose {
namespace {

const double lengths[] = {1e-3, 0.1, 1.0 / 3.0, 0.0012345678901234, 1.0};

TEST(TimeSteps, EndsOfStepsAreThemselves) {
  for (const double length : lengths) {
    const TimeSteps steps{length, true};
    for (long k = 0; k < 200000; k += 37) {
      const double time = steps.after(k);
      EXPECT_EQ(time, static_cast<double>(k) * length);
      ASSERT_EQ(steps.count(time), k);
      ASSERT_EQ(steps.nearest(time), time);
      ASSERT_EQ(steps.nearest(time + 0.49 * length), time);
      ASSERT_EQ(steps.nearest(time + 0.51 * length), steps.after(k + 1));
      ASSERT_EQ(steps.at_or_after(time + 0.01 * length), steps.after(k + 1));
      ASSERT_EQ(steps.at_or_after(time + 1e-10 * length, 1e-9), time);
      ASSERT_EQ(steps.later(time, steps.after(3)), steps.after(k + 3));
    }
  }
}

TEST(TimeSteps, DurationsAreAtLeastAStep) {
  const TimeSteps steps{0.1, false};
  EXPECT_EQ(steps.rounded(0.01), 0.1);
  EXPECT_EQ(steps.cut(0.01), 0.1);
  EXPECT_EQ(steps.rounded(0.29), steps.after(3));
  EXPECT_EQ(steps.cut(0.29), steps.after(2));
  EXPECT_EQ(steps.cut(0.1), 0.1);
}

TEST(TimeSteps, VelocitiesLagHalfAStepButAtTheStart) {
  EXPECT_EQ((TimeSteps{0.1, true}.velocity_lag(0.0)), 0.0);
  EXPECT_EQ((TimeSteps{0.1, true}.velocity_lag(0.1)), 0.05);
  EXPECT_EQ((TimeSteps{0.1, false}.velocity_lag(0.1)), 0.0);
}

// Where steps vary the method stops at any time, and nothing is rounded.
TEST(TimeSteps, VaryingStepsRoundNothing) {
  const TimeSteps any;
  EXPECT_FALSE(any.equal());
  for (const double time : {0.0, 0.1, 1.0 / 3.0, 1e9}) {
    EXPECT_EQ(any.nearest(time), time);
    EXPECT_EQ(any.at_or_after(time), time);
    EXPECT_EQ(any.rounded(time), time);
    EXPECT_EQ(any.cut(time), time);
    EXPECT_EQ(any.later(time, 0.25), time + 0.25);
  }
}

// More steps than can be counted are as many as can: nothing overflows.
TEST(TimeSteps, WhatNoRunReaches) {
  const TimeSteps steps{1e-3, true};
  EXPECT_EQ(steps.count(std::numeric_limits<double>::infinity()), 1000000000000000L);
  EXPECT_EQ(steps.count(1e300), 1000000000000000L);
  EXPECT_EQ(steps.count(-1.0), 0);
  EXPECT_GT(Every(1e300, steps).after(1.0), 1e11);
}

TEST(Every, MultiplesOfWholeSteps) {
  for (const double length : lengths) {
    const TimeSteps steps{length, true};
    const Every every(7.3 * length, steps);
    for (long k = 0; k < 100000; k += 13) {
      const double now = steps.after(k);
      ASSERT_EQ(every.after(now), steps.after((k / 7 + 1) * 7));
      ASSERT_EQ(every.at_or_after(now), steps.after((k + 6) / 7 * 7));
    }
  }
}

TEST(Every, MultiplesOfAnyInterval) {
  for (const double interval : lengths) {
    const Every every(interval, TimeSteps{});
    EXPECT_EQ(every.after(0.0), interval);
    EXPECT_EQ(every.at_or_after(0.0), 0.0);
    for (long k = 1; k < 100000; k += 13) {
      const double multiple = static_cast<double>(k) * interval;
      ASSERT_EQ(every.at_or_after(multiple), multiple);
      ASSERT_EQ(every.after(multiple), static_cast<double>(k + 1) * interval);
      ASSERT_EQ(every.after(std::nextafter(multiple, 0.0)), multiple);
      ASSERT_EQ(every.at_or_after(std::nextafter(multiple, 1e9)), static_cast<double>(k + 1) * interval);
    }
  }
}

TEST(Every, Never) {
  const Every never(0.0, TimeSteps{0.1, true});
  EXPECT_TRUE(never.never());
  EXPECT_EQ(never.after(1.0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace repose
