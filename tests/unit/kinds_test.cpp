// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/methods/method.hpp"
#include "repose/scene/bases/row.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/soft.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/reference.hpp"
#include "repose/scene/sources/drop.hpp"
#include "repose/scene/write.hpp"
#include "repose/simulation/simulation.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Kinds that are added from outside the library, each by one call: a scene names them, reads their keys, checks them,
// writes them and runs them, and messages and the reference list them.

namespace repose {
namespace {

/// Grains on ballistic paths that meet nothing.
class FreeFall final : public Method<2> {
 public:
  FreeFall(double gravity, double step) : gravity_(gravity), steps_{.length = step} {}

  TimeSteps time_steps() const override { return steps_; }
  double time() const override { return time_; }
  StepReport advance(Grains<2>& grains, double until, Team&) override {
    const double dt = until - time_;
    for (auto& grain : grains.line) {
      if (grain.fixed()) continue;
      grain.position += grain.velocity * dt + Vec<2>{{0.0, -0.5 * gravity_ * dt * dt}};
      grain.velocity[1] -= gravity_ * dt;
    }
    time_ = until;
    return {.time = time_, .steps = 1};
  }
  void grains_added(Grains<2>&) override {}
  void refresh(Grains<2>&, Team&) override {}
  void exchange(Archive& archive) override { archive.value("free_fall/time", time_); }

 private:
  double gravity_;
  TimeSteps steps_;
  double time_ = 0.0;
};

struct FreeFallMethod final : KindOf<FreeFallMethod, MethodKind> {
  static constexpr std::string_view kind = "free-fall";
  static constexpr std::string_view meaning = "on ballistic paths";

  double step = unset;  ///< [T]

  MethodTraits traits() const override { return {}; }
  void keys(const Scene&, Parameters& keys) override {
    keys.number("method.time_step", step, required, positive, "T", "of the paths");
  }
  void check(const Scene& scene, Problems& problems) const override {
    if (scene.gravity == 0.0) problems.problem("gravity", " = 0: nothing falls");
  }
  double automatic_step(const Scene&) const override { return step; }
  double time_step(const Scene&) const override { return step; }
  std::string describe(const Scene&) const override { return "paths            ballistic\n"; }
  using MethodKind::make;
  std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const override {
    return std::make_unique<FreeFall>(scene.gravity, step);
  }
};

/// Fixed grains up a slope.
struct StairsBase final : KindOf<StairsBase, BaseKind> {
  static constexpr std::string_view kind = "stairs";
  static constexpr std::string_view meaning = "fixed grains, each higher than the one before";

  std::int64_t count = 3;
  double rise = unset;  ///< [L]

  void keys(const Scene& scene, Parameters& keys) override {
    keys.integer("base.count", count, {.low = 1}, "grains");
    keys.number("base.rise", rise, {0.5 * scene.grains.diameter, "0.5 d"}, not_negative, "L", "of each over the last");
  }
  bool of_grains() const override { return true; }
  double reach(const Scene& scene) const override { return static_cast<double>(count) * scene.grains.diameter; }
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override {
    for (std::int64_t k = 0; k < count; ++k) {
      auto grain = make_grain(scene, scene.grains.diameter);
      grain.inverse_mass = 0.0;
      grain.position = {{static_cast<double>(k) * scene.grains.diameter, static_cast<double>(k) * rise}};
      grains.add(grain, id++, true);
    }
  }
};

std::string problems_of(const std::string& text) {
  try {
    scene_from_text(text, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class AddedKinds : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    method_kinds().add(FreeFallMethod{});
    base_kinds().add(StairsBase{});
  }
};

const std::string falling = R"(
method = { kind = "free-fall", time_step = 0.25 }
base = { kind = "stairs", count = 4, rise = 0.3 }
grain = [{ position = [0.0, 20.0], velocity = [1.0, 0.0] }]
stop = { time = 3.0 }
)";

TEST_F(AddedKinds, AreReadCheckedAndWritten) {
  const auto scene = scene_from_text(falling, "scene.toml");
  ASSERT_NE(scene.base.as<StairsBase>(), nullptr);
  EXPECT_EQ(scene.base.as<StairsBase>()->rise, 0.3);
  EXPECT_EQ(scene.time_step(), 0.25);
  const auto complete = scene_text(scene);
  EXPECT_NE(complete.find("rise = 0.3  # [L] of each over the last"), std::string::npos);
  EXPECT_EQ(scene_text(scene_from_text(complete, "again.toml")), complete);
  EXPECT_NE(problems_of("gravity = 0\n" + falling).find("gravity = 0: nothing falls"), std::string::npos);
  EXPECT_NE(problems_of("method = { kind = \"flying\" }\n").find("\"free-fall\""), std::string::npos);
}

// A method without force laws has none of their keys.
TEST_F(AddedKinds, CapabilitiesDecideTheKeys) {
  EXPECT_NE(problems_of(falling + "contact = { friction = 0.5 }\n").find("contact: unknown key"), std::string::npos);
  EXPECT_NE(problems_of(falling + "analysis = { moved = 1.0 }\n").find("analysis.moved: unknown key"),
            std::string::npos);
  EXPECT_NE(problems_of(falling + "output = { energy = true }\n").find("output.energy: unknown key"),
            std::string::npos);
}

TEST_F(AddedKinds, Run) {
  Simulation simulation(scene_from_text(falling, "scene.toml"), 1);
  simulation.run();
  EXPECT_EQ(simulation.status(), Status::finished);
  const auto& grains = simulation.grains();
  ASSERT_EQ(grains.size(), 5U);
  EXPECT_EQ(grains.line[3].position[1], 3 * 0.3);
  EXPECT_NEAR(grains.line[4].position[0], 3.0, 1e-12);
  EXPECT_NEAR(grains.line[4].position[1], 20.0 - 0.5 * 9.0, 1e-12);
}

TEST_F(AddedKinds, StandInTheReference) {
  const auto keys = all_keys();
  const auto rise = std::find_if(keys.begin(), keys.end(), [](const auto& key) { return key.key == "base.rise"; });
  ASSERT_NE(rise, keys.end());
  EXPECT_EQ(rise->fallback, "0.5 d");
  ASSERT_EQ(rise->conditions.size(), 1U);
  EXPECT_EQ(rise->conditions[0].values, std::vector<std::string>{"stairs"});
}

// A chosen kind is a value: changing a copy leaves the other as it is.
TEST(Kinds, CopiesAreDeep) {
  Scene one;
  RowBase row;
  row.half_width = 5.0;
  one.base = row;
  Scene other = one;
  row.half_width = 7.0;
  other.base = row;
  EXPECT_EQ(one.base.as<RowBase>()->half_width, 5.0);
  EXPECT_EQ(other.base.as<RowBase>()->half_width, 7.0);
}

// --- scenes that are filled in by hand

Scene heap_by_hand() {
  Scene scene;
  scene.title = "by hand";
  scene.contact.friction = 0.4;
  RowBase base;
  base.half_width = 20.0;
  scene.base = base;
  PourSource source;
  source.count = 30;
  source.rate = 2.0;
  scene.source = source;
  scene.stop.time = 10.0;
  return scene;
}

// What is left unset has the defaults of a file.
TEST(SceneByHand, IsThatOfTheSameFile) {
  const auto from_file = scene_from_text(R"(title = "by hand"
contact = { friction = 0.4 }
base = { kind = "row", half_width = 20 }
source = { kind = "pour", count = 30, rate = 2.0 }
stop = { time = 10.0 }
)",
                                         "scene.toml");
  EXPECT_EQ(scene_text(checked(heap_by_hand())), scene_text(from_file));
}

TEST(SceneByHand, ListsAndLawsAndMotions) {
  auto scene = heap_by_hand();
  scene.contact.normal = Hooke{};
  scene.materials = {{.name = "stone"}, {.name = "wood", .density = 0.5}};
  SprungPiston piston;
  piston.velocity = {1.0, 0.0};
  piston.stiffness = 10.0;
  piston.mass = 100.0;
  SceneWall wall;
  wall.from = {-15.0, 0.0};
  wall.to = {-15.0, 8.0};
  wall.motion = piston;
  scene.pieces = {wall};
  const auto complete = checked(scene);
  ASSERT_EQ(complete.pieces.size(), 1U);
  EXPECT_EQ(complete.pieces[0].name, "wall 0");
  EXPECT_EQ(complete.pieces[0].material, "stone");
  EXPECT_EQ(make_walls(complete)[0].motion.stiffness, 10.0);
  EXPECT_EQ(std::get<Hooke>(complete.contact.normal).stiffness, 500.0);
}

// The same checks, with messages that begin with the key.
TEST(SceneByHand, AllProblemsAtOnce) {
  auto scene = heap_by_hand();
  PourSource source;
  source.count = 30;
  scene.source = source;
  scene.contact.friction = -1.0;
  scene.base = Chosen<BaseKind>();
  scene.box.half_width = 1.0;
  scene.stop.time.reset();
  try {
    checked(scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems(),
              (std::vector<std::string>{"contact.friction = -1: must be >= 0",
                                        "source.rate: missing: grains per time; the first at time 0",
                                        "source.half_width = 3: the opening must lie within the box, x = +-1",
                                        "stop: missing: give time, at_rest or both; the run ends at whichever comes "
                                        "first"}));
  }
}

// --- the reference

TEST(Reference, EveryKeyOfEveryExampleIsListed) {
  const auto keys = all_keys();
  EXPECT_GT(keys.size(), 100U);
  for (const auto& key : keys) {
    EXPECT_FALSE(key.about.empty()) << key.key;
    EXPECT_FALSE(key.methods.empty()) << key.key;
  }
  const auto listed = [&](const std::string& name) {
    return std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return key.key == name; });
  };
  for (const auto* name :
       {"seed", "method.critical_angle", "method.overlap_recovery", "contact.normal.impact_speed", "pair[].normal.law",
        "contact.dynamic_friction", "species[].sizes.passing", "base.roughness", "wall[].stiffness", "load[].position",
        "start.at_rest", "source.jitter", "source.rest", "output.energy", "analysis.contact_gap"}) {
    EXPECT_TRUE(listed(name)) << name;
  }
}

// A default that follows from other keys says so by a rule: with other units of length, mass and time it would be
// another number.
TEST(Reference, DefaultsThatDependOnScalesHaveRules) {
  const auto with_scales = [](const std::string& more) {
    return scene_from_text(
        "contact = { normal = { law = \"hooke\", stiffness = 1.0 } }\n"
        "grain = [{ position = [0.0, 1.0] }]\nstop = { time = 1.0 }\n" +
            more,
        "scene.toml");
  };
  const auto reduced = scene_text(with_scales(""));
  const auto scaled = scene_text(with_scales("grains = { diameter = 3.0, mass = 5.0 }\ngravity = 2.0\n"));
  const auto keys = all_keys();
  std::size_t at = 0;
  std::size_t other = 0;
  std::string table;
  int found = 0;
  while (at < reduced.size() && other < scaled.size()) {
    const auto line = reduced.substr(at, reduced.find('\n', at) - at);
    const auto line_scaled = scaled.substr(other, scaled.find('\n', other) - other);
    at += line.size() + 1;
    other += line_scaled.size() + 1;
    if (line.starts_with("[")) table = line.substr(line.find_first_not_of('['), line.find(']') - line.rfind('[') - 1);
    if (line == line_scaled || line.starts_with("[")) continue;
    const auto name = line.substr(0, line.find(' '));
    if (name == "gravity" || table == "grains") continue;
    const auto key = table == "grain" ? "grain[]." + name : table + "." + name;
    ++found;
    const auto has_rule = [&](const auto& text) {
      return text.key == key && text.fallback.find_first_of("dg") != std::string::npos;
    };
    EXPECT_TRUE(std::any_of(keys.begin(), keys.end(), has_rule)) << key;
  }
  EXPECT_GT(found, 8);
}

}  // namespace
}  // namespace repose
