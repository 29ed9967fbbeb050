// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose::theory {
namespace {

// By hand: an approach at 2 of a reduced mass of 3 is stopped by 6; a separation needs no impulse.
TEST(ContactLaw, SignoriniStopsAnApproachAndLeavesASeparation) {
  const auto stopped = answer({.law = "signorini", .mass = 3.0, .free_velocity = -2.0});
  EXPECT_EQ(stopped.impulse, 6.0);
  EXPECT_EQ(stopped.velocity, 0.0);
  const auto left = answer({.law = "signorini", .mass = 3.0, .free_velocity = 2.0});
  EXPECT_EQ(left.impulse, 0.0);
  EXPECT_EQ(left.velocity, 2.0);
}

TEST(ContactLaw, CoulombSticksUpToItsLimitAndSlidesBeyond) {
  for (const auto* law : {"coulomb", "rolling"}) {
    const auto sticks = answer({.law = law, .mass = 2.0, .limit = 1.0, .free_velocity = 0.5});
    EXPECT_EQ(sticks.impulse, -1.0) << law;
    EXPECT_EQ(sticks.velocity, 0.0) << law;
    const auto slides = answer({.law = law, .mass = 2.0, .limit = 1.0, .free_velocity = -1.5});
    EXPECT_EQ(slides.impulse, 1.0) << law;
    EXPECT_EQ(slides.velocity, -1.0) << law;  // slowed from -1.5 by 1/2, in its old direction
  }
}

// The answer lies on the line exactly and on the graph within the distance of two of its points.
TEST(ContactLaw, TheAnswerLiesOnBothLines) {
  for (const auto* law : {"signorini", "coulomb", "rolling"}) {
    for (const double free : {-2.0, -0.3, 0.4, 1.7}) {
      const ContactLaw contact{.law = law, .mass = 1.5, .limit = 0.8, .free_velocity = free, .points = 4001};
      const auto found = answer(contact);
      EXPECT_NEAR(found.impulse, contact.mass * (found.velocity - free), 1e-15);
      const auto table = evaluate(contact);
      double nearest = 1e9;
      for (std::size_t k = 0; k < table.columns[0].values.size(); ++k) {
        nearest = std::min(nearest, std::hypot(table.columns[0].values[k] - found.velocity,
                                               table.columns[1].values[k] - found.impulse));
      }
      EXPECT_LT(nearest, 2e-3) << law << " " << free;
    }
  }
}

}  // namespace
}  // namespace repose::theory
