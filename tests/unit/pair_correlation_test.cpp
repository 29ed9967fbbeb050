// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pair_correlation.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// Checks one correlation over many packings: 1 in every bin, with correct errors.
void expect_one(const std::vector<Correlation>& runs, const char* name) {
  double squares = 0.0;
  double errors = 0.0;
  const auto bins = runs.front().value.size();
  ASSERT_GT(bins, 20u) << name;
  for (std::size_t k = 0; k < bins; ++k) {
    std::vector<double> values;
    double mean_error = 0.0;
    for (const auto& run : runs) {
      values.push_back(run.value[k]);
      mean_error += run.error[k] / static_cast<double>(runs.size());
    }
    const auto estimate = mean_of(values);
    const double off = (estimate.mean - 1.0) / estimate.error;
    EXPECT_LT(std::fabs(off), 4.5) << name << " at "
                                   << runs.front().distance[k];  // one of 400 bins exceeds this once in 400 tries
    squares += off * off / static_cast<double>(bins);
    errors += mean_error / estimate.deviation / static_cast<double>(bins);
  }
  EXPECT_NEAR(squares, 1.0, 0.65) << name;  // four standard deviations for 80 bins are 0.63
  EXPECT_NEAR(errors, 1.0, 0.12) << name;   // known to 1 % from 80 bins of 60 runs; pairs of a bin have common points
}

TEST(PairCorrelation, of_independent_points_is_one_at_every_distance) {
  for (const bool periodic : {true, false}) {
    // A slab lower than the reach, so that most rings extend beyond it.
    const auto slab = slab_between(3.0, 9.0, sides(20.0, periodic));
    std::vector<Correlation> radial, along_x, along_y;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const auto found = pair_correlation(independent_discs(400, slab, seed), slab, {8.0, 0.1, 0.25});
      radial.push_back(found.radial);
      along_x.push_back(found.along_x);
      along_y.push_back(found.along_y);
      along_y.back().value.resize(60);  // no two points are farther apart than the height of the slab
    }
    expect_one(radial, "radial");
    expect_one(along_x, "along x");
    expect_one(along_y, "along y");
  }
}

TEST(PairCorrelation, counts_equal_all_pairs) {
  for (const bool periodic : {true, false}) {
    const auto slab = slab_between(1.0, 15.0, sides(11.0, periodic));
    const auto everywhere = slab_between(0.0, 20.0, sides(11.0, periodic));
    const auto discs = independent_discs(500, everywhere, 7);
    const auto found = pair_correlation(discs, slab, {5.0, 0.2, 0.3});
    ASSERT_EQ(found.radial.pairs.size(), 25u);
    std::vector<std::size_t> radial(25, 0), along_x(25, 0), along_y(25, 0);
    const auto add = [](std::vector<std::size_t>& bins, double distance) {
      const double place = distance + 2e-4;  // bins begin 2e-4 below multiples of their width
      if (place < 25 * 0.2) ++bins.at(static_cast<std::size_t>(place / 0.2));
    };
    const auto inside = centres_in(discs, slab);
    for (std::size_t a = 0; a < inside.size(); ++a) {
      for (std::size_t b = a + 1; b < inside.size(); ++b) {
        const Vec<2> d = separation(discs.position[inside[a]], discs.position[inside[b]], slab.box);
        add(radial, magnitude(d));
        if (std::fabs(d[1]) < 0.3) add(along_x, std::fabs(d[0]));
        if (std::fabs(d[0]) < 0.3) add(along_y, std::fabs(d[1]));
      }
    }
    EXPECT_EQ(found.radial.pairs, radial);
    EXPECT_EQ(found.along_x.pairs, along_x);
    EXPECT_EQ(found.along_y.pairs, along_y);
  }
}

TEST(PairCorrelation, of_the_triangular_lattice_has_its_shells) {
  const double rise = std::sqrt(0.75);
  const auto slab = slab_between(0.5 * rise, 400.5 * rise, sides(12.0));
  const auto found = pair_correlation(triangular_packing(12, 402), slab, {4.0, 0.2, 0.25}).radial;
  const double density = 1.0 / rise;
  const auto neighbours = [&](std::size_t bin) {
    const double inner = static_cast<double>(bin) * 0.2 - 2e-4;
    return found.value[bin] * density * std::numbers::pi * (squared(inner + 0.2) - squared(inner));
  };
  // Shells at 1, sqrt 3, 2, sqrt 7, 3, each in one bin although 1, 2 and 3 are multiples of its width. The edges of a
  // slab of 346 diameters change the expected number by at most 1/346.
  for (const std::size_t empty : {3U, 4U, 6U, 7U, 9U, 11U, 12U, 14U}) EXPECT_EQ(found.value[empty], 0.0) << empty;
  EXPECT_NEAR(neighbours(5), 6.0, 0.02);
  EXPECT_NEAR(neighbours(8), 6.0, 0.02);
  EXPECT_NEAR(neighbours(10), 6.0, 0.03);
  EXPECT_NEAR(neighbours(13), 12.0, 0.06);
  EXPECT_NEAR(neighbours(15), 6.0, 0.04);
}

// Discs in contact, off by the tolerance of a solver, are in one bin; its centre is above contact.
TEST(PairCorrelation, has_contact_within_a_bin) {
  const auto slab = slab_between(0.0, 10.0, sides(20.0));
  for (const double off : {-1e-4, 0.0, 1e-4}) {
    Discs discs;
    for (const double x : {3.0, 4.0 + off}) {
      discs.position.push_back({{x, 5.0}});
      discs.radius.push_back(0.5);
      discs.base.push_back(false);
    }
    const auto found = pair_correlation(discs, slab);
    for (std::size_t k = 0; k < found.radial.pairs.size(); ++k) {
      EXPECT_EQ(found.radial.pairs[k], k == 10 ? 1U : 0U) << off;
      EXPECT_EQ(found.along_x.pairs[k], k == 10 ? 1U : 0U) << off;
    }
    EXPECT_NEAR(found.radial.distance[10], 1.0498, 1e-12);
    EXPECT_NEAR(found.radial.distance[0], 0.0499, 1e-12);
  }
}

TEST(PairCorrelation, is_cut_where_the_slab_ends_and_empty_for_one_disc) {
  const auto slab = slab_between(0.0, 3.9, sides(9.0));
  const auto found = pair_correlation(independent_discs(100, slab, 1), slab, {50.0, 0.5, 0.25});
  EXPECT_EQ(found.radial.value.size(), 9u);  // half a width
  EXPECT_TRUE(std::isnan(found.along_y.value.back()));
  EXPECT_TRUE(pair_correlation(independent_discs(1, slab, 1), slab).radial.value.empty());
}

}  // namespace
}  // namespace repose
