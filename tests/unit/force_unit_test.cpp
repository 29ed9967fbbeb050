// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/force_unit.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/simulation/rest.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace repose {
namespace {

Scene scene_with(const std::string& keys) {
  return scene_from_text(keys + "contact.normal.law = \"hooke\"\nstop = { time = 9 }\n[[grain]]\nposition = [0, 1]\n",
                         "scene.toml");
}

Contacts<2> forces(const std::vector<double>& normal) {
  Contacts<2> contacts;
  for (const double force : normal) {
    Contact<2> contact;
    contact.second = wall_partner(0);
    contact.normal = {{0.0, 1.0}};
    contact.normal_force = force;
    contacts.list.push_back(contact);
  }
  return contacts;
}

// The mean is over contacts that carry a force; a pull counts by its size.
TEST(ForceUnit, WeightMeanOrGiven) {
  const auto contacts = forces({1.0, 0.0, 4.0, -1.0});
  EXPECT_EQ(force_unit(scene_with("gravity = 3.0\n"), contacts), 3.0);
  EXPECT_EQ(force_unit(scene_with("gravity = 0.0\n"), contacts), 2.0);
  EXPECT_EQ(force_unit(scene_with("gravity = 0.0\n"), {}), 0.0);
  EXPECT_EQ(force_unit(scene_with("gravity = 3.0\nanalysis.force_scale = \"mean\"\n"), contacts), 2.0);
  EXPECT_EQ(force_unit(scene_with("gravity = 0.0\nanalysis = { force_scale = \"given\", force = 7.0 }\n"), contacts),
            7.0);
}

TEST(ForceUnit, TheWeightNeedsGravityAndAGivenForceANumber) {
  for (const std::string keys : {"gravity = 0.0\nanalysis.force_scale = \"weight\"\n",
                                 "analysis.force_scale = \"given\"\n", "analysis.force = 2.0\n"}) {
    try {
      scene_with(keys);
      ADD_FAILURE() << keys;
    } catch (const InputError& error) {
      ASSERT_EQ(error.problems().size(), 1U) << keys;
      EXPECT_NE(error.problems()[0].find("analysis.force"), std::string::npos) << error.problems()[0];
    }
  }
}

// Without gravity, one disc of mass 1 between two walls: the mean force is 4, the net force half of that, and the
// kinetic energy of speed 0.2 is 0.02, over mean force times diameter. Nothing that carries no force is at rest.
TEST(Rest, WithoutGravityForcesAreMeasuredByTheirMean) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.0), 0);
  grains.line[0].velocity = {{0.2, 0.0}};
  auto contacts = forces({3.0, 5.0});
  contacts.list[1].normal = {{0.0, -1.0}};
  const auto unrest = largest_unrest(grains, contacts, {}, Vec<2>{}, 1.0);
  EXPECT_DOUBLE_EQ(unrest.net_force, 0.5);
  EXPECT_DOUBLE_EQ(unrest.kinetic_energy, 0.02 / 4.0);
  EXPECT_EQ(largest_unrest<2>(grains, {}, {}, Vec<2>{}, 1.0).net_force, std::numeric_limits<double>::infinity());
  const auto scene = scene_from_text(
      "gravity = 0\ncontact.normal.law = \"hooke\"\nstop = { at_rest = 1e-3 }\noutput = { window = 2.0 }\n[[grain]]\n"
      "position = [0, 1]\n",
      "scene.toml");
  EXPECT_DOUBLE_EQ(Rest(scene, {0.01, true}).due_after(0.0), 0.1);  // a twentieth of the window
}

}  // namespace
}  // namespace repose
