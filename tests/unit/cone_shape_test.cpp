// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/cone_shape.hpp"

#include "repose/core/numbers.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double radius = 0.1;  // of the grains

/// Grains on a lattice of spacing 0.25 with their tops on a surface, given as a height above the axis; only where the
/// height is above 0.
Grains<3> surface(const std::function<double(double x, double y)>& height, const Vec<2>& axis = {}) {
  Grains<3> grains;
  std::int64_t id = 0;
  for (int i = -100; i <= 100; ++i) {
    for (int j = -100; j <= 100; ++j) {
      const double x = 0.25 * i;
      const double y = 0.25 * j;
      if (height(x, y) <= 0.0) continue;
      grains.add(unit_sphere({{axis[0] + x, axis[1] + y, height(x, y) - radius}}, false, radius), id++);
    }
  }
  return grains;
}

ConicalHeap measure(const Grains<3>& grains, double width, const std::optional<Vec<2>>& axis = std::nullopt) {
  return measure_cone(grains, std::vector<bool>(grains.size(), true), 0.0, width, axis);
}

// A cone of slope 0.5: the lattice reaches each inner edge of a patch to within 0.25, which shifts heights alike in all
// rings but for an eighth of the spacing's height: 0.03 over a flank 16 wide, 0.1 degrees.
TEST(ConeShape, ExactCone) {
  const Vec<2> axis{{3.0, -2.0}};
  const auto grains = surface([](double x, double y) { return 10.0 - 0.5 * std::hypot(x, y); }, axis);
  const auto cone = measure(grains, 1.0);
  EXPECT_NEAR(cone.axis[0], 3.0, 1e-9);
  EXPECT_NEAR(cone.axis[1], -2.0, 1e-9);
  EXPECT_NEAR(cone.apex_height, 10.0, 1e-9);
  const double expected = std::atan(0.5) * degrees_per_radian;
  ASSERT_TRUE(cone.line);
  EXPECT_NEAR(cone.line->angle_deg, expected, 0.2);
  EXPECT_EQ(cone.angle_deg.count, 8U);
  EXPECT_NEAR(cone.angle_deg.mean, expected, 0.2);
  EXPECT_LT(cone.angle_deg.error, 0.1);
  ASSERT_EQ(cone.surface.size(), 20U);
  EXPECT_FALSE(cone.surface[0].used);
  for (std::size_t k = 2; k < 18; ++k) {
    EXPECT_TRUE(cone.surface[k].used == (k >= 3 || cone.surface[k].height < 9.0)) << k;
    EXPECT_NEAR(cone.surface[k].height, 10.0 - 0.5 * (cone.surface[k].radius - 0.4), 0.1) << k;
  }
  // Below the surface, perpendicular to it: at the height 3 below a height of about 5.2.
  EXPECT_NEAR(depth_below_surface(cone, 10.0, 3.0), 2.2 / std::sqrt(1.25), 0.1);
  EXPECT_LT(depth_below_surface(cone, 10.0, 6.0), 0.0);
}

// Two halves of different slope: sectors of each half find theirs, and the scatter of eight sectors of which four lie
// a below and four a above the mean is a sqrt(8/7), its error a/sqrt(7).
TEST(ConeShape, SectorsScatter) {
  const auto grains = surface([](double x, double y) {
    const bool is_flat = y > 0.0 || (y == 0.0 && x > 0.0);  // azimuth in [0, 180)
    return 10.0 - (is_flat ? 0.5 : 0.6) * std::hypot(x, y);
  });
  const auto cone = measure(grains, 1.0, Vec<2>{});
  const double flat = std::atan(0.5) * degrees_per_radian;
  const double steep = std::atan(0.6) * degrees_per_radian;
  for (std::size_t k = 0; k < 8; ++k) {
    ASSERT_TRUE(cone.sector_lines[k]);
    EXPECT_NEAR(cone.sector_lines[k]->angle_deg, k < 4 ? flat : steep, 0.6) << k;
  }
  EXPECT_NEAR(cone.angle_deg.mean, 0.5 * (flat + steep), 0.3);
  EXPECT_NEAR(cone.angle_deg.error, 0.5 * (steep - flat) / std::sqrt(7.0), 0.1);
}

// A cone filled evenly: <z> = H/4 and <r> = R/2 about its own axis, so the estimate is atan(H/R). Lattice of 0.25 in a
// cone of 20 by 10; the lattice's own error of the means is of the order (0.25/20)^2. The mass of a grain counts:
// halving the mass and doubling the grains of one layer changes nothing.
TEST(ConeShape, MomentsOfAFullCone) {
  Grains<3> grains;
  std::int64_t id = 0;
  for (int i = -80; i <= 80; ++i) {
    for (int j = -80; j <= 80; ++j) {
      for (int k = 0; k < 40; ++k) {
        const Vec<3> at{{0.25 * i, 0.25 * j, 0.25 * (k + 0.5)}};
        if (at[2] > 10.0 - 0.5 * std::hypot(at[0], at[1])) continue;
        auto grain = unit_sphere(at, false, radius);
        if (k >= 20) {
          grain.mass = 0.5;
          grains.add(grain, id++);
        }
        grains.add(grain, id++);
      }
    }
  }
  const auto cone = measure(grains, 1.0);
  ASSERT_TRUE(cone.moments_angle_deg);
  EXPECT_NEAR(*cone.moments_angle_deg, std::atan(0.5) * degrees_per_radian, 0.05);
  // An axis off by e: <r> = R/2 grows by 3 e^2/(4 R), which is 3 % here.
  const auto off = measure(grains, 1.0, Vec<2>{{2.8, 0.0}});
  ASSERT_TRUE(off.moments_angle_deg);
  EXPECT_NEAR(*off.moments_angle_deg, std::atan(0.5 / (1.0 + 1.5 * 2.8 * 2.8 / 400.0)) * degrees_per_radian, 0.06);
}

// A bed has neither flanks nor an angle by moments; a heap that leans on a wall on one side has none by moments.
TEST(ConeShape, NoneForABed) {
  const auto bed = surface([](double x, double y) { return std::hypot(x, y) < 10.0 ? 5.0 : 0.0; });
  const auto flat = measure(bed, 1.0);
  EXPECT_EQ(flat.surface.size(), 10U);
  EXPECT_FALSE(flat.line);
  EXPECT_EQ(flat.angle_deg.count, 0U);
  EXPECT_FALSE(flat.moments_angle_deg);
  const auto leaning = surface([](double x, double y) { return x < 4.0 ? 10.0 - 0.5 * std::hypot(x, y) : 0.0; });
  EXPECT_FALSE(measure(leaning, 1.0, Vec<2>{}).moments_angle_deg);
  const auto rough = surface([](double x, double y) {
    const double r = std::hypot(x, y);
    return r < 10.0 ? 8.0 + 2.0 * std::cos(0.3 * r) : 0.0;  // from 10 down to 6
  });
  EXPECT_FALSE(measure(rough, 1.0).line);
  EXPECT_EQ(measure(rough, 1.0).angle_deg.count, 0U);
  const auto none = measure({}, 1.0);
  EXPECT_TRUE(none.surface.empty());
  EXPECT_FALSE(none.line);
}

// Grains beyond a gap, in flight, and other memory orders.
TEST(ConeShape, StrayGrainsAndOrder) {
  auto grains = surface([](double x, double y) { return 10.0 - 0.5 * std::hypot(x, y); });
  const auto alone = measure(grains, 1.0, Vec<2>{});
  grains.add(unit_sphere({{24.0, 0.0, 0.1}}, false, radius), 100000);
  grains.add(unit_sphere({{0.0, 0.0, 30.0}}, false, radius), 100001);
  std::vector<bool> in_heap(grains.size(), true);
  in_heap.back() = false;
  const auto with_stray = measure_cone(grains, in_heap, 0.0, 1.0, Vec<2>{});
  EXPECT_EQ(with_stray.surface.size(), alone.surface.size());
  EXPECT_EQ(with_stray.angle_deg.mean, alone.angle_deg.mean);
  std::vector<std::uint32_t> order;
  for (auto k = static_cast<std::uint32_t>(grains.size()); k-- > 0;) order.push_back(k);
  grains.reorder(order);
  std::reverse(in_heap.begin(), in_heap.end());
  const auto reversed = measure_cone(grains, in_heap, 0.0, 1.0);
  std::reverse(in_heap.begin(), in_heap.end());
  grains.reorder(order);
  const auto straight = measure_cone(grains, in_heap, 0.0, 1.0);
  EXPECT_EQ(reversed.axis, straight.axis);
  EXPECT_EQ(reversed.angle_deg.mean, straight.angle_deg.mean);
  EXPECT_EQ(reversed.moments_angle_deg, straight.moments_angle_deg);
}

}  // namespace
}  // namespace repose
