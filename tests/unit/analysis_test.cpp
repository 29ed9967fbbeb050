// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/heap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

Grain<2> disc(double x, double y, bool fixed = false) {
  Grain<2> grain;
  grain.position = {{x, y}};
  grain.radius = 0.5;
  grain.mass = 1.0;
  grain.inverse_mass = fixed ? 0.0 : 1.0;
  return grain;
}

/// Small discs on a fine lattice that fill the triangle with these slopes under the apex at `apex_x`.
Grains<2> triangle(double left_deg, double right_deg, double height, double apex_x) {
  constexpr double step = 0.1;
  Grains<2> grains;
  std::int64_t id = 0;
  for (double y = 0.5 * step; y < height; y += step) {
    const double left = apex_x - (height - y) / std::tan(left_deg * std::numbers::pi / 180.0);
    const double right = apex_x + (height - y) / std::tan(right_deg * std::numbers::pi / 180.0);
    for (double x = std::ceil(left / step) * step; x <= right; x += step) {
      auto grain = disc(x, y);
      grain.radius = 0.5 * step;
      grains.add(grain, id++);
    }
  }
  return grains;
}

// Flank lines through bin tops: a bin's highest grain stands at its upper edge, half a bin from its centre on both
// flanks alike, which shifts the line but leaves its slope. Tolerance: the lattice step over the height, in degrees.
TEST(Heap, AnglesOfAsymmetricTriangle) {
  const auto grains = triangle(25.0, 35.0, 20.0, 3.0);
  const auto shape = read_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
  ASSERT_TRUE(shape.left && shape.right);
  EXPECT_NEAR(shape.left->angle_deg, 25.0, 0.5);
  EXPECT_NEAR(shape.right->angle_deg, 35.0, 0.5);
  EXPECT_NEAR(shape.apex_height, 20.0, 0.2);
  EXPECT_GT(shape.left->slope, 0.0);
  EXPECT_LT(shape.right->slope, 0.0);
}

// Uniform triangle: <y> = h/3, <|x|> = b/3 with b its half-base, so the estimator gives the angle itself.
TEST(Heap, MomentsOfSymmetricTriangle) {
  for (const double angle : {20.0, 30.0, 40.0}) {
    const auto grains = triangle(angle, angle, 20.0, -1.0);
    const auto shape = read_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
    ASSERT_TRUE(shape.moments_angle_deg);
    EXPECT_NEAR(*shape.moments_angle_deg, angle, 0.3);
  }
}

TEST(Heap, SurfaceEndsAtAGapAndUsesTenToNinetyPercent) {
  Grains<2> grains;
  std::int64_t id = 0;
  for (const double x : {-9.0, -5.0, -3.0, -1.0, 1.0, 3.0, 5.0})
    grains.add(disc(x, 10.0 - std::fabs(x) * 2.0 + 1.0), id++);
  const auto shape = read_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
  ASSERT_EQ(shape.surface.size(), 6U);  // x = -9 lies beyond the empty bin at -7
  EXPECT_EQ(shape.surface.front().x, -5.0);
  // Tops: 1.5, 5.5, 9.5 | 9.5, 5.5, 1.5; the apex is the first of the highest.
  EXPECT_EQ(shape.apex_x, -1.0);
  EXPECT_EQ(shape.apex_height, 9.5);
  for (const auto& bin : shape.surface) EXPECT_EQ(bin.used, bin.height >= 0.95 && bin.height <= 8.55) << bin.x;
}

TEST(Heap, NothingThere) {
  const Grains<2> none;
  const auto shape = read_heap(none, {}, 0.0, 2.0);
  EXPECT_TRUE(shape.surface.empty());
  EXPECT_FALSE(shape.left || shape.right || shape.moments_angle_deg);
}

BaseProfile profile(double (*force)(double), double half_width, double shift) {
  BaseProfile base;
  for (int k = -100; k <= 100; ++k) {
    const double x = 0.5 * k;
    base.id.push_back(k);
    base.x.push_back(x);
    const double place = std::fabs(x - shift) / half_width;
    base.normal.push_back(place < 1.0 ? force(place) : 0.0);
    base.shear.push_back(0.0);
  }
  return base;
}

// A triangle gives (1 - 0.3) / (1 - 0.075) = 0.757 over the true half-width; the 10 % rule of the loaded part takes the
// outermost tenth off, which raises it to (1 - 0.27) / (1 - 0.0675) = 0.783. A plateau gives 1.
TEST(BaseDipIndex, TriangleAndPlateau) {
  const auto triangle_dip = base_dip(profile([](double p) { return 1.0 - p; }, 40.0, 3.0));
  ASSERT_TRUE(triangle_dip);
  EXPECT_NEAR(triangle_dip->index, (1.0 - 0.3 * 0.9) / (1.0 - 0.075 * 0.9), 0.01);
  EXPECT_NEAR(triangle_dip->centre, 3.0, 0.5);
  EXPECT_NEAR(triangle_dip->half_width, 36.0, 1.0);
  const auto plateau = base_dip(profile([](double) { return 2.0; }, 40.0, 0.0));
  ASSERT_TRUE(plateau);
  EXPECT_NEAR(plateau->index, 1.0, 1e-12);
  const auto dip = base_dip(profile([](double p) { return p < 0.15 ? 1.0 : 1.3; }, 40.0, 0.0));
  ASSERT_TRUE(dip);
  EXPECT_GT(dip->index, 1.2);
  EXPECT_FALSE(base_dip(profile([](double) { return 0.0; }, 40.0, 0.0)));
}

TEST(RunningMean, ShortensAtTheEnds) {
  const auto means = running_mean({1.0, 2.0, 6.0, 3.0}, 3);
  EXPECT_EQ(means, (std::vector<double>{1.5, 3.0, 11.0 / 3.0, 4.5}));
}

Contact<2> contact(std::int64_t first, std::int64_t second, Vec<2> normal, double force) {
  Contact<2> c;
  c.first = first;
  c.second = second;
  c.normal = normal;
  c.normal_force = force;
  return c;
}

// Three discs in a row on a plane, the middle one pressed by its neighbours; a weak contact does not count.
TEST(ForceNetwork, HandMade) {
  Grains<2> grains;
  for (int k = 0; k < 4; ++k) grains.add(disc(k, 0.5), k);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{-1, 0}}, 1.0), contact(1, 2, {{-1, 0}}, 1.0), contact(2, 3, {{-1, 0}}, 0.1)};
  for (int k = 0; k < 3; ++k) contacts.list.push_back(contact(k, plane_partner(0), {{0, 1}}, 1.0));
  const auto heap = supported(grains, contacts);
  const auto network = read_force_network(grains, contacts, heap, 0.2);
  EXPECT_EQ(network.contacts, 5U);
  EXPECT_NEAR(*network.coordination, 7.0 / 4.0, 1e-12);
  EXPECT_NEAR(network.connectivity[0], 0.25, 1e-12);
  EXPECT_NEAR(network.connectivity[2], 0.5, 1e-12);
  EXPECT_NEAR(network.connectivity[3], 0.25, 1e-12);
  EXPECT_NEAR(*network.anisotropy, 2.0 * (3.0 - 2.0) / 5.0, 1e-12);  // <nn> = diag(2/5, 3/5)
  EXPECT_NEAR(*network.direction_deg, 90.0, 1e-9);
}

TEST(ForceResidual, RestAndFreeFall) {
  Grains<2> grains;
  grains.add(disc(0.0, 0.0, true), 0);
  grains.add(disc(0.0, 1.0), 1);
  grains.add(disc(5.0, 9.0), 2);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{0, -1}}, 1.0)};
  EXPECT_NEAR(force_residual(grains, contacts, Vec<2>{{0.0, -1.0}}), 0.5, 1e-15);  // one rests, one falls
  EXPECT_TRUE(std::isnan(force_residual(grains, contacts, Vec<2>{})));
}

}  // namespace
}  // namespace repose
