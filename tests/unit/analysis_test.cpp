// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/core_region.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/analysis/statistics.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// Small discs on a fine lattice that fill the triangle with these slopes and its apex at `apex_x`.
Grains<2> triangle(double left_deg, double right_deg, double height, double apex_x) {
  constexpr double step = 0.1;
  Grains<2> grains;
  std::int64_t id = 0;
  for (double y = 0.5 * step; y < height; y += step) {
    const double left = apex_x - (height - y) / std::tan(left_deg * std::numbers::pi / 180.0);
    const double right = apex_x + (height - y) / std::tan(right_deg * std::numbers::pi / 180.0);
    for (double x = std::ceil(left / step) * step; x <= right; x += step) {
      auto grain = unit_disc(x, y);
      grain.radius = 0.5 * step;
      grains.add(grain, id++);
    }
  }
  return grains;
}

// Flank lines through bin tops: the highest grain of a bin lies at its upper edge, half a bin from its centre. This
// shifts the line on both flanks but does not change its slope. Tolerance: the lattice step over the height, in
// degrees.
TEST(Heap, AnglesOfAsymmetricTriangle) {
  const auto grains = triangle(25.0, 35.0, 20.0, 3.0);
  const auto shape = measure_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
  ASSERT_TRUE(shape.left && shape.right);
  EXPECT_NEAR(shape.left->angle_deg, 25.0, 0.5);
  EXPECT_NEAR(shape.right->angle_deg, 35.0, 0.5);
  EXPECT_NEAR(shape.apex_height, 20.0, 0.2);
  EXPECT_GT(shape.left->slope, 0.0);
  EXPECT_LT(shape.right->slope, 0.0);
}

// A uniform triangle has <y> = h/3 and <|x|> = b/3, b its half-base, so the estimator gives the exact angle.
TEST(Heap, MomentsOfSymmetricTriangle) {
  for (const double angle : {20.0, 30.0, 40.0}) {
    const auto grains = triangle(angle, angle, 20.0, -1.0);
    const auto shape = measure_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
    ASSERT_TRUE(shape.moments_angle_deg);
    EXPECT_NEAR(*shape.moments_angle_deg, angle, 0.3);
  }
}

TEST(Heap, SurfaceEndsAtAGapAndUsesTenToNinetyPercent) {
  Grains<2> grains;
  std::int64_t id = 0;
  for (const double x : {-9.0, -5.0, -3.0, -1.0, 1.0, 3.0, 5.0})
    grains.add(unit_disc(x, 10.0 - std::fabs(x) * 2.0 + 1.0), id++);
  const auto shape = measure_heap(grains, std::vector<bool>(grains.size(), true), 0.0, 2.0);
  ASSERT_EQ(shape.surface.size(), 6U);  // x = -9 lies beyond the empty bin at -7
  EXPECT_EQ(shape.surface.front().x, -5.0);
  // Tops: 1.5, 5.5, 9.5 | 9.5, 5.5, 1.5; the apex is the first of the highest.
  EXPECT_EQ(shape.apex_x, -1.0);
  EXPECT_EQ(shape.apex_height, 9.5);
  for (const auto& bin : shape.surface) EXPECT_EQ(bin.used, bin.height >= 0.95 && bin.height <= 8.55) << bin.x;
}

TEST(Heap, EmptyWithoutGrains) {
  const Grains<2> none;
  const auto shape = measure_heap(none, {}, 0.0, 2.0);
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

// A triangle gives (1 - 0.3) / (1 - 0.075) = 0.757 over the true half-width. The 10 % rule removes the outermost tenth,
// which raises it to (1 - 0.27) / (1 - 0.0675) = 0.783. A plateau gives 1.
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

// A triangle over its true half-width gives (1 - 0.30)/(1 - 0.075) = 0.757. Base grains half a diameter apart sample
// the means to 0.3 %.
TEST(BaseDipIndex, TriangleOverItsTrueHalfWidth) {
  const auto index = dip_index(profile([](double p) { return 1.0 - p; }, 40.0, 3.0), 3.0, 40.0);
  ASSERT_TRUE(index);
  EXPECT_NEAR(*index, 0.757, 0.005);
  EXPECT_FALSE(dip_index(profile([](double) { return 0.0; }, 40.0, 0.0), 0.0, 40.0));
  EXPECT_FALSE(dip_index({}, 0.0, 40.0));
}

// Rings of 0.15 half-widths: the load is 1.5 in the third (0.30-0.45) and 1 in all others.
TEST(MaxOverCentre, RingOfHigherLoad) {
  const auto ring = profile([](double p) { return p > 0.3 && p < 0.45 ? 1.5 : 1.0; }, 40.0, 0.0);
  const auto ratio = max_over_centre(ring, 0.0, 40.0);
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(*ratio, 1.5, 0.05);  // one of twelve base grains on each side lies on the edge of the ring
  EXPECT_NEAR(*max_over_centre(profile([](double p) { return 1.0 - p; }, 40.0, 0.0), 0.0, 40.0), 1.0, 1e-12);
  EXPECT_FALSE(max_over_centre({}, 0.0, 1.0));
}

// Forces alternate between 1.5 and 0.5: the running mean over five is 1 +- 0.1, so each force deviates by 0.4.
TEST(BaseScatter, AlternatingForces) {
  auto base = profile([](double) { return 1.0; }, 1000.0, 0.0);
  for (std::size_t k = 0; k < base.normal.size(); ++k) base.normal[k] = k % 2 == 0 ? 1.5 : 0.5;
  const auto scatter = base_scatter(base, 0.0, 40.0);
  ASSERT_TRUE(scatter);
  EXPECT_NEAR(*scatter, 0.4, 0.01);
  EXPECT_NEAR(*base_scatter(profile([](double) { return 3.0; }, 1000.0, 0.0), 0.0, 40.0), 0.0, 1e-12);
  EXPECT_FALSE(base_scatter(profile([](double) { return 0.0; }, 40.0, 0.0), 0.0, 40.0));
}

TEST(BinnedProfile, MeansAndErrors) {
  BaseProfile base;
  base.x = {-2.6, -2.4, 0.0, 2.4, 2.6};
  base.id = {0, 1, 2, 3, 4};
  base.normal = {1.0, 2.0, 4.0, 6.0, 8.0};
  base.shear = {0.0, -1.0, -3.0, -5.0, 0.0};
  const auto bins = binned(base, 5.0);
  EXPECT_EQ(bins.x, (std::vector<double>{-5.0, 0.0, 5.0}));
  EXPECT_EQ(bins.count, (std::vector<std::int64_t>{1, 3, 1}));
  EXPECT_DOUBLE_EQ(bins.normal[1], 4.0);
  EXPECT_DOUBLE_EQ(bins.normal_error[1], 2.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(bins.shear[1], -3.0);
  EXPECT_TRUE(std::isnan(bins.normal_error[0]));
}

TEST(Statistics, MeanDeviationAndError) {
  const auto estimate = mean_of({1.0, std::nan(""), 2.0, 6.0});
  EXPECT_EQ(estimate.count, 3U);
  EXPECT_DOUBLE_EQ(estimate.mean, 3.0);
  EXPECT_DOUBLE_EQ(estimate.deviation, std::sqrt(7.0));
  EXPECT_DOUBLE_EQ(estimate.error, std::sqrt(7.0 / 3.0));
  EXPECT_TRUE(std::isnan(mean_of({4.0}).error));
  EXPECT_TRUE(std::isnan(mean_of({}).mean));
}

// For the mean itself the jackknife gives the usual standard error.
TEST(Statistics, JackknifeOfTheMean) {
  const std::vector<double> values = {1.0, 4.0, 2.0, 8.0, 5.0};
  const auto estimate = jackknife(values.size(), [&](std::size_t without) {
    std::vector<double> kept;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (k != without) kept.push_back(values[k]);
    }
    return mean_of(kept).mean;
  });
  EXPECT_DOUBLE_EQ(estimate.mean, 4.0);
  EXPECT_NEAR(estimate.error, mean_of(values).error, 1e-14);
}

// A heap with slopes 1 and its apex at height 10. Depths are perpendicular to the flank.
TEST(Heap, DepthBelowTheSurface) {
  HeapShape shape;
  for (int k = -10; k <= 10; ++k) shape.surface.push_back({1.0 * k, 10.0 - std::abs(k), true});
  shape.left = FlankLine{1.0, 10.0, 45.0};
  shape.right = FlankLine{-1.0, 10.0, 45.0};
  EXPECT_NEAR(depth_below_surface(shape, 5.0, 5.0), 0.0, 1e-12);
  EXPECT_NEAR(depth_below_surface(shape, 5.0, 3.0), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(depth_below_surface(shape, -4.5, 3.5), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(depth_below_surface(shape, 5.0, 7.0), -std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(depth_below_surface(shape, 20.0, -1.0), std::sqrt(0.5), 1e-12);  // level beyond the last bin
  shape.right.reset();
  EXPECT_NEAR(depth_below_surface(shape, 5.0, 3.0), 2.0, 1e-12);
}

// A lattice pile of 30 rows: its core is the triangular packing with six contacts per grain (the two diagonals with
// their forces, and the horizontal contacts, which are added here).
TEST(CoreRegion, TriangularLattice) {
  auto pile = lattice_pile(30);
  for (std::size_t k = 0; k + 1 < pile.grains.size(); ++k) {
    if (pile.grains.line[k].position[1] == pile.grains.line[k + 1].position[1]) {
      pile.contacts.list.push_back(contact_between(pile.grains, k, k + 1, 0.5));
    }
  }
  const std::vector<bool> in_heap(pile.grains.size(), true);
  const auto heap = measure_heap(pile.grains, in_heap, 0.0, 2.0);
  const auto cells = voronoi({pile.grains, {}}, in_heap, {}, {});
  const auto core = measure_core(pile.grains, pile.contacts, heap, cells, 0.0, 4.0, 2.0, 0.2);
  EXPECT_GT(core.grains, 50U);
  EXPECT_NEAR(*core.solid_fraction, std::numbers::pi / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(*core.coordination, 6.0, 1e-12);
  const auto none = measure_core(pile.grains, pile.contacts, heap, cells, 0.0, 100.0, 2.0, 0.2);
  EXPECT_EQ(none.grains, 0U);
  EXPECT_FALSE(none.solid_fraction || none.coordination);
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

// Three discs in a row on a wall; the neighbours press on the middle one. A weak contact does not count.
TEST(ForceNetwork, HandMade) {
  Grains<2> grains;
  for (int k = 0; k < 4; ++k) grains.add(unit_disc(k, 0.5), k);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{-1, 0}}, 1.0), contact(1, 2, {{-1, 0}}, 1.0), contact(2, 3, {{-1, 0}}, 0.1)};
  for (int k = 0; k < 3; ++k) contacts.list.push_back(contact(k, wall_partner(0), {{0, 1}}, 1.0));
  const auto heap = supported(grains, contacts);
  const auto network = measure_force_network(grains, contacts, heap, 0.2);
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
  grains.add(unit_disc(0.0, 0.0, true), 0);
  grains.add(unit_disc(0.0, 1.0), 1);
  grains.add(unit_disc(5.0, 9.0), 2);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{0, -1}}, 1.0)};
  EXPECT_NEAR(force_residual(grains, contacts, Vec<2>{{0.0, -1.0}}), 0.5, 1e-15);  // one rests, one falls
  // Without gravity, over the mean normal force.
  EXPECT_NEAR(force_residual(grains, contacts, Vec<2>{}), 0.5, 1e-15);
  EXPECT_TRUE(std::isnan(force_residual(grains, Contacts<2>{}, Vec<2>{})));
}

}  // namespace
}  // namespace repose
