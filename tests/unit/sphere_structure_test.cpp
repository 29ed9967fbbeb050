// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_structure.hpp"

#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double pi = std::numbers::pi;

std::vector<Vec<3>> random_points(std::size_t count, const Cuboid& cuboid, std::uint64_t seed) {
  std::vector<Vec<3>> points;
  for (std::uint64_t k = 0; k < count; ++k) {
    Vec<3> point = cuboid.low;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] += cuboid.side(axis) * random_number(k, static_cast<std::uint32_t>(axis), seed);
    }
    points.push_back(point);
  }
  return points;
}

// Face-centred cubic and periodic: 12, 6, 24, 12, 24, 8 neighbours at sqrt(1 ... 6), each counted for one of the two.
TEST(SphereStructure, ShellsOfFaceCentredCubic) {
  const double side = 5.0 * std::numbers::sqrt2;
  const auto centres = fcc_centres(5, 5);
  const Cuboid cuboid{.low = {}, .high = {{side, side, side}}, .periodic = {true, true, true}};
  const auto g = sphere_pair_correlation(centres, cuboid, 2.6, 0.02, 1.0);
  std::map<std::size_t, std::size_t> shells;  // pairs by bin
  const std::array<std::size_t, 6> neighbours{12, 6, 24, 12, 24, 8};
  for (std::size_t k = 0; k < 6; ++k) {
    shells[static_cast<std::size_t>((std::sqrt(static_cast<double>(k) + 1.0) + 2e-4) / 0.02)] =
        centres.size() * neighbours[k] / 2;
  }
  double expected_pairs = 0.0;
  for (std::size_t k = 0; k < g.pairs.size(); ++k) {
    EXPECT_EQ(g.pairs[k], shells.contains(k) ? shells[k] : 0U) << g.distance[k];
    expected_pairs += static_cast<double>(g.pairs[k]);
  }
  EXPECT_EQ(expected_pairs, 500.0 * 86.0 / 2.0);
  // The value of the first shell: pairs over the number density times the volume of the bin.
  const std::size_t first = 50;
  const double bin = 4.0 / 3.0 * pi * (std::pow(1.02 - 2e-4, 3) - std::pow(1.0 - 2e-4, 3));
  EXPECT_NEAR(g.value[first], 12.0 / (std::numbers::sqrt2 * 499.0 / 500.0 * bin), 1e-9);
}

// Independent points give 1, in an open cuboid too, within the error and the deviation from faces. In a periodic one by
// the sum of squares of deviations over errors too: over 38 bins with many pairs it has the mean 38 and the standard
// deviation 9; 4 of these, or a third of the mean.
TEST(SphereStructure, IdealGas) {
  for (int wraps = 0; wraps < 8; ++wraps) {
    const Cuboid cuboid{.low = {{1.0, -2.0, 3.0}},
                        .high = {{11.0, 10.0, 11.0}},
                        .periodic = {(wraps & 1) != 0, (wraps & 2) != 0, (wraps & 4) != 0}};
    const auto points = random_points(2000, cuboid, 3);
    const auto g = sphere_pair_correlation(points, cuboid, 4.0, 0.1, 1.0);
    ASSERT_EQ(g.value.size(), 40U);
    double chi_squared = 0.0;
    for (std::size_t k = 2; k < 40; ++k) {
      chi_squared += squared((g.value[k] - 1.0) / g.error[k]);
      const double of_faces = wraps == 7 ? 0.0 : 0.5 / std::sqrt(2000.0);
      EXPECT_NEAR(g.value[k], 1.0, 4.0 * std::hypot(g.error[k], of_faces)) << wraps << " " << k;
    }
    EXPECT_TRUE(wraps < 7 || chi_squared < 38.0 + 4.0 * 9.0) << chi_squared;
    EXPECT_GT(chi_squared, 38.0 / 3.0) << wraps;
  }
}

// The pairs against all pairs of points, at all distances within reach.
TEST(SphereStructure, PairsAgainstAllPairs) {
  const Cuboid cuboid{.low = {}, .high = {{6.0, 7.0, 8.0}}, .periodic = {true, false, true}};
  const auto points = random_points(300, cuboid, 4);
  const auto g = sphere_pair_correlation(points, cuboid, 9.0, 0.5, 1.0);
  ASSERT_EQ(g.value.size(), 6U);  // half of the shortest periodic side
  std::vector<std::size_t> pairs(6, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec<3> d = points[i] - points[j];
      d[0] -= 6.0 * std::round(d[0] / 6.0);
      d[2] -= 8.0 * std::round(d[2] / 8.0);
      const auto bin = static_cast<std::size_t>((magnitude(d) + 2e-4) / 0.5);
      if (bin < 6) ++pairs[bin];
    }
  }
  EXPECT_EQ(g.pairs, pairs);
  EXPECT_TRUE(sphere_pair_correlation({}, cuboid, 3.0, 0.1, 1.0).value.empty());
}

// Face-centred cubic: N at the reciprocal lattice (all indices even or all odd), 0 at the other multiples.
TEST(SphereStructure, BraggPeaks) {
  const double cell = std::numbers::sqrt2;
  const auto centres = fcc_centres(4, 4);
  const Cuboid cuboid{.low = {}, .high = {{4.0 * cell, 4.0 * cell, 4.0 * cell}}, .periodic = {true, true, true}};
  std::vector<Vec<3>> vectors;
  std::vector<double> expected;
  for (int h = 0; h < 4; ++h) {
    for (int k = 0; k < 4; ++k) {
      for (int l = 1; l < 4; ++l) {
        vectors.push_back(Vec<3>{{1.0 * h, 1.0 * k, 1.0 * l}} * (2.0 * pi / cell));
        expected.push_back(h % 2 == k % 2 && k % 2 == l % 2 ? 256.0 : 0.0);
      }
    }
  }
  const auto found = sphere_structure_factor(centres, vectors, cuboid, Window::none);
  for (std::size_t k = 0; k < vectors.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-8) << k;
  // The shell with the first peak, |q| = sqrt(3) 2 pi/cell, holds the 4 of 8 vectors (111) that are no negatives.
  StructureFactorOptions options;
  options.largest = 9.0;
  options.shells = 90;
  options.window = Window::none;
  const auto averaged = sphere_isotropic_structure_factor(centres, cuboid, options);
  double most = 0.0;
  double at = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < averaged.value.size(); ++k) {
    sum += averaged.value[k] * static_cast<double>(averaged.vectors[k]);
    if (averaged.value[k] > most) {
      most = averaged.value[k];
      at = averaged.wave_number[k];
    }
  }
  EXPECT_NEAR(at, std::sqrt(3.0) * 2.0 * pi / cell, 0.1);
  EXPECT_NEAR(sum, 256.0 * (4.0 + 3.0), 1e-6);  // and 3 of 6 (200), at 8.886
}

// The sum by repeated multiplication against the direct one, over all vectors and with a window along z.
TEST(SphereStructure, AverageOfTheDirectSums) {
  const Cuboid cuboid{.low = {{1.0, 2.0, 3.0}}, .high = {{5.0, 7.0, 9.0}}, .periodic = {true, true, false}};
  const auto points = random_points(100, cuboid, 5);
  StructureFactorOptions options;
  options.largest = 4.0;
  options.shells = 1;
  const auto averaged = sphere_isotropic_structure_factor(points, cuboid, options);
  std::vector<Vec<3>> vectors;
  for (int h = -3; h <= 3; ++h) {
    for (int k = -4; k <= 4; ++k) {
      for (int l = -4; l <= 4; ++l) {
        const Vec<3> q{{2.0 * pi * h / 4.0, 2.0 * pi * k / 5.0, 2.0 * pi * l / 6.0}};
        if (magnitude(q) <= 4.0 && !(h == 0 && k == 0 && std::abs(l) <= 1)) vectors.push_back(q);
      }
    }
  }
  const auto direct = sphere_structure_factor(points, vectors, cuboid, Window::hann);
  ASSERT_EQ(averaged.value.size(), 1U);
  EXPECT_EQ(2 * averaged.vectors[0], vectors.size());
  EXPECT_NEAR(averaged.value[0], mean_of(direct).mean, 1e-9);
}

// Independent points give 1 within the error, with the window and without it, and with few vectors.
TEST(SphereStructure, IdealGasScattersEvenly) {
  for (const auto window : {Window::none, Window::hann}) {
    const Cuboid cuboid{.low = {}, .high = {{8.0, 8.0, 8.0}}, .periodic = {true, true, window == Window::none}};
    const auto points = random_points(2000, cuboid, 6);
    StructureFactorOptions options;
    options.largest = 8.0;
    options.shells = 10;
    options.window = window;
    const auto all = sphere_isotropic_structure_factor(points, cuboid, options);
    options.most_vectors = 300;
    const auto few = sphere_isotropic_structure_factor(points, cuboid, options);
    std::size_t count = 0;
    for (const auto n : few.vectors) count += n;
    EXPECT_LE(count, 400U);
    for (std::size_t k = 3; k < 10; ++k) EXPECT_NEAR(all.value[k], 1.0, 4.0 * all.error[k]) << k;
    EXPECT_LT(all.error.back(), 0.06);
  }
}

}  // namespace
}  // namespace repose
