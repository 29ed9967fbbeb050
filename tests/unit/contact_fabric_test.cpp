// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_fabric.hpp"

#include "repose/core/numbers.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace repose {
namespace {

using namespace packs;

Contact<3> contact_along(const Vec<3>& normal, double force, std::int64_t second = 1) {
  Contact<3> contact;
  contact.first = 0;
  contact.second = second;
  contact.normal = normal;
  contact.normal_force = force;
  return contact;
}

// Eigenvalues and axes of a tensor with known ones: t = sum l_k a_k a_k about a random frame.
TEST(PrincipalAxes, OfATensorWithKnownOnes) {
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Vec<3> first = random_direction(k);
    Vec<3> second = tangential(random_direction(k, 2), first);
    second *= 1.0 / magnitude(second);
    const Vec<3> third = cross(first, second);
    const std::array<double, 3> values{0.6, 0.3, k % 2 == 0 ? 0.1 : -0.4};
    SymmetricTensor tensor;
    for (const auto& [axis, value] : {std::pair{first, values[0]}, {second, values[1]}, {third, values[2]}}) {
      SymmetricTensor part;
      part.add_square(axis);
      part *= value;
      tensor.xx += part.xx;
      tensor.yy += part.yy;
      tensor.zz += part.zz;
      tensor.xy += part.xy;
      tensor.xz += part.xz;
      tensor.yz += part.yz;
    }
    const auto found = principal_axes(tensor);
    for (std::size_t m = 0; m < 3; ++m) EXPECT_NEAR(found.value[m], values[m], 1e-15) << k;
    EXPECT_NEAR(std::fabs(dot(found.axis[0], first)), 1.0, 1e-14);
    EXPECT_NEAR(std::fabs(dot(found.axis[2], third)), 1.0, 1e-14);
    EXPECT_GE(found.axis[0][2], 0.0);
    const double differences =
        squared(values[0] - values[1]) + squared(values[1] - values[2]) + squared(values[2] - values[0]);
    EXPECT_NEAR(deviator(tensor), std::sqrt(0.5 * differences), 1e-14);
  }
  const auto none = principal_axes({});
  EXPECT_EQ(none.value, (std::array<double, 3>{}));
  EXPECT_EQ(inclination_deg({{0.0, 0.0, -1.0}}), 90.0);
  EXPECT_NEAR(inclination_deg({{1.0, 1.0, std::sqrt(2.0)}}), 45.0, 1e-12);
}

// Normals on a cone of 30 degrees about the vertical: cos^2 = 3/4 along z and 1/8 along x and y, a deviator of 5/8.
TEST(ContactFabric, NormalsOnACone) {
  Contacts<3> contacts;
  for (int k = 0; k < 12; ++k) {
    const double turn = radians(30.0 * k);
    contacts.list.push_back(
        contact_along({{0.5 * std::cos(turn), 0.5 * std::sin(turn), std::sqrt(0.75)}}, k % 2 == 0 ? 1.0 : 3.0));
  }
  const auto fabric = measure_contact_fabric(contacts, 0.0);
  ASSERT_TRUE(fabric);
  EXPECT_EQ(fabric->all.contacts, 12U);
  EXPECT_NEAR(fabric->mean_force, 2.0, 1e-15);
  EXPECT_NEAR(fabric->all.tensor.trace(), 1.0, 1e-15);
  EXPECT_NEAR(fabric->all.principal.value[0], 0.75, 1e-15);
  EXPECT_NEAR(fabric->all.principal.value[2], 0.125, 1e-15);
  EXPECT_NEAR(fabric->all.deviator, 0.625, 1e-15);
  EXPECT_NEAR(fabric->all.inclination_deg, 90.0, 1e-6);
  EXPECT_EQ(fabric->strong->contacts, 6U);
  EXPECT_EQ(fabric->weak->contacts, 6U);
}

// Strong contacts vertical, weak ones level: each part has its own axis. Walls count if asked for. What lies below the
// threshold or is not finite does not.
TEST(ContactFabric, StrongAndWeakParts) {
  Contacts<3> contacts;
  for (int k = 0; k < 3; ++k) contacts.list.push_back(contact_along({{0.0, 0.0, 1.0}}, 4.0));
  for (int k = 0; k < 6; ++k) contacts.list.push_back(contact_along({{0.0, -1.0, 0.0}}, 1.0));
  contacts.list.push_back(contact_along({{1.0, 0.0, 0.0}}, 1e-3));
  contacts.list.push_back(contact_along({{1.0, 0.0, 0.0}}, std::numeric_limits<double>::infinity()));
  contacts.list.push_back(contact_along({{1.0, 0.0, 0.0}}, 9.0, wall_partner(0)));
  const auto fabric = measure_contact_fabric(contacts, 0.01);
  ASSERT_TRUE(fabric);
  EXPECT_EQ(fabric->all.contacts, 9U);
  EXPECT_NEAR(fabric->mean_force, 2.0, 1e-15);
  EXPECT_NEAR(fabric->all.principal.value[0], 2.0 / 3.0, 1e-15);
  EXPECT_EQ(fabric->all.principal.axis[0], (Vec<3>{{0.0, 1.0, 0.0}}));
  EXPECT_NEAR(fabric->all.inclination_deg, 0.0, 1e-12);
  EXPECT_EQ(fabric->strong->inclination_deg, 90.0);
  EXPECT_NEAR(fabric->strong->deviator, 1.0, 1e-15);
  EXPECT_EQ(fabric->weak->inclination_deg, 0.0);
  EXPECT_EQ(measure_contact_fabric(contacts, 0.01, true)->all.contacts, 10U);
  EXPECT_FALSE(measure_contact_fabric(contacts, 100.0));
  Contacts<3> equal;
  equal.list.assign(3, contact_along({{0.0, 0.0, 1.0}}, 0.1));
  EXPECT_FALSE(measure_contact_fabric(equal, 0.0)->strong);
}

// Random directions are isotropic: each eigenvalue 1/3 to 3 standard errors, sqrt(4/45 n) for 20 000 contacts.
TEST(ContactFabric, Isotropic) {
  Contacts<3> contacts;
  for (std::uint64_t k = 0; k < 20000; ++k) contacts.list.push_back(contact_along(random_direction(k), 1.0));
  const auto fabric = measure_contact_fabric(contacts, 0.0);
  for (const double value : fabric->all.principal.value) EXPECT_NEAR(value, 1.0 / 3.0, 3.0 * 0.0021);
  EXPECT_LT(fabric->all.deviator, 0.01);
}

}  // namespace
}  // namespace repose
