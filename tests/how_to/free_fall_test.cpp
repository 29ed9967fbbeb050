// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/scene/read.hpp"
#include "repose/simulation/simulation.hpp"
#include "support/memory_archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

// The method of docs/how-to/add-a-method.md: closed forms of free fall and of bounces, and what it gets from the
// program without a line of its own.

namespace repose {
namespace {

/// A floor at height 0 and two walls at x = -5 and 5, for grains of diameter 1; g = 1.
const std::string box = R"(
method = { kind = "free-fall" }
base = { kind = "none" }
plane = [{ point = [0.0, 0.0], normal = [0.0, 1.0] },
         { point = [-5.0, 0.0], normal = [1.0, 0.0] },
         { point = [5.0, 0.0], normal = [-1.0, 0.0] }]
)";

Scene scene_of(const std::string& more) { return scene_from_text(box + more, "scene.toml"); }

const Grain<2>& first_of(const Simulation<2>& simulation) { return simulation.grains().line.at(0); }

/// A wave that goes up and down between 0 and `top` at unit speed.
double triangle(double path, double top) {
  const double within = std::fmod(path, 2.0 * top);
  return within < top ? within : 2.0 * top - within;
}

// Dropped from 2 above the floor: each period of 2 sqrt(2 h / g) = 4 begins at the top. Times are those of bounces,
// each with a rounding of its own: 1e-12 after 250 of them.
TEST(FreeFall, BouncesBackToItsHeight) {
  Simulation simulation(scene_of("grain = [{ position = [0.0, 2.5] }]\nstop = { time = 1000 }\n"), 1);
  for (double time = 0.3; time < 999.0; time += 0.7) {
    EXPECT_EQ(simulation.advance(time).time, time);
    const double since_top = std::fmod(time + 2.0, 4.0) - 2.0;
    EXPECT_NEAR(first_of(simulation).position[1], 2.5 - 0.5 * since_top * since_top, 1e-11);
    EXPECT_NEAR(first_of(simulation).velocity[1], -since_top, 1e-11);
  }
  EXPECT_EQ(simulation.steps(), 250);
}

// Level flight between walls 9 apart for the centre, at speed 3: a triangle over time, whatever the height does.
TEST(FreeFall, CrossesTheBoxAndBack) {
  Simulation simulation(
      scene_of("grain = [{ position = [-4.5, 3.0], velocity = [3.0, 1.0] }]\nstop = { time = 300 }\n"), 1);
  for (double time = 0.11; time < 299.0; time += 0.37) {
    simulation.advance(time);
    EXPECT_NEAR(first_of(simulation).position[0], triangle(3.0 * time, 9.0) - 4.5, 1e-10);
  }
}

// A fall of 2 onto a plane of 45 degrees turns the velocity (0, -2) to (2, 0).
TEST(FreeFall, APlaneTurnsTheVelocity) {
  const auto scene = scene_from_text(
      "method = { kind = \"free-fall\" }\nbase = { kind = \"none\" }\nbox = { half_width = 100, floor = -100 }\n"
      "plane = [{ point = [0.0, 0.0], normal = [0.70710678118654752, 0.70710678118654752] }]\n"
      "grain = [{ position = [0.0, 2.7071067811865475] }]\nstop = { time = 3 }\n",
      "scene.toml");
  Simulation simulation(scene, 1);
  simulation.advance(2.5);
  EXPECT_NEAR(first_of(simulation).velocity[0], 2.0, 1e-12);
  EXPECT_NEAR(first_of(simulation).velocity[1], -0.5, 1e-12);
  EXPECT_NEAR(first_of(simulation).position[0], 1.0, 1e-12);
}

// Over whole periods the floor bears the weight: 20 periods of 4 in a run of 80, three grains of mass 1.
TEST(FreeFall, TheFloorBearsTheWeight) {
  Simulation simulation(scene_of("grain = [{ position = [0.0, 2.5] }, { position = [1.0, 2.5] },\n"
                                 "  { position = [2.0, 2.5], velocity = [0.3, 0.0] }]\n"
                                 "stop = { time = 80 }\noutput = { series = 4.0 }\n"),
                        1);
  simulation.run();
  const auto record = simulation.record();
  ASSERT_EQ(record.wall_series.size(), 3 * record.series.size());
  ASSERT_EQ(record.series.size(), 20U);
  double force = 0.0;
  for (std::size_t row = 0; row < 20; ++row) force += record.wall_series[3 * row].force[1] / 20.0;
  EXPECT_NEAR(force, -3.0, 1e-12);
}

TEST(FreeFall, KeepsTheEnergy) {
  Simulation simulation(
      scene_of("grain = [{ position = [0.0, 2.5], velocity = [1.3, 0.7] }]\nstop = { time = 1000 }\n"), 1);
  const auto energy = [&] {
    const auto& grain = first_of(simulation);
    return 0.5 * dot(grain.velocity, grain.velocity) + grain.position[1];
  };
  const double before = energy();
  simulation.run();
  EXPECT_GT(simulation.steps(), 300);
  EXPECT_NEAR(energy(), before, 1e-11);
}

// A grain at rest on the floor would bounce for ever.
TEST(FreeFall, AGrainAtRestIsTrouble) {
  Simulation simulation(scene_of("grain = [{ position = [0.0, 0.5] }]\nstop = { time = 1 }\n"), 1);
  EXPECT_EQ(simulation.run().status, Status::failed);
}

const std::string poured =
    "source = { kind = \"pour\", count = 30, rate = 3.0, height = 6, half_width = 3, velocity = [0.4, 0.0] }\n"
    "grains = { polydispersity = 0.5 }\nstop = { time = 37.3 }\noutput = { series = 0.7, track = 2.1 }\n";

void expect_same(const Record<2>& a, const Record<2>& b) {
  EXPECT_EQ(a.facts.state_hash, b.facts.state_hash);
  EXPECT_EQ(a.facts.time, b.facts.time);
  EXPECT_EQ(a.facts.steps, b.facts.steps);
  ASSERT_EQ(a.series.size(), b.series.size());
  ASSERT_EQ(a.wall_series.size(), b.wall_series.size());
  for (std::size_t k = 0; k < a.series.size(); ++k) {
    EXPECT_EQ(a.series[k].time, b.series[k].time);
    EXPECT_EQ(a.series[k].kinetic_energy_per_grain, b.series[k].kinetic_energy_per_grain);
    for (std::size_t w = 3 * k; w < 3 * k + 3; ++w) EXPECT_EQ(a.wall_series[w].force, b.wall_series[w].force);
  }
  EXPECT_EQ(a.track.size(), b.track.size());
}

// Pieces that no step divides, observers, a checkpoint in between: the bits stay.
TEST(FreeFall, PiecesObserversAndACheckpointLeaveTheBits) {
  const auto scene = scene_of(poured);
  Simulation whole(scene, 1);
  whole.run();
  EXPECT_EQ(whole.released(), 30);
  EXPECT_GT(whole.steps(), 150);
  Simulation first(scene, 1);
  std::vector<double> times;
  first.observe_every(0.3, [&](const Simulation<2>& s) { times.push_back(s.time()); });
  double time = 0.0;
  for (std::uint64_t k = 0; time < 20.0; ++k) {
    time += 0.4 * uniform(1, Purpose::release_position, k);
    EXPECT_EQ(first.advance(time).time, time);
  }
  ASSERT_GT(times.size(), 60U);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_EQ(times[k], static_cast<double>(k + 1) * 0.3);
  testing::MemoryArchive archive;
  first.exchange(archive);
  Simulation second(scene, 2);
  archive.restore = true;
  second.exchange(archive);
  second.restored(first.track());
  EXPECT_EQ(second.time(), time);
  while (!second.advance(time).stopped()) time += 0.77;
  expect_same(whole.record(), second.record());
}

}  // namespace
}  // namespace repose
