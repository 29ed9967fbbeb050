// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/simulation.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/random.hpp"
#include "repose/scene/read.hpp"
#include "support/memory_archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

// A run is the same to the bit however calls divide it into advances, with and without observers, and across a
// checkpoint.

namespace repose {
namespace {

struct Case {
  const char* name;
  const char* scene;
};

const Case cases[] = {{"soft", R"(
contact = { normal = { law = "hooke", stiffness = 5e3 }, tangential = { law = "linear", stiffness = 2e3 } }
grains = { polydispersity = 0.3 }
method = { time_step = 0.003 }
base = { kind = "row", half_width = 6 }
source = { kind = "pour", count = 40, rate = 6.0, height = 6, half_width = 3 }
load = [{ position = [0.0, 3.0], force = [0.5, -1.0], start = 8.0011 }]
stop = { time = 12.3 }
output = { track = 1.4, series = 0.7, window = 3.0 }
)"},
                      {"soft, every part of it", R"(
[contact]
friction = 0.5
normal = { law = "hertz", stiffness = 2e4, restitution = 0.6 }
tangential = { law = "mindlin" }
rolling = { law = "spring", friction = 0.1 }
cohesion = { law = "constant", force = 0.2 }
[base]
kind = "row"
half_width = 6
[box]
x = "periodic"
half_width = 8
[[wall]]
name = "pusher"
from = [-6.0, 0.6]
to = [-6.0, 5.0]
motion = "spring"
stiffness = 20.0
velocity = [0.05, 0.0]
mass = 30.0
[source]
kind = "rain"
count = 30
rate = 8.0
height_above = "apex"
height = 3
[stop]
time = 7.0
[output]
energy = true
series = 0.31
track = 0.31
)"},
                      {"contact dynamics", R"(
method = { kind = "contact-dynamics", tolerance = 1e-4, time_step = 0.02 }
base = { kind = "row", half_width = 6 }
source = { kind = "pour", count = 30, rate = 5.0, height = 5, half_width = 3 }
plane = [{ point = [-5.0, 0.0], normal = [1.0, 0.0], motion = "velocity", velocity = [0.05, 0.0], start = 2.0 }]
stop = { time = 9.0 }
output = { track = 2.0, series = 0.5, window = 2.0 }
)"},
                      {"contact dynamics, one by one", R"(
method = { kind = "contact-dynamics", tolerance = 1e-4 }
base = { kind = "contiguous", count = 8 }
source = { kind = "sequential", count = 12 }
box = { x = "periodic" }
stop = { at_rest = 1e-2 }
output = { series = 1.0 }
)"},
                      {"deposition", R"(
method = { kind = "deposition", critical_angle = 50 }
base = { kind = "contiguous", count = 20 }
source = { count = 333 }
output = { series = 50 }
)"}};

Simulation<2> make(const Case& one, int threads) {
  return Simulation(scene_from_text(one.scene, "scene.toml"), threads);
}

std::string bytes_of(const std::vector<SeriesRow>& rows) {
  static_assert(sizeof(SeriesRow) == 8 * 34, "no padding, whose bytes are arbitrary");
  return {reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(SeriesRow)};
}

/// Times at which a simulation was observed, with numbers that depend on the whole state.
struct Seen {
  std::vector<double> times;
  std::vector<double> heights;
  std::vector<double> forces;

  void observe(const Simulation<2>& simulation) {
    double height = 0.0;
    for (const auto k : by_id(simulation.grains())) height += simulation.grains().line[k].position[1];
    double force = 0.0;
    for (const auto& contact : simulation.contacts().list) force += contact.normal_force;
    times.push_back(simulation.time());
    heights.push_back(height);
    forces.push_back(force);
  }
};

void expect_same(const Record<2>& a, const Record<2>& b, const std::string& how) {
  EXPECT_EQ(a.facts.state_hash, b.facts.state_hash) << how;
  EXPECT_EQ(a.facts.time, b.facts.time) << how;
  EXPECT_EQ(a.facts.steps, b.facts.steps) << how;
  EXPECT_EQ(a.facts.grain_steps, b.facts.grain_steps) << how;
  EXPECT_EQ(a.facts.message, b.facts.message) << how;
  EXPECT_EQ(a.facts.released, b.facts.released) << how;
  EXPECT_EQ(a.facts.lost, b.facts.lost) << how;
  EXPECT_EQ(a.facts.support_force, b.facts.support_force) << how;
  EXPECT_EQ(a.facts.status, b.facts.status) << how;
  EXPECT_TRUE(bytes_of(a.series) == bytes_of(b.series)) << how;
  ASSERT_EQ(a.wall_series.size(), b.wall_series.size()) << how;
  for (std::size_t k = 0; k < a.wall_series.size(); ++k) {
    EXPECT_EQ(a.wall_series[k].displacement, b.wall_series[k].displacement) << how;
    EXPECT_EQ(a.wall_series[k].force, b.wall_series[k].force) << how;
  }
  EXPECT_EQ(a.base.normal, b.base.normal) << how;
  EXPECT_EQ(a.base.shear, b.base.shear) << how;
  EXPECT_EQ(a.base.window_start, b.base.window_start) << how;
  ASSERT_EQ(a.track.size(), b.track.size()) << how;
  for (std::size_t k = 0; k < a.track.size(); ++k) {
    EXPECT_EQ(a.track[k].time, b.track[k].time) << how;
    EXPECT_EQ(a.track[k].grains.size(), b.track[k].grains.size()) << how;
  }
}

/// Advances in pieces of random length, from a fraction of a step to many rows, until the run stops or a time is
/// reached.
void advance_in_pieces(Simulation<2>& simulation, double until, std::uint64_t seed) {
  double time = simulation.time();
  for (std::uint64_t k = 0; time < until; ++k) {
    const double size = uniform(seed, Purpose::release_position, k);
    const double step = simulation.time_step();
    time = std::min(until, time + step * std::pow(10.0, 3.0 * size - 0.5));
    const auto done = simulation.advance(time);
    EXPECT_EQ(done.time, simulation.time());
    if (done.stopped()) return;
    EXPECT_LE(std::fabs(done.time - time), 0.5 * step * (1.0 + 1e-6));
  }
}

constexpr double forever = std::numeric_limits<double>::infinity();

TEST(Simulation, PiecesAndObserversLeaveTheBits) {
  for (const auto& one : cases) {
    SCOPED_TRACE(one.name);
    auto whole = make(one, 1);
    EXPECT_TRUE(whole.run().stopped());
    const auto record = whole.record();
    ASSERT_EQ(record.facts.status, Status::finished) << record.facts.message;
    EXPECT_GT(record.series.size(), 5U);
    Seen alone;
    for (const int threads : {1, 2}) {
      auto pieces = make(one, threads);
      Seen often;
      Seen seldom;
      pieces.observe_every(1.7 * pieces.time_step(), [&](const Simulation<2>& s) { often.observe(s); });
      pieces.observe_every(37.0 * pieces.time_step(), [&](const Simulation<2>& s) { seldom.observe(s); });
      advance_in_pieces(pieces, forever, static_cast<std::uint64_t>(threads));
      expect_same(record, pieces.record(), std::to_string(threads) + " threads, in pieces");
      const auto copied = contacts_of(record).size;
      const auto last = pieces.last_record();
      expect_same(record, last, "the last record");
      EXPECT_EQ(copied, contacts_of(last).size);
      for (std::size_t k = 0; k < seldom.times.size(); ++k) {
        EXPECT_EQ(seldom.times[k], static_cast<double>(37 * (k + 1)) * pieces.time_step());
      }
      EXPECT_GE(static_cast<double>(seldom.times.size() + 1) * 37.0 * pieces.time_step(), record.facts.time);
      EXPECT_EQ(often.times.size(), static_cast<std::size_t>(record.facts.steps / 2));
      if (threads == 1) alone = seldom;
      EXPECT_EQ(alone.heights, seldom.heights);
      EXPECT_EQ(alone.forces, seldom.forces);
    }
  }
}

TEST(Simulation, PiecesAcrossACheckpointLeaveTheBits) {
  for (const auto& one : cases) {
    SCOPED_TRACE(one.name);
    auto whole = make(one, 1);
    Seen undisturbed;
    const double interval = 11.0 * whole.time_step();
    whole.observe_every(interval, [&](const Simulation<2>& s) { undisturbed.observe(s); });
    whole.run();
    for (const double part : {0.0, 0.21, 0.777}) {
      auto first = make(one, 2);
      Seen seen;
      first.observe_every(interval, [&](const Simulation<2>& s) { seen.observe(s); });
      advance_in_pieces(first, part * whole.time(), 5);
      first.advance(part * whole.time());
      testing::MemoryArchive archive;
      first.exchange(archive);
      auto second = make(one, 1);
      archive.restore = true;
      second.exchange(archive);
      second.restored(first.track());
      EXPECT_EQ(second.time(), first.time());
      second.observe_every(interval, [&](const Simulation<2>& s) { seen.observe(s); });
      advance_in_pieces(second, forever, 6);
      expect_same(whole.record(), second.record(), "a checkpoint at " + std::to_string(first.time()));
      EXPECT_EQ(seen.times, undisturbed.times);
      EXPECT_EQ(seen.forces, undisturbed.forces);
    }
  }
}

// After an advance the state is that at the end of the step nearest to the requested time.
TEST(Simulation, AdvancesToATimeAndNoFurther) {
  auto simulation = make(cases[0], 1);
  EXPECT_EQ(simulation.advance(0.0).time, 0.0);
  EXPECT_EQ(simulation.grains().size(), 14U);  // 13 base grains and the first of the source
  EXPECT_EQ(simulation.advance(0.37).time, 123 * 0.003);
  EXPECT_EQ(simulation.advance(0.37).time, 123 * 0.003);
  EXPECT_EQ(simulation.advance(0.1).time, 123 * 0.003);
  EXPECT_EQ(simulation.steps(), 123);
  EXPECT_TRUE(simulation.series().empty());
  EXPECT_EQ(simulation.status(), Status::running);
  simulation.advance(0.7);
  EXPECT_EQ(simulation.series().size(), 1U);
  const auto end = simulation.advance(1e9);
  EXPECT_TRUE(end.stopped());
  EXPECT_EQ(end.status, Status::finished);
  EXPECT_EQ(end.time, 4100 * 0.003);
  EXPECT_EQ(simulation.advance(1e9).time, end.time);
  EXPECT_THROW(simulation.advance(std::nan("")), InputError);
}

TEST(Simulation, APauseEndsAnAdvanceAndInterruptsARun) {
  auto simulation = make(cases[0], 1);
  int pauses = 0;
  const auto twice = [&] { return ++pauses < 2; };
  EXPECT_FALSE(simulation.advance(10.0, twice).stopped());
  EXPECT_EQ(pauses, 2);
  EXPECT_LT(simulation.time(), 10.0);
  pauses = 0;
  EXPECT_EQ(simulation.run(twice).status, Status::interrupted);
  EXPECT_EQ(simulation.message(), "interrupted");
}

// An observer that throws ends the advance at its time. The next advance does what else was due then.
TEST(Simulation, AnObserverThatThrowsLeavesTheRunSound) {
  for (const auto& one : cases) {
    SCOPED_TRACE(one.name);
    auto whole = make(one, 1);
    whole.run();
    auto simulation = make(one, 1);
    const double last = whole.time();
    int thrown = 0;
    simulation.observe_every(whole.time_step(), [&](const Simulation<2>& s) {
      if (s.steps() % 7 == 0 || s.time() == last) throw std::runtime_error("enough");
    });
    while (simulation.status() == Status::running) {
      try {
        simulation.advance(forever);
      } catch (const std::runtime_error&) {
        ++thrown;
      }
    }
    EXPECT_GE(thrown, static_cast<int>(whole.steps() / 7));
    expect_same(whole.record(), simulation.record(), "thrown out of");
  }
}

TEST(Simulation, ObserversNeedAnInterval) {
  auto simulation = make(cases[0], 1);
  for (const double interval : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(simulation.observe_every(interval, [](const Simulation<2>&) {}), InputError);
  }
}

}  // namespace
}  // namespace repose
