// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/start_places.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

// Scenes of spheres that start from files and runs.

namespace repose {
namespace {

class Start3dTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  void file(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  Scene scene(const std::string& start, const std::string& more = "", int dimension = 3) const {
    return scene_from_text("dimension = " + std::to_string(dimension) + "\n[start]\n" + start + "\n[stop]\ntime = 1\n" +
                               (more.empty() ? "[box]\nhalf_width = 50\n" : more),
                           path("scene.toml"));
  }
  std::vector<std::string> refused(const std::string& start, const std::string& more = "", int dimension = 3) const {
    try {
      scene(start, more, dimension);
    } catch (const InputError& error) {
      return error.problems();
    }
    return {};
  }

  /// A run.h5 with some spheres and contacts, or the same in the plane.
  template <int D>
  void write_run(const std::string& name) const {
    Grains<D> grains;
    Contacts<D> contacts;
    for (int k = 0; k < 3; ++k) {
      Grain<D> grain;
      grain.position[0] = k;
      grain.position[up<D>] = 0.75 + k / 3.0;
      grain.velocity[up<D>] = -0.1 * k;
      grain.radius = 0.5;
      grain.mass = grain.inverse_mass = 0.125 + k;
      grains.add(grain, 3 * k + 1);
      if (k == 0) continue;
      Contact<D> contact{.first = 3 * k - 2, .second = 3 * k + 1};
      contact.normal[0] = -1.0;
      contact.first_lever = 0.5;
      if constexpr (D == 3) contact.slip = {{0.0, 1e-3 * k, -0.01}};
      contacts.list.push_back(contact);
    }
    Hdf5File made(path(name), "reduced");
    made.attribute("/", "format", std::string("repose-run"));
    made.attribute("/", "status", std::string("finished"));
    made.texts("scene", {"dimension = " + std::to_string(D) + "\n[stop]\ntime = 1\n"}, "");
    const OrderedGrains<D> ordered(grains, {});
    write_grains(made, ordered);
    write_contacts(made, blocks_of(contacts), ordered, true);
    made.commit();
  }

  const testing::TemporaryFolder folder_;
};

constexpr const char* two_spheres =
    "x,y,z,vx,vy,vz,omegax,omegay,omegaz,radius\n1,2,3,4,5,6,7,8,9,0.5\n-4,-3,8,0,0,0,0,0,0,0.25\n";

bool any_contains(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(part) != std::string::npos; });
}

// A mirror across the plane of x and z leaves the part of a spin along y and turns round the others.
TEST_F(Start3dTest, AFileIsScaledFlippedAndShifted) {
  file("grains.csv", two_spheres);
  const auto read = scene("from = 'grains.csv'\nscale = 2\nflip = 'y'\nshift = [10, 20, -2]");
  const auto state = state_at_start<3>(read);
  ASSERT_EQ(state.grains.size(), 2U);
  const auto& row = state.grains[0];
  EXPECT_EQ(row.position, (Vec<3>{{12.0, 16.0, 4.0}}));
  EXPECT_EQ(row.velocity, (Vec<3>{{8.0, -10.0, 12.0}}));
  EXPECT_EQ(row.spin, (Vec<3>{{-7.0, 8.0, -9.0}}));
  EXPECT_EQ(row.radius, 1.0);
  const auto mirrored = [&](const std::string& axis) {
    return state_at_start<3>(scene("from = 'grains.csv'\nflip = '" + axis + "'")).grains[0];
  };
  EXPECT_EQ(mirrored("x").spin, (Vec<3>{{7.0, -8.0, -9.0}}));
  EXPECT_EQ(mirrored("z").spin, (Vec<3>{{-7.0, -8.0, 9.0}}));
  EXPECT_EQ(mirrored("none").spin, (Vec<3>{{7.0, 8.0, 9.0}}));
}

TEST_F(Start3dTest, FactsUseTheHeight) {
  file("grains.csv", two_spheres);
  const auto read = scene("from = 'grains.csv'");
  EXPECT_EQ(read.start.moving, 2);
  EXPECT_EQ(read.start.smallest, 0.5);
  EXPECT_EQ(read.start.largest, 1.0);
  // The first rises by v^2/2 = 77/2 above z = 3; gravity is 1.
  EXPECT_DOUBLE_EQ(read.start.fall, 3.0 + 0.5 * (16.0 + 25.0 + 36.0));
  EXPECT_NE(read.start.description.find("centres: x -4 to 1, y -3 to 2, z 3 to 8\n"), std::string::npos)
      << read.start.description;
  EXPECT_NE(read.start.description.find("deepest overlap: none"), std::string::npos);
}

TEST_F(Start3dTest, BothLevelAxesWrapIntoAPeriodicBox) {
  file("grains.csv", "x,y,z,radius\n4,-7,3,0.25\n-1,1,2,0.25\n");
  const auto read =
      scene("from = 'grains.csv'", "[box]\nx = 'periodic'\nhalf_width = 3\ny = 'periodic'\nhalf_depth = 5\n");
  const auto state = state_at_start<3>(read);
  EXPECT_EQ(state.grains[0].position, (Vec<3>{{-2.0, 3.0, 3.0}}));
  EXPECT_EQ(state.grains[1].position, (Vec<3>{{-1.0, 1.0, 2.0}}));
}

TEST_F(Start3dTest, GrainsOverlapAcrossBothSidesOfABox) {
  file("grains.csv", "x,y,z,radius\n0,4.9,3,0.5\n0,-4.7,3,0.5\n");
  const std::string box = "[box]\nx = 'open'\nhalf_width = 3\ny = 'periodic'\nhalf_depth = 5\n";
  const auto problems = refused("from = 'grains.csv'", box);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("the grains of lines 2 and 3 overlap by 0.6 of their mean diameter"), std::string::npos)
      << problems[0];
  const std::string open = "[box]\nhalf_width = 50\n";
  EXPECT_TRUE(refused("from = 'grains.csv'", open).empty()) << "9.6 apart in an open box";
}

TEST_F(Start3dTest, PlacedSpheresMustNotOverlapThoseOfTheFile) {
  file("grains.csv", "id,x,y,z,radius\n7,0,2,3,0.5\n");
  const auto problems =
      refused("from = 'grains.csv'", "[box]\nhalf_width = 50\n[[grain]]\nposition = [0.0, 2.5, 3.0]\n");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(
      problems[0].find("grain[0].position = [0, 2.5, 3]: it and grain 7 of line 2 of start.from overlap by 0.5 of "
                       "their mean diameter"),
      std::string::npos)
      << problems[0];
}

TEST_F(Start3dTest, GrainsOutsideTheBoxAndBehindWallsAreRefused) {
  file("grains.csv", two_spheres);
  const auto outside = refused("from = 'grains.csv'", "[box]\nhalf_width = 50\nhalf_depth = 2.5\n");
  EXPECT_TRUE(any_contains(outside,
                           "1 of its grains lie outside the box, y = +-2.5: they lie at y = -3 to 2; set "
                           "start.shift or box.half_depth"))
      << (outside.empty() ? "" : outside[0]);
  const auto behind = refused("from = 'grains.csv'",
                              "[box]\nhalf_width = 50\n[[plane]]\npoint = [0.0, 0.0, 7.0]\nnormal = [0.0, 0.0, 1.0]\n");
  EXPECT_TRUE(any_contains(behind, "grain 0 at (1, 2, 3): its centre lies 4 behind wall"))
      << (behind.empty() ? "" : behind[0]);
  const auto wrong = refused("from = 'plane.csv'");
  EXPECT_EQ(wrong.size(), 1U) << "no such file";
  file("plane.csv", "x,y,radius\n1,2,0.5\n");
  EXPECT_TRUE(any_contains(refused("from = 'plane.csv'"), "must have the columns x, y, z, and radius or diameter"));
}

TEST_F(Start3dTest, BoxesOfFilesAreCompared) {
  file("grains.dump",
       "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff pp pp\n-5 5\n-4 4\n0 9\n"
       "ITEM: ATOMS id x y z radius\n1 0 0 3 0.5\n");
  const auto open = scene("from = 'grains.dump'").start.warnings;
  EXPECT_TRUE(any_contains(open,
                           "the file's box is periodic along y, 8 deep, the scene's is not: contacts through its "
                           "sides are lost; set box.y = \"periodic\" and box.half_depth = 4"))
      << (open.empty() ? "" : open[0]);
  EXPECT_TRUE(any_contains(open, "the file's box is periodic along its height"));
  EXPECT_EQ(open.size(), 2U);
  const auto periodic =
      scene("from = 'grains.dump'", "[box]\nhalf_width = 50\ny = 'periodic'\nhalf_depth = 6\n").start.warnings;
  EXPECT_TRUE(any_contains(periodic, "the file's box is 8 deep, the scene's 12"));
}

TEST_F(Start3dTest, ARunGivesItsGrainsAndContacts) {
  write_run<3>("run.h5");
  Scene by_hand;
  by_hand.dimension = 3;
  by_hand.start.path = path("run.h5");
  const auto state = state_at_start<3>(by_hand);
  ASSERT_EQ(state.grains.size(), 3U);
  EXPECT_EQ(state.grains[2].id, 7);
  EXPECT_EQ(state.grains[2].position, (Vec<3>{{2.0, 0.0, 0.75 + 2.0 / 3.0}}));
  EXPECT_EQ(state.grains[2].mass, 2.125);
  ASSERT_EQ(state.contacts.size(), 2U);
  EXPECT_EQ(state.contacts.list[1].slip, (Vec<3>{{0.0, 2e-3, -0.01}}));
}

TEST_F(Start3dTest, ARunOfAnotherDimensionIsRefused) {
  write_run<2>("flat.h5");
  write_run<3>("solid.h5");
  const auto flat = refused("from = 'flat.h5'");
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_NE(flat[0].find("flat.h5: is a run in two dimensions, the scene is in three dimensions"), std::string::npos)
      << flat[0];
  const auto solid = refused("from = 'solid.h5'", "", 2);
  ASSERT_EQ(solid.size(), 1U);
  EXPECT_NE(solid[0].find("solid.h5: is a run in three dimensions, the scene is in two dimensions"), std::string::npos)
      << solid[0];
}

TEST_F(Start3dTest, ASceneOfDiscsReadsAPlanarFileOfSpheres) {
  file("planar.dump",
       "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff pp ff\n-5 5\n-4 4\n0 9\n"
       "ITEM: ATOMS id x y z vx vy vz omegax omegay omegaz radius\n"
       "1 1 7 3 4 0 6 0 5 0 0.5\n2 -1 7 3 0 0 0 0 0 0 0.5\n");
  const auto state = state_at_start<2>(scene("from = 'planar.dump'\nplane = 'xz'", "", 2));
  ASSERT_EQ(state.grains.size(), 2U);
  EXPECT_EQ(state.grains[0].position, (Vec<2>{{1.0, 3.0}}));
  EXPECT_EQ(state.grains[0].velocity, (Vec<2>{{4.0, 6.0}}));
  EXPECT_EQ(state.grains[0].spin, -5.0);
  file("solid.csv", "x,y,z,radius\n0,0,3,0.5\n2,0,3.5,0.5\n");
  EXPECT_TRUE(any_contains(refused("from = 'solid.csv'", "", 2), "z = 3.5: must be the same for all grains"));
}

}  // namespace
}  // namespace repose
