// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Tests the law of docs/tutorial/own-law.md. CMakeLists.txt here takes it from the page and puts it into the registry.

namespace repose {
namespace {

using World = testing::SoftWorld<2, AnyPairLaw>;

const Bridge bridge{2.0, 0.1};
constexpr double reduced_mass = 0.5;  // of two discs of mass 1

/// Two undamped discs with a bridge that approach each other at this relative speed, almost in touch.
struct TwoDiscs : World {
  static SoftSettings<2> settings() {
    auto made = testing::settings_2d(1e-5, 0.0);
    made.audit = true;
    return made;
  }
  explicit TwoDiscs(double speed) : World(any_pair_law({Hertz{1e5, 0.0}, None{}, {}, bridge}), settings()) {
    add({{0.0, 0.0}}, {{0.5 * speed, 0.0}});
    add({{1.001, 0.0}}, {{-0.5 * speed, 0.0}});
  }
  double parting_speed() { return (*this)[1].velocity[0] - (*this)[0].velocity[0]; }
};

const double critical_speed = std::sqrt(bridge.pull * bridge.rupture / reduced_mass);

// e = sqrt(1 - (v_c/v)^2). The pull begins with a jump, which a step sees late by up to F v dt: 2.5e-4 of the energy of
// a bridge at v = 2 v_c.
TEST(OwnLaw, RestitutionOfABridge) {
  for (const double part : {1.2, 2.0, 5.0}) {
    const double speed = part * critical_speed;
    TwoDiscs world(speed);
    world.advance(60000);
    EXPECT_NEAR(world.parting_speed() / speed, std::sqrt(1.0 - 1.0 / (part * part)), 1e-3) << part;
    EXPECT_TRUE(world.contacts().list.empty());
    EXPECT_NEAR(world.energy().damping, 0.5 * bridge.pull * bridge.rupture, 1e-12);
    EXPECT_NEAR(world.energy().error(), 0.0, 1e-3 * bridge.pull * bridge.rupture);
  }
}

// Slower discs never part further than the bridge reaches.
TEST(OwnLaw, SlowDiscsStick) {
  TwoDiscs world(0.9 * critical_speed);
  double widest = 0.0;
  for (int step = 0; step < 2000; ++step) {
    world.advance(100);
    widest = std::max(widest, world[1].position[0] - world[0].position[0] - 1.0);
  }
  EXPECT_GT(widest, 0.5 * bridge.rupture);
  EXPECT_LT(widest, bridge.rupture);
  EXPECT_EQ(world.contacts().list.size(), 1U);
}

// No bridge before the first touch.
TEST(OwnLaw, GrainsThatHaveNotTouchedDoNotPull) {
  bool bonded = false;
  EXPECT_EQ(attraction(bridge, make_touch(1.05, 1.0 / 1.05, 1.0, 1.0, 0.0, 1.0), bonded), 0.0);
  EXPECT_FALSE(bonded);
  bonded = true;
  EXPECT_NEAR(attraction(bridge, make_touch(1.05, 1.0 / 1.05, 1.0, 1.0, 0.0, 1.0), bonded), 0.5 * bridge.pull, 1e-12);
  EXPECT_TRUE(bonded);
}

TEST(OwnLaw, SceneKnowsTheLaw) {
  const std::string text = R"(contact = { cohesion = { law = "bridge", pull = 0.5 } }
[[grain]]
position = [0.0, 1.0]
[stop]
time = 1
)";
  const auto scene = scene_from_text(text, "scene.toml");
  EXPECT_EQ(std::get<Bridge>(scene.contact.cohesion).rupture, 0.1);
  EXPECT_EQ(scene_text(scene_from_text(scene_text(scene), "again.toml")), scene_text(scene));
}

}  // namespace
}  // namespace repose
