// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/surface.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

SurfaceProfile profile_of(std::vector<double> height, bool periodic) {
  SurfaceProfile profile;
  profile.column = 0.5;
  profile.periodic = periodic;
  profile.height = std::move(height);
  return profile;
}

std::vector<std::size_t> doubling(std::size_t first, std::size_t last) {
  std::vector<std::size_t> windows;
  for (std::size_t l = first; l <= last; l *= 2) windows.push_back(l);
  return windows;
}

TEST(Surface, profile_is_the_highest_point_over_each_column) {
  Draw draw(1);
  for (const bool periodic : {true, false}) {
    Discs discs;
    for (int k = 0; k < 40; ++k) discs.add({{10.0 * draw(), 3.0 * draw()}}, 0.2 + draw());
    const auto profile = surface_profile(discs, sides(10.0, periodic), 0.26);
    ASSERT_EQ(profile.height.size(), 38u);
    EXPECT_NEAR(profile.column, 10.0 / 38.0, 1e-15);
    for (std::size_t k = 0; k < 38; ++k) {
      double highest = -1.0;
      constexpr int rays = 2000;
      for (int ray = 0; ray <= rays; ++ray) {
        const double x = (static_cast<double>(k) + static_cast<double>(ray) / rays) * profile.column;
        for (std::size_t j = 0; j < discs.size(); ++j) {
          for (const double image : {-10.0, 0.0, 10.0}) {
            if (!periodic && image != 0.0) continue;
            const double aside = x - discs.position[j][0] - image;
            const double rest = squared(discs.radius[j]) - aside * aside;
            if (rest >= 0.0) highest = std::max(highest, discs.position[j][1] + std::sqrt(rest));
          }
        }
      }
      // Rays 1.3e-4 apart miss a top by little, the end of a steep flank by up to sqrt(2 r 1.3e-4).
      EXPECT_GE(profile.height[k], highest - 1e-12) << k;
      EXPECT_LE(profile.height[k], highest + 0.02) << k;
    }
  }
}

TEST(Surface, discs_as_wide_as_their_columns_do_not_show_in_the_next) {
  Discs discs;
  for (int k = 0; k < 7; ++k) discs.add({{k + 0.5, static_cast<double>(k * k % 5)}}, 0.5);
  const auto profile = surface_profile(discs, sides(7.0), 1.0);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(profile.height[k], static_cast<double>(k * k % 5) + 0.5, 1e-14);
  EXPECT_NEAR(profile.x(3), 3.5, 1e-15);
}

TEST(Surface, columns_without_a_disc_are_left_out) {
  Discs discs;
  discs.add({{0.5, 1.0}}, 0.5);
  discs.add({{1.5, 3.0}}, 0.5);
  const auto profile = surface_profile(discs, sides(10.0), 1.0);
  EXPECT_TRUE(std::isnan(profile.height[5]));
  EXPECT_NEAR(roughness(profile), 1.0, 1e-15);
  EXPECT_TRUE(roughness_scaling(profile, {4, 5, 6}).window.empty());
  EXPECT_TRUE(std::isnan(roughness(surface_profile({}, sides(10.0), 1.0))));
}

TEST(Surface, windows_are_those_of_a_sum_over_all_places) {
  Draw draw(2);
  std::vector<double> height(50);
  for (auto& h : height) h = 1000.0 + draw();
  for (const bool periodic : {true, false}) {
    const auto scaling = roughness_scaling(profile_of(height, periodic), {2, 7, 50, 51});
    ASSERT_EQ(scaling.window.size(), 3u);
    for (std::size_t w = 0; w < 3; ++w) {
      const auto length = static_cast<std::size_t>(std::lround(scaling.window[w] / 0.5));
      double sum = 0.0;
      const std::size_t places = periodic ? 50 : 51 - length;
      for (std::size_t k = 0; k < places; ++k) {
        std::vector<double> part;
        for (std::size_t j = 0; j < length; ++j) part.push_back(height[(k + j) % 50]);
        sum += squared(mean_of(part).deviation) * static_cast<double>(length - 1) / static_cast<double>(length);
      }
      EXPECT_NEAR(scaling.width[w], std::sqrt(sum / static_cast<double>(places)), 1e-12);
    }
  }
}

TEST(Surface, a_brownian_profile_has_exponent_one_half) {
  // w(l)^2 = s^2 (l^2 - 1)/(6 l) for independent steps of variance s^2.
  Draw draw(3);
  std::vector<double> height{0.0};
  while (height.size() < (1u << 18)) height.push_back(height.back() + draw.normal());
  const auto scaling = roughness_scaling(profile_of(height, false), doubling(16, 1024));
  for (std::size_t k = 0; k < scaling.window.size(); ++k) {
    const double l = scaling.window[k] / 0.5;
    // 2^18/l independent windows, each with a relative deviation of its variance near 0.9.
    const double tolerance = 4.0 * 0.5 * 0.9 * std::sqrt(l) / 512.0;
    EXPECT_NEAR(scaling.width[k] / std::sqrt((l * l - 1.0) / (6.0 * l)), 1.0, tolerance) << l;
  }
  ASSERT_TRUE(scaling.exponent);
  EXPECT_NEAR(scaling.exponent->mean, 0.5, 4.0 * scaling.exponent->error);
  EXPECT_LT(scaling.exponent->error, 0.02);
}

TEST(Surface, a_planted_spectrum_has_its_widths_exactly_and_its_exponent) {
  // h = sum_k k^-(alpha + 1/2) cos(2 pi k x/L + phase): over all places of a window the modes do not mix, and the
  // variance of a cosine in a window of l is (1 - D^2)/2 on average, D = sin(pi k l/L) / (l sin(pi k/L)).
  constexpr std::size_t columns = 1 << 12;
  constexpr std::size_t modes = columns / 2 - 1;
  const double turn = std::numbers::pi / static_cast<double>(columns);
  for (const double alpha : {0.25, 0.5, 0.75}) {
    Draw draw(4);
    std::vector<double> height(columns, 0.0);
    std::vector<double> amplitude(modes + 1, 0.0);
    for (std::size_t k = 1; k <= modes; ++k) {
      amplitude[k] = std::pow(static_cast<double>(k), -alpha - 0.5);
      const double phase = 2.0 * std::numbers::pi * draw();
      for (std::size_t j = 0; j < columns; ++j) {
        height[j] += amplitude[k] * std::cos(2.0 * turn * static_cast<double>(k * j % columns) + phase);
      }
    }
    const auto scaling = roughness_scaling(profile_of(height, true), doubling(16, 128));
    for (std::size_t w = 0; w < scaling.window.size(); ++w) {
      const double l = scaling.window[w] / 0.5;
      double variance = 0.0;
      for (std::size_t k = 1; k <= modes; ++k) {
        const double angle = turn * static_cast<double>(k);
        variance += 0.5 * squared(amplitude[k]) * (1.0 - squared(std::sin(l * angle) / (l * std::sin(angle))));
      }
      EXPECT_NEAR(scaling.width[w] / std::sqrt(variance), 1.0, 1e-9) << alpha << " " << l;
    }
    ASSERT_TRUE(scaling.exponent);
    // The spectrum ends at two columns and at L: w(l) of 16 to 128 of 4096 columns bends by 0.05 at most.
    EXPECT_NEAR(scaling.exponent->mean, alpha, 0.05);
  }
}

TEST(Surface, the_error_of_the_exponent_is_that_of_an_ensemble) {
  std::vector<double> exponents;
  std::vector<double> errors;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Draw draw(seed);
    std::vector<double> height{0.0};
    while (height.size() < 4096) height.push_back(height.back() + draw.normal());
    const auto exponent = roughness_scaling(profile_of(height, false), doubling(8, 128)).exponent;
    ASSERT_TRUE(exponent);
    exponents.push_back(exponent->mean);
    errors.push_back(squared(exponent->error));
  }
  // 100 runs know a standard deviation to 7 %.
  EXPECT_NEAR(std::sqrt(mean_of(errors).mean) / mean_of(exponents).deviation, 1.0, 0.3);
}

TEST(Surface, random_towers_grow_with_exponent_one_half) {
  // Discs that pile up in independent columns: w^2 = n/L (1 - 1/L) of a multinomial (random deposition; Barabasi and
  // Stanley, Fractal Concepts in Surface Growth, 1995, chapter 4).
  constexpr std::size_t columns = 2000;
  Draw draw(5);
  Discs discs;
  std::vector<int> tower(columns, 0);
  for (std::size_t k = 0; k < columns; ++k) discs.add({{static_cast<double>(k) + 0.5, 0.0}}, 0.5, true);
  for (int n = 0; n < 200'000; ++n) {
    const auto k = static_cast<std::size_t>(draw() * columns);
    discs.add({{static_cast<double>(k) + 0.5, static_cast<double>(++tower[k])}}, 0.5);
  }
  const std::vector<std::size_t> numbers{2000, 5000, 10'000, 20'000, 50'000, 100'000, 200'000, 300'000};
  const auto growth = surface_growth(discs, sides(columns), 1.0, numbers);
  ASSERT_EQ(growth.deposited.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) {
    const auto n = static_cast<double>(numbers[k]);
    EXPECT_NEAR(growth.mean_height[k], 0.5 + n / columns, 1e-9);
    // The variance of 2000 columns is known to sqrt(2/2000) = 3.2 %, more for few discs; four deviations of its root.
    EXPECT_NEAR(growth.width[k] / std::sqrt(n / columns * (1.0 - 1.0 / columns)), 1.0, 0.08);
  }
  ASSERT_TRUE(growth.exponent);
  EXPECT_NEAR(growth.exponent->mean, 0.5, 4.0 * growth.exponent->error);
  EXPECT_LT(growth.exponent->error, 0.02);
  // The surface after n discs is that of a packing of n discs.
  Discs fewer = discs;
  fewer.position.resize(columns + 5000);
  fewer.radius.resize(columns + 5000);
  fewer.base.resize(columns + 5000);
  EXPECT_EQ(growth.width[1], roughness(surface_profile(fewer, sides(columns), 1.0)));
}

TEST(Surface, usual_windows_and_numbers) {
  const auto windows = usual_windows(profile_of(std::vector<double>(64, 0.0), true));
  EXPECT_EQ(windows, (std::vector<std::size_t>{4, 6, 8, 11, 16}));
  EXPECT_TRUE(usual_windows(profile_of({1.0, 2.0}, true)).empty());
  const auto numbers = usual_numbers(sticking_packing(32, 1000, 1), sides(32.0), 1.0);
  EXPECT_EQ(numbers.front(), 32u);
  EXPECT_EQ(numbers.back(), 1000u);
  EXPECT_EQ(numbers.size(), 12u);
}

TEST(Surface, a_flat_surface_has_no_exponent) {
  EXPECT_FALSE(roughness_scaling(profile_of(std::vector<double>(64, 3.0), true), {4, 8, 16}).exponent);
}

}  // namespace
}  // namespace repose
