// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace repose {
namespace {

const std::string heap_text = R"(title = "a \"heap\""
[method]
time_step = "auto"
[contact]
friction = 0.4
normal = { law = "continuous", exponent = 36, cutoff = 1.2 }
[base]
kind = "row"
spacing = 1.1
half_width = 30
[[plane]]
point = [-30.0, 0.0]
normal = [1.0, 0.0]
[[grain]]
position = [0.0, 1.0]
diameter = 0.9
[source]
kind = "pour"
count = 10
rate = 0.62
[stop]
time = 50
)";

std::vector<std::string> problems_of(const std::string& text, const Overrides& overrides = {}) {
  try {
    read_scene_text(text, "scene.toml", overrides);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

bool any_contains(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(part) != std::string::npos; });
}

TEST(SceneRead, ValuesAndDefaults) {
  const auto scene = read_scene_text(heap_text, "scene.toml");
  EXPECT_EQ(scene.title, "a \"heap\"");
  EXPECT_FALSE(scene.method.time_step);
  EXPECT_EQ(std::get<Cumulative>(scene.contact.tangential).friction, 0.4);
  EXPECT_EQ(std::get<Continuous>(scene.contact.normal).whole_exponent, 37U);
  EXPECT_EQ(scene.base.spacing, 1.1);
  ASSERT_EQ(scene.planes.size(), 1U);
  ASSERT_EQ(scene.placed.size(), 1U);
  EXPECT_EQ(scene.placed[0].diameter, 0.9);
  EXPECT_EQ(scene.source.height, 100.0);
  EXPECT_FALSE(scene.stop.at_rest);
  // "auto" takes half a radian of the stiffest contact: that of the small placed grain here.
  EXPECT_NEAR(scene.time_step() * scene.contact_frequency(), 0.5, 1e-12);
}

// The complete scene reads back as itself, and says every key.
TEST(SceneWrite, RoundTrip) {
  const std::string hooke = R"(
units = "SI"
grains = { diameter = 2e-3, mass = 1.1e-5, polydispersity = 0.1 }
contact = { normal = { law = "hooke", stiffness = 0.1 }, tangential = { law = "linear", stiffness = 0.03 } }
base = { kind = "plane", smooth = true }
source = { kind = "pour", count = 5, rate = 10, height = 0.1 }
stop = { at_rest = 1e-5 }
)";
  for (const auto& text : {heap_text, hooke}) {
    const auto scene = read_scene_text(text, "scene.toml");
    const auto complete = scene_text(scene);
    const auto again = scene_text(read_scene_text(complete, "complete.toml"));
    EXPECT_EQ(complete, again);
    EXPECT_NE(complete.find("skin = "), std::string::npos);
  }
}

TEST(SceneRead, AllProblemsAtOnceWithFileLineAndKey) {
  const auto lines = problems_of(R"(
gravity = -1
[contact]
frictoin = 0.4
normal = { law = "continuous", cutoff = 0.9 }
[base]
kind = "row"
half_width = "wide"
[source]
kind = "pour"
count = 0
[stop]
time = 1
)");
  EXPECT_TRUE(any_contains(lines, "scene.toml:2: gravity = -1: must be >= 0"));
  EXPECT_TRUE(
      any_contains(lines, "scene.toml:4: contact.frictoin: unknown key; known here: friction, normal, tangential"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:5: contact.normal.cutoff = 0.9: must be >= 1"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:8: base.half_width = \"wide\": must be a number, is text"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:11: source.count = 0: must be a whole number from 1"));
  EXPECT_TRUE(any_contains(lines, "source.rate: missing"));
}

TEST(SceneRead, Overrides) {
  Overrides overrides;
  overrides.set = {"contact.friction=0.1", "title=plain words", "contact.normal.law=hooke",
                   "contact.normal.exponent = 12"};
  overrides.seed = 9;
  const auto lines = problems_of(heap_text, overrides);
  ASSERT_EQ(lines.size(), 2U);  // keys of the other law: the exponent from the command line, the cutoff from the file
  EXPECT_TRUE(any_contains(lines, "--set contact.normal.exponent = 12: contact.normal.exponent: unknown key"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:6: contact.normal.cutoff: unknown key"));
  overrides.set.resize(2);
  const auto scene = read_scene_text(heap_text, "scene.toml", overrides);
  EXPECT_EQ(scene.contact.friction, 0.1);
  EXPECT_EQ(scene.title, "plain words");
  EXPECT_EQ(scene.seed, 9);
}

TEST(SceneRead, UnstableStepIsRefusedWithTheLargestThatIsNot) {
  const auto step = [](const std::string& value) {
    Overrides overrides;
    overrides.set = {"method.time_step=" + value, "contact.normal.exponent=144"};
    return problems_of(heap_text, overrides);
  };
  const auto lines = step("0.001");
  ASSERT_EQ(lines.size(), 1U);
  const std::string mark = "not refused is ";
  const auto begin = lines[0].find(mark) + mark.size();
  const double largest = std::stod(lines[0].substr(begin));
  EXPECT_TRUE(step(std::to_string(0.99 * largest)).empty());
  EXPECT_FALSE(step(std::to_string(1.01 * largest)).empty());
}

}  // namespace
}  // namespace repose
