// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/axial_fields.hpp"

#include "repose/analysis/force_network.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double pi = std::numbers::pi;

double total(const AxialFields& fields, const std::vector<double>& field) {
  double sum = 0.0;
  for (std::size_t k = 0; k < field.size(); ++k) sum += field[k] * fields.volume[k];
  return sum;
}

/// The total of a field in one layer.
double total_of_layer(const AxialFields& fields, const std::vector<double>& field, std::size_t layer) {
  double sum = 0.0;
  for (std::size_t k = 0; k < fields.r.size(); ++k) {
    const auto cell = fields.cell(k, layer);
    sum += field[cell] * fields.volume[cell];
  }
  return sum;
}

AxialFields measure(const Grains<3>& grains, const Contacts<3>& contacts, const AxialSettings& settings) {
  std::vector<bool> in_heap;
  for (const auto& grain : grains.line) in_heap.push_back(!grain.fixed());
  return axial_fields({grains, Box<3>{}}, contacts, in_heap, Box<3>{}, settings);
}

// Equilibrium of a pyramid on a floor. In each layer the integral of zz is that of the weight of the centres above each
// level; the floor's support lies at z = 0 and below all levels. Tolerance: rounding of some 200 contacts.
TEST(AxialFields, PyramidCarriesItsWeight) {
  const SquarePyramid pyramid(5);
  const auto net = net_forces(pyramid.grains, pyramid.contacts, {{0.0, 0.0, -1.0}});
  for (const auto& force : net) ASSERT_LT(magnitude(force), 1e-12);
  for (const double layer : {0.37, 0.1, 5.0}) {
    const auto fields = measure(pyramid.grains, pyramid.contacts, {.ring = 0.7, .layer = layer});
    EXPECT_NEAR(total(fields, fields.density), 55.0, 1e-11);
    EXPECT_NEAR(total(fields, fields.solid_fraction), 55.0 * pi / 6.0, 1e-10);
    EXPECT_NEAR(total(fields, fields.support[1]), 55.0, 1e-10);
    for (std::size_t k = 0; k < fields.z.size(); ++k) {
      const double low = std::max(0.0, fields.z[k] - 0.5 * layer);
      const double high = fields.z[k] + 0.5 * layer;
      double expected = 0.0;
      for (const auto& grain : pyramid.grains.line) expected += std::clamp(grain.position[2] - low, 0.0, high - low);
      EXPECT_NEAR(total_of_layer(fields, fields.stress[2], k), expected, 1e-10) << layer << " " << k;
    }
    double virial = 0.0;
    for (const auto& contact : pyramid.contacts.list) {
      virial += contact.normal_force * (contact.second < 0 ? 0.5 : 1.0);
    }
    EXPECT_NEAR(total(fields, fields.stress[0]) + total(fields, fields.stress[1]) + total(fields, fields.stress[2]),
                virial, 1e-10);
  }
}

// Stacks of spheres on fixed base grains: a support at the contact point, and the load above in each layer.
TEST(AxialFields, StacksOnBaseGrains) {
  Grains<3> grains;
  Contacts<3> contacts;
  std::int64_t id = 0;
  for (const double x : {0.25, 3.25}) {
    const auto base = grains.size();
    grains.add(unit_sphere({{x, 0.0, 0.0}}, true), id++, true);
    for (int k = 1; k <= 4; ++k) {
      grains.add(unit_sphere({{x, 0.0, static_cast<double>(k)}}), id++);
      const auto lower = base + static_cast<std::size_t>(k) - 1;
      // Once with the upper sphere first, once with the lower one.
      contacts.list.push_back(k % 2 == 0 ? sphere_contact(grains, lower + 1, lower, 5.0 - k)
                                         : sphere_contact(grains, lower, lower + 1, 5.0 - k));
    }
  }
  const auto fields = measure(grains, contacts, {.ring = 0.5, .layer = 0.5});
  ASSERT_EQ(fields.z.size(), 9U);    // from the contact points at 0.5 up to the tops at 4.5, and the layer above these
  const double section = pi * 0.25;  // of the innermost ring
  for (std::size_t k = 0; k < 7; ++k) {
    const double load = k == 0 ? 4.0 : std::ceil(3.5 - 0.5 * static_cast<double>(k));
    EXPECT_NEAR(fields.stress[2][fields.cell(0, k)] * section, load, 1e-12) << k;
    EXPECT_NEAR(total_of_layer(fields, fields.stress[2], k), 2.0 * load * 0.5, 1e-12) << k;
  }
  EXPECT_NEAR(total_of_layer(fields, fields.support[1], 0), 8.0, 1e-12);
  EXPECT_NEAR(total(fields, fields.support[1]), 8.0, 1e-12);
  for (const std::size_t component : {0, 1, 3, 4}) {
    for (const double value : fields.stress[component]) EXPECT_NEAR(value, 0.0, 1e-14);
  }
  for (std::size_t k = 0; k < fields.density.size(); ++k) EXPECT_GE(fields.density[k], 0.0);
}

// A force along the branch of a random pair, against the sums over ten thousand points of the branch. Tolerance: the
// error of these sums near ring edges, a few lengths of a point's share.
TEST(AxialFields, BranchesAgainstFineSums) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    Grains<3> grains;
    const Vec<3> start{{2.0 * random_number(k, 2) - 1.0, 2.0 * random_number(k, 3) - 1.0, random_number(k, 4)}};
    grains.add(unit_sphere(start + random_direction(k)), 0);
    grains.add(unit_sphere(start), 1);
    Contacts<3> contacts;
    auto contact = sphere_contact(grains, 0, 1, 2.0);
    contact.tangential_force = tangential(random_direction(k, 2), contact.normal);
    contacts.list.push_back(contact);
    const auto fields = measure(grains, contacts, {.ring = 0.3, .layer = 0.4});
    std::array<std::vector<double>, 5> sums;
    for (auto& sum : sums) sum.assign(fields.volume.size(), 0.0);
    const Vec<3> branch = grains.line[0].position - start;
    const Vec<3> force = force_of(contact);
    constexpr int points = 100000;
    for (int p = 0; p < points; ++p) {
      const Vec<3> at = start + branch * ((p + 0.5) / points);
      const double radius = std::hypot(at[0], at[1]);
      const Vec<3> radial{{at[0] / radius, at[1] / radius, 0.0}};
      const Vec<3> around{{-radial[1], radial[0], 0.0}};
      const auto in_r = static_cast<std::size_t>(radius / 0.3);
      const auto in_z = static_cast<std::size_t>(std::lround((at[2] - fields.z[0]) / 0.4));
      const auto cell = fields.cell(in_r, in_z);
      sums[0][cell] += dot(force, radial) * dot(branch, radial) / points;
      sums[1][cell] += dot(force, around) * dot(branch, around) / points;
      sums[2][cell] += force[2] * branch[2] / points;
      sums[3][cell] += dot(force, radial) * branch[2] / points;
      sums[4][cell] += force[2] * dot(branch, radial) / points;
    }
    for (std::size_t c = 0; c < 5; ++c) {
      for (std::size_t cell = 0; cell < fields.volume.size(); ++cell) {
        EXPECT_NEAR(fields.stress[c][cell] * fields.volume[cell], sums[c][cell], 1e-4) << k << " " << c;
      }
    }
  }
}

// A ring of spheres that push each other along a circle: the hoop stress times the section of the ring is the force, up
// to the angle between neighbours, which also gives the radial part. Sums over a polygon of 60 sides: u0 = 1/2 side,
// h = apothem, so the radial part of each branch is F (side - 2 h atan(side/(2 h))).
TEST(AxialFields, HoopStress) {
  constexpr int count = 60;
  const double radius = 0.5 / std::sin(pi / count);
  Grains<3> grains;
  Contacts<3> contacts;
  for (int k = 0; k < count; ++k) {
    const double turn = 2.0 * pi * k / count;
    grains.add(unit_sphere({{radius * std::cos(turn), radius * std::sin(turn), 0.2}}), k);
  }
  for (std::size_t k = 0; k < count; ++k) {
    contacts.list.push_back(sphere_contact(grains, k, (k + 1) % count, 3.0));
  }
  const auto fields = measure(grains, contacts, {.ring = 1.0, .layer = 1.0});
  const double apothem = radius * std::cos(pi / count);
  const double square = 2.0 * apothem * std::atan(0.5 / apothem);
  EXPECT_NEAR(total(fields, fields.stress[1]), count * 3.0 * square, 1e-9);
  EXPECT_NEAR(total(fields, fields.stress[0]), count * 3.0 * (1.0 - square), 1e-9);
  EXPECT_NEAR(total(fields, fields.stress[1]) / (2.0 * pi * radius), 3.0, 3.0 * 0.002);  // (pi/60)^2/2 = 0.0014
}

// Turning everything about the axis, shifting it, and other memory orders change nothing but rounding.
TEST(AxialFields, InvariantUnderTurnsAndShifts) {
  const SquarePyramid pyramid(4);
  const auto fields = measure(pyramid.grains, pyramid.contacts, {.ring = 0.6, .layer = 0.5});
  Grains<3> grains;
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const auto turned = [&](const Vec<3>& v) { return Vec<3>{{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]}}; };
  for (std::size_t k = pyramid.grains.size(); k-- > 0;) {
    auto grain = pyramid.grains.line[k];
    grain.position = turned(grain.position) + Vec<3>{{3.0, -2.0, 7.0}};
    grains.add(grain, pyramid.grains.id[k]);
  }
  auto contacts = pyramid.contacts;
  for (auto& contact : contacts.list) {
    contact.normal = turned(contact.normal);
    contact.tangential_force = turned(contact.tangential_force);
  }
  const auto other = measure(grains, contacts, {.axis = {{3.0, -2.0}}, .ring = 0.6, .layer = 0.5, .base = 7.0});
  ASSERT_EQ(other.volume.size(), fields.volume.size());
  for (std::size_t component = 0; component < 5; ++component) {
    double largest = 0.0;
    for (std::size_t k = 0; k < fields.volume.size(); ++k) {
      EXPECT_NEAR(other.stress[component][k], fields.stress[component][k], 1e-11);
      largest = std::max(largest, std::fabs(fields.stress[component][k]));
    }
    EXPECT_GT(largest, 0.01);  // of every component
  }
}

// One sphere: its volume in each ring, against the volume of a sphere within a cylinder. Tolerance: as documented.
TEST(AxialFields, SphereCutByRings) {
  Grains<3> grains;
  grains.add(unit_sphere({{0.0, 0.0, 1.0}}, false, 1.0), 0);
  const auto fields = measure(grains, {}, {.ring = 0.25, .layer = 3.0});
  double inner = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double edge = 0.25 * static_cast<double>(k + 1);
    const double within = 4.0 / 3.0 * pi * (1.0 - std::pow(1.0 - edge * edge, 1.5));
    EXPECT_NEAR(fields.solid_fraction[k] * fields.volume[k], within - inner, 0.01 * 4.0 / 3.0 * pi) << k;
    inner = within;
  }
  EXPECT_NEAR(total(fields, fields.solid_fraction), 4.0 / 3.0 * pi, 1e-12);
  EXPECT_TRUE(measure({}, {}, {.ring = 1.0, .layer = 1.0}).r.empty());
}

}  // namespace
}  // namespace repose
