// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_rings.hpp"

#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.1;
constexpr double outer = 20.0;  // radius of the heap

/// Loads of a pressure p(r) on a square lattice of base grains, with a shear of 0.3 p outwards and 0.2 p along the
/// azimuth. The axis lies between lattice points.
std::vector<BaseLoad> loads_of(const std::function<double(double)>& pressure, const Vec<2>& axis = {}) {
  std::vector<BaseLoad> loads;
  for (double x = -22.0 + 0.5 * spacing; x < 22.0; x += spacing) {
    for (double y = -22.0 + 0.5 * spacing; y < 22.0; y += spacing) {
      const double r = std::hypot(x, y);
      const double force = r < outer ? pressure(r) * spacing * spacing : 0.0;
      loads.push_back(
          {{{axis[0] + x, axis[1] + y}}, {{force * (0.3 * x - 0.2 * y) / r, force * (0.3 * y + 0.2 * x) / r, -force}}});
    }
  }
  return loads;
}

double cone(double r) { return 2.0 * (1.0 - r / outer); }

// A full cone: p = 2 (1 - r/R) in every ring, the load pi R^2 2/3, the loaded radius 0.9 R. Its index is 0.75 over the
// true radius and 2.1225/2.73 over the loaded one. Tolerances: the number of lattice points in a circle of n spacings
// scatters by about n^(1/2); the smallest circle, 0.15 R, has 30. An eighth of the innermost ring has 39 points, of
// which those on a diagonal belong to one of two sectors.
TEST(BaseRings, FullCone) {
  const Vec<2> axis{{5.0, -7.0}};
  const auto loads = loads_of(cone, axis);
  for (const bool by_number : {false, true}) {
    BaseRingSettings settings{.axis = axis, .width = 1.0};
    if (by_number) settings.area_of_load = spacing * spacing;
    const auto base = measure_base_rings(loads, settings);
    const double all = pi * outer * outer * 2.0 / 3.0;
    EXPECT_NEAR(base.load, all, 1e-4 * all);
    ASSERT_TRUE(base.loaded_radius);
    EXPECT_NEAR(*base.loaded_radius, 0.9 * outer, 0.02);
    ASSERT_GE(base.rings.size(), 20U);
    for (std::size_t k = 0; k < 20; ++k) {
      const auto& ring = base.rings[k];
      // The mean of r over a ring, by area.
      const double a = ring.inner;
      const double b = ring.outer;
      const double mean_r = 2.0 / 3.0 * (a * a + a * b + b * b) / (a + b);
      EXPECT_NEAR(ring.pressure, cone(mean_r), by_number ? 0.005 : 0.03) << k;
      EXPECT_NEAR(ring.shear, 0.3 * ring.pressure, 1e-9);
      EXPECT_LT(ring.pressure_error, 0.08);
      EXPECT_NEAR(ring.area, pi * (b * b - a * a), by_number ? 0.03 * ring.area : 1e-9);
      const double x = b / outer;
      EXPECT_NEAR(ring.cumulative, all * (3.0 * x * x - 2.0 * x * x * x), 0.01 * all * x);
    }
    EXPECT_NEAR(base.rings.back().cumulative, base.load, 1e-9 * all);
    ASSERT_TRUE(base.dip_index);
    EXPECT_NEAR(base.dip_index->mean, 2.1225 / 2.73, 0.005);
    EXPECT_LT(base.dip_index->error, 0.01);
    EXPECT_NEAR(dip_index(loads, settings, outer)->mean, 0.75, 0.005);
  }
}

// A plateau has the index 1, and a loaded radius of sqrt(0.972) R; a pressure that rises from the axis has a dip.
TEST(BaseRings, PlateauAndDip) {
  const BaseRingSettings settings{.axis = {}, .width = 1.0, .area_of_load = spacing * spacing};
  const auto plateau = measure_base_rings(loads_of([](double) { return 3.0; }), settings);
  EXPECT_NEAR(*plateau.loaded_radius, std::sqrt(0.972) * outer, 0.02);
  EXPECT_NEAR(plateau.dip_index->mean, 1.0, 1e-12);
  EXPECT_NEAR(plateau.rings[7].pressure, 3.0, 1e-12);
  EXPECT_NEAR(plateau.rings[7].pressure_error, 0.0, 1e-12);
  // p = 1 + r/5 within 10, by areas: (1 + 2/15 a) for a circle of radius a, and a ring's mean of r as above.
  const auto loads = loads_of([](double r) { return r < 10.0 ? 1.0 + 0.2 * r : 0.0; });
  const double mean_r = 2.0 / 3.0 * (9.0 + 27.0 + 81.0) / 12.0;
  EXPECT_NEAR(dip_index(loads, settings, outer)->mean, (1.0 + 0.2 * mean_r) / (1.0 + 0.2 * 2.0), 0.005);
}

// Sectors in turn 10 % above and below the mean: a standard deviation of 0.1 sqrt(8/7) and an error of 0.1/sqrt(7), in
// each ring. The index, a ratio of forces in the same sectors, has none of it; where the outer zone alone varies, it
// has.
TEST(BaseRings, ErrorsOverSectors) {
  auto loads = loads_of([](double) { return 1.0; });
  auto outer_alone = loads;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const auto& place = loads[k].place;
    double turn = std::atan2(place[1], place[0]) / (2.0 * pi);
    if (turn < 0.0) turn += 1.0;
    const double factor = static_cast<int>(turn * 8.0) % 2 == 0 ? 1.1 : 0.9;
    loads[k].force *= factor;
    if (magnitude(place) > 0.15 * outer) outer_alone[k].force *= factor;
  }
  const BaseRingSettings settings{.axis = {}, .width = 2.0};
  const auto base = measure_base_rings(loads, settings);
  for (std::size_t k = 1; k < 10; ++k) {
    EXPECT_NEAR(base.rings[k].pressure, 1.0, 0.01);
    EXPECT_NEAR(base.rings[k].pressure_error, 0.1 / std::sqrt(7.0), 0.005) << k;
    EXPECT_NEAR(base.rings[k].shear_error, 0.03 / std::sqrt(7.0), 0.0015);
  }
  EXPECT_LT(dip_index(loads, settings, outer)->error, 0.01);
  EXPECT_NEAR(dip_index(outer_alone, settings, outer)->error, 0.1 / std::sqrt(7.0), 0.006);
}

// Forces from contacts: a pyramid on a floor, whose loads sum to its weight, and one sphere on three base grains.
TEST(BaseRings, LoadsFromContacts) {
  const SquarePyramid pyramid(4);
  const auto on_floor = loads_on_walls({pyramid.grains, Box<3>{}}, pyramid.contacts, {true});
  EXPECT_EQ(on_floor.size(), 16U);
  const auto base = measure_base_rings(on_floor, {.axis = {}, .width = 0.8});
  EXPECT_NEAR(base.load, 30.0, 1e-10);
  EXPECT_NEAR(base.rings.back().cumulative, 30.0, 1e-10);
  EXPECT_GT(base.rings[1].shear, 0.0);  // a heap pushes its floor outwards

  Grains<3> grains;
  Contacts<3> contacts;
  const double height = std::sqrt(2.0 / 3.0);
  grains.add(unit_sphere({{0.0, 0.0, height}}), 7);
  for (int k = 0; k < 3; ++k) {
    const double turn = 2.0 * pi * k / 3.0;
    grains.add(unit_sphere({{std::cos(turn) / std::sqrt(3.0), std::sin(turn) / std::sqrt(3.0), 0.0}}, true), k, true);
  }
  grains.add(unit_sphere({{5.0, 0.0, 0.0}}, true), 3, true);
  for (std::size_t k = 1; k < 4; ++k) {  // once with the base grain first, twice with the heap's
    contacts.list.push_back(k == 1 ? sphere_contact(grains, k, 0, 1.0 / (3.0 * height))
                                   : sphere_contact(grains, 0, k, 1.0 / (3.0 * height)));
  }
  contacts.list.push_back(sphere_contact(grains, 1, 2, 9.0));  // between base grains: no load of the heap
  const auto loads = loads_on_base_grains({grains, Box<3>{}}, contacts);
  ASSERT_EQ(loads.size(), 4U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(loads[k].force[2], -1.0 / 3.0, 1e-14);
    // Outwards by tan of the angle between contact and vertical: (1/sqrt 3)/height.
    EXPECT_NEAR(dot(Vec<2>{{loads[k].force[0], loads[k].force[1]}}, loads[k].place) * std::sqrt(3.0),
                1.0 / (3.0 * std::sqrt(2.0)), 1e-14);
  }
  EXPECT_EQ(magnitude(loads[3].force), 0.0);
  EXPECT_FALSE(measure_base_rings({}, {.axis = {}, .width = 1.0}).dip_index);
  EXPECT_FALSE(loaded_radius({}, {}));
}

}  // namespace
}  // namespace repose
