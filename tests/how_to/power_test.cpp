// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/laws/impact.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Tests the law of docs/how-to/add-a-law.md. CMakeLists.txt here takes it from the page and puts it into the registry.

namespace repose {
namespace {

const std::string scene_text_of_power = R"(contact = { normal = { law = "power", power = 2.5, restitution = 0.6 } }
[[grain]]
position = [0.0, 1.0]
[stop]
time = 1
)";

TEST(HowTo, SceneKnowsTheLaw) {
  const auto scene = scene_from_text(scene_text_of_power, "scene.toml");
  const auto& law = std::get<Power>(scene.contact.normal);
  EXPECT_EQ(law.power, 2.5);
  EXPECT_EQ(law.stiffness, 1000.0);
  const auto again = scene_from_text(scene_text(scene), "again.toml");
  EXPECT_EQ(scene_text(again), scene_text(scene));
  try {
    Overrides overrides;
    overrides.set = {"contact.normal.power=0.5"};
    scene_from_text(scene_text_of_power, "scene.toml", overrides);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("contact.normal.power = 0.5: must be >= 1"), std::string::npos);
  }
}

// T = 2 d_max / v * sqrt(pi) Gamma(1 / (p + 1)) / ((p + 1) Gamma(1 / (p + 1) + 1/2)). The end of the contact is
// accurate to a step, 3e-3 of its duration.
TEST(HowTo, ContactTimeAndRestitution) {
  for (const double p : {1.0, 1.5, 2.0, 2.5}) {
    const Power law{2e4, p, 0.0};
    const double speed = 0.4;
    const auto impact = head_on({law}, {.mass = 1.0, .reduced_mass = 0.5, .diameter = 1.0, .speed = speed});
    const double deepest = std::pow((p + 1.0) * 0.25 * speed * speed / law.stiffness, 1.0 / (p + 1.0));
    const double part = 1.0 / (p + 1.0);
    const double integral = std::sqrt(std::numbers::pi) * std::tgamma(part) * part / std::tgamma(part + 0.5);
    EXPECT_NEAR(impact.overlap / deepest, 1.0, 1e-4);
    EXPECT_NEAR(impact.duration / (2.0 * deepest / speed * integral), 1.0, 3e-3) << p;
  }
  const auto scene = scene_from_text(scene_text_of_power, "scene.toml");
  const auto impact =
      head_on({scene.contact.normal}, {.mass = 0.7, .reduced_mass = 0.2, .diameter = 0.8, .speed = 0.3});
  EXPECT_NEAR(impact.restitution, 0.6, 1e-4);
}

// In the soft method a grain rests at the overlap where k overlap^p is its weight.
TEST(HowTo, RunsInTheGeneralKernel) {
  auto settings = testing::settings_2d(1e-3, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  testing::SoftWorld<2, AnyPairLaw> world(any_pair_law({Power{1e4, 2.0, 0.5}, None{}, {}, {}}), settings);
  const auto grain = world.add({{0.0, 0.5}});
  world.advance(60000);
  EXPECT_NEAR(world[grain].position[1], 0.5 - 0.01, 1e-6);
}

}  // namespace
}  // namespace repose
