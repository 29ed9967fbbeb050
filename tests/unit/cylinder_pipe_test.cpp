// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pipe.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double shear = 0.25;  // upwards on every sphere from the wall
constexpr double perimeter = std::numbers::pi;

/// Spheres of diameter 1 one upon the other from the floor at z = 2, in a cylinder of diameter 1. Wall 0 is the floor,
/// 1 the cylinder. Each sphere is pushed by the wall at two opposite points.
struct SphereStack {
  CylinderPipe pipe{.wall = 1, .axis = {{4.0, -3.0}}, .radius = 0.5, .floor = 2.0};
  Grains<3> grains;
  Contacts<3> contacts;

  explicit SphereStack(int count) {
    for (int k = 0; k < count; ++k) grains.add(unit_sphere({{4.0, -3.0, 2.5 + k}}), k);
    const auto touch = [&](std::int64_t sphere, std::int64_t wall, const Vec<3>& normal, double force, double upwards) {
      Contact<3> contact;
      contact.first = sphere;
      contact.second = wall_partner(wall);
      contact.normal = normal;
      contact.normal_force = force;
      contact.tangential_force = {{0.0, 0.0, upwards}};
      contacts.list.push_back(contact);
    };
    for (int k = 0; k < count; ++k) {
      const double force = 0.5 + 0.1 * k;
      const double turn = 0.7 * k;
      const Vec<3> inwards{{std::cos(turn), std::sin(turn), 0.0}};
      touch(k, 1, inwards, force, 0.5 * shear);
      touch(k, 1, -inwards, force, 0.5 * shear);
    }
    touch(0, 0, {{0.0, 0.0, 1.0}}, count * (1.0 - shear), 0.0);
    for (int k = 1; k < count; ++k) {
      const auto lower = static_cast<std::size_t>(k - 1);
      const double load = (count - k) * (1.0 - shear);
      contacts.list.push_back(k % 2 == 0 ? sphere_contact(grains, lower, lower + 1, load)
                                         : sphere_contact(grains, lower + 1, lower, load));
    }
  }
};

// As many slices as spheres: each ends at the top of its sphere, and covers a wall of the area pi.
TEST(CylinderPipe, StackOfSpheres) {
  constexpr int count = 12;
  const SphereStack stack(count);
  const auto column = measure_column(stack.pipe, stack.grains, stack.contacts, count);
  EXPECT_NEAR(column.row.height, count, 1e-12);
  EXPECT_NEAR(column.row.centre, 0.5 * count, 1e-12);
  EXPECT_NEAR(column.row.solid_fraction, 2.0 / 3.0, 1e-4);  // the volume near a level between spheres is small
  for (int k = 0; k < count; ++k) {
    const auto& slice = column.slices[static_cast<std::size_t>(k)];
    // The volume within e of a pole is pi e^2/2: half the digits of the bisection.
    EXPECT_NEAR(slice.top, k + 1.0, 1e-5) << k;
    EXPECT_NEAR(slice.mass, 1.0, 1e-12);
    EXPECT_NEAR(slice.pressure, (1.0 + 0.2 * k) / perimeter, 1e-4) << k;
    EXPECT_NEAR(slice.shear, shear / perimeter, 1e-4);
    EXPECT_NEAR(slice.load, (count - k) * (1.0 - shear), 1e-12) << k;
  }
}

// Fewer slices of equal volume: the balance closes in every slice.
TEST(CylinderPipe, SlicesBalance) {
  const SphereStack stack(12);
  const auto slices = measure_column(stack.pipe, stack.grains, stack.contacts, 5).slices;
  double mass = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double low = k > 0 ? slices[k - 1].top : 0.0;
    const double above = k < 4 ? slices[k + 1].load : 0.0;
    EXPECT_NEAR(slices[k].load, above + slices[k].mass - perimeter * slices[k].shear * (slices[k].top - low), 1e-12);
    mass += slices[k].mass;
  }
  EXPECT_NEAR(mass, 12.0, 1e-12);
}

// Spheres that fall from above, lie outside the cylinder or have fallen below the floor do not count.
TEST(CylinderPipe, CountsTheSpheresOfTheColumnAlone) {
  SphereStack stack(4);
  stack.grains.add(unit_sphere({{4.0, -3.0, 20.0}}), 100);
  stack.grains.add(unit_sphere({{4.0, -1.0, 2.5}}), 101);
  stack.grains.add(unit_sphere({{4.0, -3.0, 1.5}}), 102);
  stack.contacts.list.push_back(sphere_contact(stack.grains, 0, 6, 0.25));
  const auto column = measure_column(stack.pipe, stack.grains, stack.contacts, 4);
  EXPECT_NEAR(column.row.height, 4.0, 1e-12);
  EXPECT_NEAR(column.row.centre, 2.0, 1e-12);
  EXPECT_NEAR(column.slices[0].load, 4.0 * (1.0 - shear) + 0.25, 1e-12);
  const auto none = measure_column(stack.pipe, {}, {}, 4);
  EXPECT_EQ(none.row.height, 0.0);
  EXPECT_TRUE(std::isnan(none.row.solid_fraction));
}

// A wide pipe, filled up to a slope of 0.2. The highest of the spheres, 0.1 apart, stands half a patch up the slope
// from the middle of its patch: (|cos| + |sin|)/2 of a square of side 1 in any direction, 2/pi on average, less the
// distance of a sphere from the edge, 0.05 along each axis. Tolerance: patches are only nearly square.
TEST(CylinderPipe, HeightOfASlantingSurface) {
  const CylinderPipe pipe{.wall = 0, .axis = {}, .radius = 6.0, .floor = 0.0};
  Grains<3> grains;
  Contacts<3> contacts;
  std::int64_t id = 0;
  for (double x = -5.95; x < 6.0; x += 0.1) {
    for (double y = -5.95; y < 6.0; y += 0.1) {
      if (std::hypot(x, y) < 5.99) grains.add(unit_sphere({{x, y, 10.0 + 0.2 * x}}), id++);
    }
  }
  for (std::size_t k = 1; k < grains.size(); ++k) contacts.list.push_back(sphere_contact(grains, k, k - 1, 1.0));
  const auto column = measure_column(pipe, grains, contacts, 10);
  EXPECT_NEAR(column.row.height, 10.5 + 0.2 * (2.0 / std::numbers::pi - 0.06), 0.02);
}

}  // namespace
}  // namespace repose
