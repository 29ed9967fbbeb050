// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/solid_fraction.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

using std::numbers::pi;

/// The area of a disc in a rectangle, by the midpoint rule with thin strips. The error of n strips is about r^2 n^-1.5,
/// from the ends of the chords.
double area_by_strips(const Vec<2>& centre, double radius, const Rectangle& rectangle) {
  constexpr int strips = 20'000;
  const double low = std::max(rectangle.low[1], centre[1] - radius);
  const double high = std::min(rectangle.high[1], centre[1] + radius);
  double area = 0.0;
  for (int k = 0; k < strips && high > low; ++k) {
    const double y = low + (k + 0.5) * (high - low) / strips - centre[1];
    const double half = std::sqrt(radius * radius - y * y);
    const double left = std::max(rectangle.low[0], centre[0] - half);
    const double right = std::min(rectangle.high[0], centre[0] + half);
    area += std::max(0.0, right - left) * (high - low) / strips;
  }
  return area;
}

TEST(SolidFraction, segments_have_their_closed_forms) {
  EXPECT_EQ(disc_area_below(2.0, -2.0), 0.0);
  EXPECT_EQ(disc_area_below(2.0, 3.0), 4.0 * pi);
  EXPECT_NEAR(disc_area_below(2.0, 0.0), 2.0 * pi, 1e-14);
  // At height r/2 the segment above has the angle 2 pi/3.
  EXPECT_NEAR(disc_area_below(1.0, 0.5), pi - (pi / 3.0 - std::sqrt(3.0) / 4.0), 1e-14);
  EXPECT_NEAR(disc_area_in_quadrant(2.0, 0.0, 0.0), pi, 1e-14);
  // The inscribed square and the segment beside it.
  const double a = std::sqrt(0.5);
  EXPECT_NEAR(disc_area_in({}, 1.0, {{{-a, -a}}, {{a, a}}}), 2.0, 1e-14);
  EXPECT_NEAR(disc_area_in({}, 1.0, {{{a, -a}}, {{2.0, a}}}), (pi - 2.0) / 4.0, 1e-14);
}

TEST(SolidFraction, areas_in_rectangles_agree_with_strips) {
  Draw draw(1);
  for (int k = 0; k < 400; ++k) {
    const Vec<2> centre{{draw() - 0.5, draw() - 0.5}};
    const double radius = 0.1 + draw();
    Rectangle rectangle{{{-draw(), -draw()}}, {{draw(), draw()}}};
    EXPECT_NEAR(disc_area_in(centre, radius, rectangle), area_by_strips(centre, radius, rectangle), 2e-6) << k;
  }
}

TEST(SolidFraction, lattices_have_their_exact_values_wherever_the_slab_is_cut) {
  const double rise = std::sqrt(0.75);
  for (const double low : {3.0, 3.2, 3.5 * rise}) {
    const auto box = sides(8.0);
    const auto triangular = solid_fraction(triangular_packing(8, 30), slab_between(low, low + 17 * rise, box), 4);
    // A slab of whole rows holds whole discs, in parts. The error is rounding only.
    EXPECT_NEAR(triangular.mean, pi / (2.0 * std::sqrt(3.0)), 1e-13);
    const auto square = solid_fraction(square_packing(8, 30), slab_between(low, low + 17.0, box), 4);
    EXPECT_NEAR(square.mean, pi / 4.0, 1e-13);
    EXPECT_NEAR(square.error, 0.0, 1e-13);  // all blocks of two columns are equal
  }
}

TEST(SolidFraction, random_discs_agree_with_strips_and_blocks_change_nothing) {
  for (const bool periodic : {true, false}) {
    const auto box = sides(12.0, periodic);
    const auto slab = slab_between(2.0, 9.0, box);
    Draw draw(2);
    Discs discs;
    double area = 0.0;
    for (int k = 0; k < 80; ++k) {
      discs.add({{12.0 * draw(), 11.0 * draw()}}, 0.2 + 0.4 * draw());
      for (const double image : {-12.0, 0.0, 12.0}) {
        if (!periodic && image != 0.0) continue;
        const Vec<2> centre = discs.position.back() + Vec<2>{{image, 0.0}};
        area += area_by_strips(centre, discs.radius.back(), {{{0.0, 2.0}}, {{12.0, 9.0}}});
      }
    }
    const double exact = solid_fraction(discs, slab, 1).mean;
    EXPECT_NEAR(exact, area / slab.area(), 1e-6);  // 80 discs of 1e-6 each over an area of 84
    for (const std::size_t blocks : {2, 7, 100}) EXPECT_NEAR(solid_fraction(discs, slab, blocks).mean, exact, 1e-13);
  }
}

TEST(SolidFraction, the_error_is_that_of_an_ensemble) {
  // Discs are placed independently (overlaps count twice), so blocks are correlated only through their edges.
  std::vector<double> values;
  std::vector<double> errors;
  const auto slab = slab_between(0.0, 20.0, sides(80.0));
  const auto wide =
      slab_between(-90.0, 110.0, sides(80.0));  // ten times as high, so that the number in the slab varies
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto estimate = solid_fraction(independent_discs(4000, wide, seed), slab, 8);
    values.push_back(estimate.mean);
    errors.push_back(squared(estimate.error));
  }
  // 200 runs determine a standard deviation to 5 %. It is 5 % smaller because the slab holds a tenth of a fixed number.
  EXPECT_NEAR(std::sqrt(mean_of(errors).mean) / mean_of(values).deviation, 1.0, 0.25);
}

}  // namespace
}  // namespace repose
