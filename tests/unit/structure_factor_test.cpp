// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/structure_factor.hpp"

#include "repose/analysis/statistics.hpp"
#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

using std::numbers::pi;

std::vector<Vec<2>> independent_points(std::size_t count, const Slab& slab, std::uint64_t seed) {
  return independent_discs(count, slab, seed).position;
}

TEST(StructureFactor, of_independent_points_is_one) {
  for (const auto window : {Window::none, Window::hann}) {
    for (const bool periodic : {true, false}) {
      const auto slab = slab_between(2.0, 14.0, sides(16.0, periodic));
      StructureFactorOptions options;
      options.largest = 10.0;
      options.shells = 40;
      options.window = window;
      std::vector<std::vector<double>> values(options.shells);
      std::vector<std::vector<double>> errors(options.shells);
      for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto found = isotropic_structure_factor(independent_points(200, slab, seed), slab, options);
        for (std::size_t k = 0; k < found.value.size(); ++k) {
          values[k].push_back(found.value[k]);
          errors[k].push_back(squared(found.error[k]));
        }
      }
      double squares = 0.0;
      double shells = 0.0;
      double error_ratio = 0.0;
      double large_shells = 0.0;
      for (std::size_t k = 0; k < options.shells; ++k) {
        if (values[k].empty()) continue;
        const auto estimate = mean_of(values[k]);
        const double off = (estimate.mean - 1.0) / estimate.error;
        EXPECT_LT(std::fabs(off), 4.5) << k;
        squares += off * off;
        shells += 1.0;
        if (k < 10) continue;  // with few vectors, the scatter does not determine the correlations
        error_ratio += std::sqrt(mean_of(errors[k]).mean) / estimate.deviation;
        large_shells += 1.0;
      }
      EXPECT_GE(shells, 36.0);                  // the first may hold no vector
      EXPECT_NEAR(squares / shells, 1.0, 0.9);  // 40 shells of 100 runs: four standard deviations
      // 30 shells of 100 runs determine it to 1.3 %; the factor for the window is exact for infinite rows only.
      EXPECT_NEAR(error_ratio / large_shells, 1.0, 0.1) << (window == Window::hann) << periodic;
    }
  }
}

TEST(StructureFactor, of_the_triangular_lattice_has_bragg_peaks_of_n) {
  // 12 columns and 10 pairs of rows: whole periods in both directions.
  const double rise = std::sqrt(0.75);
  const auto points = triangular_packing(12, 20).position;
  const auto slab = slab_between(0.0, 20 * rise, sides(12.0));
  const auto n = static_cast<double>(points.size());
  const Vec<2> first{{2.0 * pi, -2.0 * pi / std::sqrt(3.0)}};
  const Vec<2> second{{0.0, 4.0 * pi / std::sqrt(3.0)}};
  std::vector<Vec<2>> reciprocal;
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) reciprocal.push_back(first * a + second * b);
  }
  // Phases of up to 400 are accurate to 3e-14, S to twice that. S is zero elsewhere on the grid.
  for (const double peak : structure_factor(points, reciprocal, slab, Window::none)) EXPECT_NEAR(peak, n, 1e-10 * n);
  const std::vector<Vec<2>> elsewhere{{{2.0 * pi * 5 / 12, 0.0}}, {{2.0 * pi, 0.0}}, {{0.0, 2.0 * pi * 3 / 20 / rise}}};
  for (const double between : structure_factor(points, elsewhere, slab, Window::none)) EXPECT_NEAR(between, 0.0, 1e-20);
  // A Hann window over rows at multiples of the period has the sum 1/2 and the sum of squares 3/8 per row.
  for (const double peak : structure_factor(points, reciprocal, slab, Window::hann)) {
    EXPECT_NEAR(peak, 2.0 / 3.0 * n, 1e-10 * n);
  }
  // The first ring of six peaks, at 4 pi/sqrt 3, is one of the shells; q and -q count once.
  StructureFactorOptions options;
  options.largest = 8.0;
  options.shells = 80;
  options.window = Window::none;
  const auto shells = isotropic_structure_factor(points, slab, options);
  double total = 0.0;
  for (std::size_t k = 0; k < shells.value.size(); ++k) {
    total += shells.value[k] * static_cast<double>(shells.vectors[k]);
    if (shells.value[k] > 1.0) {
      EXPECT_NEAR(shells.wave_number[k], 4.0 * pi / std::sqrt(3.0), 0.1);
    }
  }
  EXPECT_NEAR(total, 3.0 * n, 1e-8 * n);
}

TEST(StructureFactor, shells_are_means_of_direct_sums) {
  const auto slab = slab_between(1.0, 8.0, sides(9.0));
  const auto points = independent_points(50, slab, 3);
  for (const auto window : {Window::none, Window::hann}) {
    StructureFactorOptions options;
    options.largest = 6.0;
    options.shells = 1;
    options.window = window;
    const auto one = isotropic_structure_factor(points, slab, options);
    std::vector<Vec<2>> vectors;
    for (int k = 0; k < 10; ++k) {
      for (int m = -10; m <= 10; ++m) {
        const Vec<2> q{{2.0 * pi * k / 9.0, 2.0 * pi * m / 7.0}};
        const bool of_mean = k == 0 && (m <= 0 || (window == Window::hann && m == 1));
        if (!of_mean && magnitude(q) <= 6.0) vectors.push_back(q);
      }
    }
    ASSERT_EQ(one.vectors.at(0), vectors.size());
    EXPECT_NEAR(one.value.at(0), mean_of(structure_factor(points, vectors, slab, window)).mean, 1e-12);
    // Every third vector in both directions, if only so many are allowed.
    options.most_vectors = vectors.size() / 7;
    const auto thinned = isotropic_structure_factor(points, slab, options);
    std::erase_if(vectors, [](const Vec<2>& q) {
      return std::lround(q[0] * 9.0 / (2.0 * pi)) % 3 != 0 || std::lround(q[1] * 7.0 / (2.0 * pi)) % 3 != 0;
    });
    ASSERT_EQ(thinned.vectors.at(0), vectors.size());
    EXPECT_NEAR(thinned.value.at(0), mean_of(structure_factor(points, vectors, slab, window)).mean, 1e-12);
  }
}

}  // namespace
}  // namespace repose
