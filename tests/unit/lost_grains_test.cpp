// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/lost_grains.hpp"

#include <gtest/gtest.h>

#include <string>

namespace repose {
namespace {

// Two of five leave a box from 0 to 10; a fixed grain outside stays. Entries go with their grains, in order.
TEST(LostGrains, GoWithTheirEntries) {
  Box<2> box;
  box.x_min = 0.0;
  box.x_max = 10.0;
  box.floor = -1.0;
  Grains<2> grains;
  std::vector<std::string> names;
  const auto add = [&](std::int64_t id, Vec<2> position, bool fixed, const char* name) {
    Grain<2> grain;
    grain.position = position;
    grain.inverse_mass = fixed ? 0.0 : 1.0;
    grains.add(grain, id);
    names.emplace_back(name);
  };
  add(5, {{-0.1, 0.0}}, false, "left");
  add(3, {{-9.0, 0.0}}, true, "fixed");
  add(9, {{4.0, 2.0}}, false, "inside");
  add(2, {{4.0, -1.1}}, false, "below");
  add(7, {{10.0, 0.0}}, false, "at the side");
  drop_lost(grains, box, names);
  EXPECT_EQ(grains.id, (std::vector<std::int64_t>{3, 9, 7}));
  EXPECT_EQ(names, (std::vector<std::string>{"fixed", "inside", "at the side"}));
  EXPECT_EQ(grains.line[1].position[0], 4.0);
  drop_lost(grains, box, names);
  EXPECT_EQ(grains.size(), 3U);
}

}  // namespace
}  // namespace repose
