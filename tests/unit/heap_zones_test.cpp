// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/heap_zones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// A triangle of half-width 40 and height 20 about x = 5, with fields on a grid of cells of 0.5.
struct Triangle {
  HeapShape heap;
  Fields fields;

  template <class Fill>
  explicit Triangle(const Fill& fill) {
    for (int k = -40; k <= 40; ++k) heap.surface.push_back({5.0 + k, 20.0 * (1.0 - std::abs(k) / 40.0), true});
    heap.apex_x = 5.0;
    heap.apex_height = 20.0;
    heap.left = heap.right = FlankLine{.angle_deg = std::atan(0.5) * 180.0 / std::numbers::pi};
    for (double x = -39.75; x < 50.0; x += 0.5) fields.x.push_back(x);
    for (double y = 1.25; y < 22.0; y += 0.5) fields.y.push_back(y);
    for (const double y : fields.y) {
      for (const double x : fields.x) {
        fields.density.push_back(1.0);
        const auto [solid, xx, xy, yy] = fill(x - 5.0, y - 1.0);
        fields.solid_fraction.push_back(solid);
        fields.stress[0].push_back(xx);
        fields.stress[1].push_back(xy);
        fields.stress[2].push_back(xy);
        fields.stress[3].push_back(yy);
      }
    }
  }
};

struct Values {
  double solid, xx, xy, yy;
};

TEST(HeapZones, DensitiesOfTheColumnBelowTheApex) {
  // 0.7 at its half height, 0.9 near its base, 0.2 beside it
  const Triangle triangle([](double x, double height) {
    return Values{std::fabs(x) > 6.0 ? 0.2 : height > 7.0 ? 0.7 : 0.9, 1.0, 0.0, 2.0};
  });
  const auto zones = heap_zones(triangle.heap, triangle.fields, 1.0);
  ASSERT_TRUE(zones);
  EXPECT_NEAR(zones->middle_solid_fraction, 0.7, 1e-12);
  EXPECT_NEAR(zones->lower_solid_fraction, 0.9, 1e-12);
}

// A stress p1 = 3, p2 = 1 whose major axis leads outwards and down at a given angle on both flanks.
TEST(HeapZones, InclinationOfThePrincipalStress) {
  for (const double inclination : {20.0, 45.0, 60.0, 85.0}) {
    const double a = inclination * std::numbers::pi / 180.0;
    const Triangle triangle([&](double x, double) {
      const double down = x > 0.0 ? -std::sin(a) : std::sin(a);  // y of a unit vector with positive x along the axis
      return Values{0.8, 1.0 + 2.0 * std::cos(a) * std::cos(a), 2.0 * std::cos(a) * down,
                    1.0 + 2.0 * std::sin(a) * std::sin(a)};
    });
    const auto zones = heap_zones(triangle.heap, triangle.fields, 1.0);
    ASSERT_TRUE(zones);
    EXPECT_NEAR(zones->stress_inclination_deg, inclination, 1e-9);
    EXPECT_NEAR(zones->steeper_than_surface_deg, inclination - std::atan(0.5) * 180.0 / std::numbers::pi, 1e-9);
  }
}

TEST(HeapZones, NoneWithoutAHeap) { EXPECT_FALSE(heap_zones({}, {}, 0.0)); }

}  // namespace
}  // namespace repose
