// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/repose.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace repose::api {
namespace {

/// Grains that rain on a row of fixed ones.
SceneDraft small_rain(const std::string& method) {
  SceneDraft draft;
  draft.set("method.kind", method).set("contact.friction", 0.5);
  draft.set("base.kind", "row").set("base.half_width", 6.0).set("box.x", "periodic").set("box.half_width", 6.0);
  draft.set("source.kind", "rain").set("source.count", 20).set("source.rate", 20.0);
  draft.set("source.height", 8.0).set("source.half_width", 6.0).set("stop.time", 4.0);
  return draft;
}

std::vector<std::string> problems_of(const SceneDraft& draft) {
  try {
    draft.checked();
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(Api, ASceneInMemoryIsTheSameAsItsText) {
  const auto draft = small_rain("soft");
  EXPECT_EQ(draft.checked().text(), Scene::from_text(draft.text()).text());
  EXPECT_NE(draft.checked().text().find("friction = 0.5"), std::string::npos);
}

TEST(Api, ASceneInMemoryIsCheckedLikeAFile) {
  auto draft = small_rain("soft");
  draft.set("grains.diameter", -1.0).set("source.colour", "red");
  const auto problems = problems_of(draft);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_NE((problems[0] + problems[1]).find("grains.diameter = -1: must be > 0"), std::string::npos);
  EXPECT_NE((problems[0] + problems[1]).find("source.colour"), std::string::npos);
}

TEST(Api, SettingsReplaceKeysAndDefaultsFollow) {
  const auto scene = small_rain("soft").checked().with({{"grains.diameter", 0.5}, {"seed", 7}});
  EXPECT_NE(scene.text().find("diameter = 0.5"), std::string::npos);
  EXPECT_NE(scene.text().find("seed = 7"), std::string::npos);
  EXPECT_NE(scene.text().find("bin_width = 1"), std::string::npos);  // twice the diameter
  EXPECT_THROW(scene.with({{"contact.friction", -1.0}}), InputError);
}

/// Advances in unequal pieces, with an observer.
std::string hash_in_pieces(const Scene& scene, int threads) {
  Simulation simulation(scene, threads);
  const double interval = simulation.time_step() * std::max(1.0, std::round(0.3 / simulation.time_step()));
  int calls = 0;
  simulation.observe_every(0.3, [&](const Simulation& seen) {
    ++calls;
    EXPECT_NEAR(seen.time(), interval * calls, 1e-9);  // 0.3 in whole steps
    EXPECT_LE(seen.grains().size(), 32u);
  });
  for (const double until : {0.37, 1.0, 1.0, 2.71}) {
    EXPECT_NEAR(simulation.advance(until), until, 0.5 * simulation.time_step() + 1e-12);
  }
  simulation.run();
  EXPECT_EQ(calls, std::floor(simulation.time() / interval + 1e-9));
  EXPECT_GE(calls, 12);
  return simulation.state_hash();
}

TEST(Api, AdvancesObserversAndThreadsChangeNoBit) {
  for (const auto* method : {"soft", "contact-dynamics"}) {
    const auto scene = small_rain(method).checked();
    Simulation whole(scene);
    whole.run();
    EXPECT_EQ(whole.status(), Status::finished);
    EXPECT_EQ(hash_in_pieces(scene, 1), whole.state_hash()) << method;
    EXPECT_EQ(hash_in_pieces(scene, 2), whole.state_hash()) << method;
  }
}

TEST(Api, ASavedStateResumesToTheSameBits) {
  const auto scene = small_rain("soft").checked();
  Simulation whole(scene);
  whole.run();
  const testing::TemporaryFolder folder;
  {
    Simulation first(scene);
    first.advance(1.234);
    first.save(folder.path());
    EXPECT_THROW(first.save(folder.path()), InputError);  // would replace it
  }
  auto second = Simulation::resume(folder.path());
  EXPECT_NEAR(second.time(), 1.234, second.time_step());
  second.run();
  EXPECT_EQ(second.state_hash(), whole.state_hash());
  EXPECT_EQ(value_of(measures(folder.path()), "grains"), 20.0);
  EXPECT_THROW(Simulation::resume(folder.path()), InputError);  // it is finished
}

TEST(Api, StateContactsAndMeasuresDescribeTheSameGrains) {
  Simulation simulation(small_rain("soft").checked().with({{"stop.time", 60.0}}));
  simulation.run();
  const auto grains = simulation.grains();
  ASSERT_EQ(grains.size(), 32u);  // 12 of the base
  double height = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    EXPECT_EQ(grains[k].id, static_cast<std::int64_t>(k));
    if (grains[k].fixed) {
      EXPECT_EQ(grains[k].velocity[1], 0.0);
    }
    height += grains[k].position[1];
  }
  EXPECT_GT(height, 0.0);
  // At rest the base carries 20 grains of weight 1, but for what still moves.
  double carried = 0.0;
  for (const auto& contact : simulation.contacts()) {
    EXPECT_NEAR(std::hypot(contact.normal[0], contact.normal[1]), 1.0, 1e-12);
    const double upward = contact.normal_force * contact.normal[1] + contact.tangential_force * contact.normal[0];
    const bool first = grains[static_cast<std::size_t>(contact.first)].fixed;
    const bool second = grains[static_cast<std::size_t>(contact.second)].fixed;
    if (first != second) carried += first ? -upward : upward;
  }
  EXPECT_NEAR(carried, 20.0, 0.1);
  EXPECT_EQ(value_of(simulation.measures(), "grains"), 20.0);
  EXPECT_THROW(value_of(simulation.measures(), "colour"), InputError);
}

TEST(Api, AnalysisOfAFolderGivesTheMeasuresOfTheRun) {
  const testing::TemporaryFolder folder;
  Simulation simulation(small_rain("soft").checked());
  simulation.write_to(folder.path());
  simulation.run();
  const auto before = measures(folder.path());
  const auto after = analyse(folder.path());
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(before[k].name, after[k].name);
    EXPECT_TRUE(before[k].value == after[k].value || std::isnan(before[k].value)) << before[k].name;
  }
}

TEST(Api, AnInterruptEndsTheRunAndKeepsIt) {
  const testing::TemporaryFolder folder;
  const auto scene = small_rain("soft").checked();
  Simulation whole(scene);
  whole.run();
  {
    Simulation simulation(scene);
    simulation.write_to(folder.path());
    simulation.observe_every(1.0, [&](const Simulation&) { simulation.interrupt(); });
    simulation.run();
    EXPECT_EQ(simulation.status(), Status::interrupted);
    EXPECT_LT(simulation.time(), 4.0);
  }
  auto resumed = Simulation::resume(folder.path());
  resumed.run();
  EXPECT_EQ(resumed.state_hash(), whole.state_hash());
}

TEST(Api, AnInterruptedAdvanceContinuesToTheSameBits) {
  const auto scene = small_rain("soft").checked();
  Simulation whole(scene);
  whole.advance(4.0);
  Simulation parts(scene);
  bool first = true;
  parts.observe_every(1.0, [&](const Simulation&) {
    if (first) parts.interrupt();
    first = false;
  });
  EXPECT_LT(parts.advance(4.0), 4.0);
  EXPECT_EQ(parts.status(), Status::running);
  EXPECT_EQ(parts.advance(4.0), whole.time());
  EXPECT_EQ(parts.state_hash(), whole.state_hash());
}

TEST(Api, ATableIsAValue) {
  const auto scene = small_rain("soft").checked();
  const auto springs = scene.with({{"contact.normal", Toml{"{ law = 'hooke', stiffness = 777.0 }"}}}).text();
  EXPECT_NE(springs.find("stiffness = 777"), std::string::npos);
  EXPECT_THROW(scene.with({{"contact.normal", Toml{"{ law = 'hook' }"}}}), InputError);
}

TEST(Api, TheoryGivesTablesWithUnits) {
  const auto table = predict("janssen", {{"height", 20.0}});
  EXPECT_FALSE(table.columns.empty());
  EXPECT_FALSE(table.columns.front().unit.empty());
  EXPECT_GE(models().size(), 12u);
  EXPECT_THROW(predict("janssen", {{"height", -1.0}}), InputError);
}

}  // namespace
}  // namespace repose::api
