// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/results.hpp"
#include "repose/scene/read.hpp"
#include "repose/simulation/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

// Heaps of 600 discs against two independent implementations of Baxter et al. (1997), as corrected in
// docs/physics/soft.md: n = 36, r0 = 1.2, mu = 0.5, rate 0.62, height 100, settled 50 time units after the last grain
// has fallen. Ten seeds a point, two heaps at a time, about four minutes on two cores.

namespace repose {
namespace {

struct Heap {
  double angle = 0.0;
  double moments = 0.0;
  double dip = 0.0;
  double coordination = 0.0;
  double overlap = 0.0;
  double weight_error = 0.0;
};

Heap pour(double spacing, std::int64_t seed) {
  // The last of 600 grains is released at 966 and lands at 980, 50 time units before the end.
  const std::string text = fmt::format(
      "seed = {}\nmethod = {{ time_step = 0.001 }}\nbase = {{ kind = \"row\", spacing = {}, half_width = 75.0 }}\n"
      "source = {{ kind = \"pour\", count = 600, rate = 0.62, height = 100.0, half_width = 3.0 }}\n"
      "output = {{ window = 20.0 }}\nstop = {{ time = 1030.0 }}\n",
      seed, spacing);
  Simulation simulation(scene_from_text(text, "heap"), 1);
  simulation.run();
  const auto results = analyse(simulation.record());
  return {.angle = 0.5 * (results.heap.left.value().angle_deg + results.heap.right.value().angle_deg),
          .moments = results.heap.moments_angle_deg.value(),
          .dip = results.dip.value().index,
          .coordination = results.network.coordination.value(),
          .overlap = results.max_overlap,
          .weight_error = results.weight_error.value()};
}

std::vector<Heap> heaps(double spacing) {
  constexpr std::size_t seeds = 10;
  std::vector<Heap> all(seeds);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (auto k = next++; k < seeds; k = next++) all[k] = pour(spacing, static_cast<std::int64_t>(k) + 1);
  };
  std::thread other(work);
  work();
  other.join();
  return all;
}

struct Mean {
  double value = 0.0;
  double error = 0.0;  // standard error
};

Mean mean_of(const std::vector<Heap>& all, double Heap::*number) {
  const auto n = static_cast<double>(all.size());
  double sum = 0.0;
  for (const auto& heap : all) sum += heap.*number;
  double squares = 0.0;
  for (const auto& heap : all) squares += std::pow(heap.*number - sum / n, 2);
  return {sum / n, std::sqrt(squares / (n - 1.0) / n)};
}

void expect_mean(const std::vector<Heap>& all, double Heap::*number, double expected, double tolerance,
                 const std::string& name) {
  const auto mean = mean_of(all, number);
  fmt::print("{}: {:.4f} +- {:.4f} ({} seeds), expected {} +- {}\n", name, mean.value, mean.error, all.size(), expected,
             tolerance);
  EXPECT_NEAR(mean.value, expected, tolerance) << name;
}

void expect_weight_carried(const std::vector<Heap>& all) {
  double worst = 0.0;
  for (const auto& heap : all) worst = std::max(worst, std::fabs(heap.weight_error));
  fmt::print("base force against weight: off by {:.1e} at most\n", worst);
  EXPECT_LT(worst, 1e-3);
}

// Tolerances: three standard errors of the other implementations' runs and of ours together, for a standard deviation
// between seeds of 3.4 deg; 0.1 for the coordination (0.027 each) and 0.01 for the deepest overlap (0.002 each). The
// other implementations do not have the angle from moments. It weighs the flanks differently and must lie within 5 deg
// of their angle.
//
// At S = 1.1 these seeds give a dip index of 1.08 with a standard error of 0.05; the other implementations have 1.00
// with 0.04. The tolerance is two standard errors: it excludes a peak in the middle (0.92 with Hooke's law) and a dip
// deeper than that of the contiguous base (1.18).
TEST(HeapSlow, SpacingOfElevenTenths) {
  const auto all = heaps(1.1);
  expect_mean(all, &Heap::angle, 27.2, 3.5, "angle of repose, S = 1.1 [deg]");
  expect_mean(all, &Heap::moments, mean_of(all, &Heap::angle).value, 5.0, "angle from moments, S = 1.1 [deg]");
  expect_mean(all, &Heap::coordination, 4.55, 0.1, "coordination, S = 1.1");
  expect_mean(all, &Heap::overlap, 0.085, 0.01, "deepest overlap, S = 1.1");
  expect_mean(all, &Heap::dip, 1.08, 0.10, "dip index, S = 1.1");
  expect_weight_carried(all);
}

TEST(HeapSlow, ContiguousBase) {
  const auto all = heaps(1.0);
  expect_mean(all, &Heap::angle, 35.1, 3.5, "angle of repose, S = 1.0 [deg]");
  expect_mean(all, &Heap::moments, mean_of(all, &Heap::angle).value, 5.0, "angle from moments, S = 1.0 [deg]");
  expect_mean(all, &Heap::dip, 1.18, 0.11, "dip index, S = 1.0");  // three standard errors of 0.03 and 0.02
  expect_weight_carried(all);
}

}  // namespace
}  // namespace repose
