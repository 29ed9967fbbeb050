// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/grains_file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

// Files as other programs write them, by the public definitions of their formats.

namespace repose {
namespace {

class OtherProgramsTest : public ::testing::Test {
 protected:
  const testing::TemporaryFolder folder_;
  const std::string path_ = folder_.path("grains");

  GrainsFile<2> read(const std::string& text, const GrainsFileOptions& options = {}) const {
    std::ofstream(path_, std::ios::binary) << text;
    return read_grains_file<2>(path_, options);
  }
  std::string refused(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path_.size());
    }
    return "none";
  }
};

using Lines = std::vector<std::string>;

constexpr const char* data_file =
    "LAMMPS data file via write_data, version 29 Sep 2021, timestep = 100, units = si\n\n2 atoms\n2 atom types\n\n"
    "-1 9 xlo xhi\n0 20 ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms # sphere\n\n"
    "7 2 1.0 3.0 1.5 2.5 0.25 0 0 0\n3 1 0.5 3.0 4.0 0.5 0.25 0 0 0\n\n"
    "Velocities\n\n3 0.1 0.2 0.3 1 2 3\n7 0 0 0 0 0 -4\n";

// The mass of an atom of style sphere is that of a sphere: density pi d^3/6.
TEST_F(OtherProgramsTest, LammpsDataFile) {
  const auto file = read(data_file);
  EXPECT_EQ(file.format, "LAMMPS data file, atom_style sphere");
  ASSERT_EQ(file.grains.size(), 2U);
  const auto& row = file.grains[0];
  EXPECT_EQ(row.id, 3);
  EXPECT_EQ(row.material, 0);
  EXPECT_EQ(row.position, (Vec<2>{{4.0, 0.5}}));
  EXPECT_EQ(row.third, 0.25);
  EXPECT_EQ(row.radius, 0.25);
  EXPECT_EQ(row.velocity, (Vec<2>{{0.1, 0.2}}));
  EXPECT_EQ(row.spin, 3.0);
  ASSERT_TRUE(file.grains[1].mass);
  EXPECT_NEAR(*file.grains[1].mass, 3.0 * std::numbers::pi / 6.0, 1e-15) << "one rounding of a product";
  EXPECT_EQ(file.grains[1].type, 2);
  EXPECT_EQ(file.grains[1].spin, -4.0);
  EXPECT_EQ(file.units.name, "si");
  ASSERT_TRUE(file.box);
  EXPECT_EQ(file.box->low[0], -1.0);
  EXPECT_EQ(file.box->high[1], 20.0);
  EXPECT_EQ(file.left_out, (Lines{"ix", "iy", "iz"}));
  EXPECT_EQ(read(data_file, {.plane = Plane::xz}).grains[0].position, (Vec<2>{{4.0, 0.25}}));
}

TEST_F(OtherProgramsTest, OtherLammpsDataFilesAreRefused) {
  EXPECT_EQ(refused("x\n\n1 atoms\n1 atom types\n\nAtoms # atomic\n\n1 1 0 0 0\n"),
            ":6: is of atom_style atomic, which has no diameters; must be of atom_style sphere");
  EXPECT_EQ(refused("x\n\n2 atoms\n\nAtoms # sphere\n\n1 1 1 1 0 0 0\n"), ":7: the file ends after 1 of 2 grains");
  EXPECT_EQ(refused("x\n\n1 atoms\n\nMasses\n\n1 1\n"), ": is a LAMMPS data file without a section Atoms");
  EXPECT_EQ(read("x\n\n1 atoms\n\nAtoms\n\n1 1 1 1 0 0 0\n").warnings.size(), 1U);
}

TEST_F(OtherProgramsTest, LiggghtsDump) {
  const auto file = read(
      "ITEM: TIMESTEP\n5000\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n-0.05 0.05\n-0.05 0.05\n0 0.15\n"
      "ITEM: ATOMS id type type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius \n"
      "2 1 1 0.01 0 0.02 0 0 0 1 0 -2 0 0 0 0 7 0 0.0025 \n1 1 1 0.02 0 0.05 0 0 0 0 0 0 0 0 0 0 0 0 0.0025 \n",
      {.plane = Plane::xz});
  EXPECT_EQ(file.format, "LIGGGHTS dump");
  ASSERT_EQ(file.grains.size(), 2U);
  EXPECT_EQ(file.grains[1].position, (Vec<2>{{0.01, 0.02}}));
  EXPECT_EQ(file.grains[1].velocity, (Vec<2>{{1.0, -2.0}}));
  EXPECT_EQ(file.grains[1].spin, -7.0);
  EXPECT_EQ(file.snapshot, 5000);
}

TEST_F(OtherProgramsTest, ExtendedXyz) {
  const std::string head =
      "2\nLattice=\"20 0 0 0 30 0 0 0 1\" Origin=\"-10 0 0\" pbc=\"T F F\" "
      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1:force:R:3 Time=0\n";
  const std::string rows = "sand 0 1 0 1 2 3 0.5 4 0 0 0\nclay 2 1 0 0 0 0 0.25 2 0 0 0\n";
  const auto file = read(head + rows);
  EXPECT_EQ(file.format, "extended XYZ file");
  ASSERT_EQ(file.grains.size(), 2U);
  EXPECT_EQ(file.grains[1].id, 4);
  EXPECT_EQ(file.grains[1].velocity, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(file.grains[1].radius, 0.5);
  EXPECT_EQ(file.types, (Lines{"sand", "clay"}));
  EXPECT_EQ(file.grains[0].material, 1);
  EXPECT_EQ(file.left_out, (Lines{"vz", "force"}));
  ASSERT_TRUE(file.box);
  EXPECT_EQ(file.box->low[0], -10.0);
  EXPECT_EQ(file.box->high[0], 10.0);
  EXPECT_EQ(file.box->sides[0], "periodic");
  EXPECT_EQ(file.box->sides[1], "open");
  const std::string later = "1\nProperties=species:S:1:pos:R:3:radius:R:1 Timestep=70\nA 5 6 0 1\n";
  EXPECT_EQ(read(head + rows + later).grains.at(0).position[0], 5.0) << "the last frame";
  EXPECT_EQ(read(head + rows + later, {.step = 0}).grains.size(), 2U) << "frames without a step count from 0";
  EXPECT_EQ(read(head + rows + later, {.step = 70}).snapshots, 2U);
  EXPECT_EQ(refused("1\na comment\nA 0 1 0\n"),
            ":2: is an XYZ file without radii; write extended XYZ with pos and radius, "
            "as in Properties=species:S:1:pos:R:3:radius:R:1");
  EXPECT_EQ(refused(head + "sand 0 1 0 1 2 3 0.5 4 0 0 0\n"), ":3: the file ends after 1 of 2 grains");
}

TEST_F(OtherProgramsTest, YadeTexts) {
  const auto plain = read("#format x_y_z_r\n1\t2\t0\t0.5\n3\t4\t0\t0.25\n");
  EXPECT_EQ(plain.format, "text export of YADE, x_y_z_r");
  ASSERT_EQ(plain.grains.size(), 2U);
  EXPECT_EQ(plain.grains[1].position, (Vec<2>{{3.0, 4.0}}));
  EXPECT_EQ(plain.grains[1].radius, 0.25);
  const auto materials = read("#format id_x_y_z_r_matId\n# a comment\n8\t1\t2\t0\t0.5\t1\n", {.plane = Plane::yz});
  EXPECT_EQ(materials.grains.at(0).id, 8);
  EXPECT_EQ(materials.grains.at(0).material, 1) << "they count from 0";
  EXPECT_EQ(materials.grains.at(0).position, (Vec<2>{{2.0, 0.0}}));
  const auto attributes = read("#format x_y_z_r_attrs\n#x y z r speed\n1\t2\t0\t0.5\t9\n");
  EXPECT_EQ(attributes.grains.at(0).radius, 0.5);
  EXPECT_EQ(attributes.left_out.size(), 1U);
  EXPECT_EQ(refused("#format jointedPM\n1 2 3\n"),
            ":1: the format jointedPM of YADE has no positions and radii; export it as x_y_z_r or x_y_z_r_matId");
}

TEST_F(OtherProgramsTest, MercuryData) {
  const auto solid = read("2 0.5 -1 0 -2 9 8 7 \n1 2 3 4 5 6 0.5 0 0 0 7 8 9 0\n4 5 6 0 0 0 0.25 0 0 0 0 0 0 1\n");
  EXPECT_EQ(solid.format, ".data file of MercuryDPM in 3 dimensions");
  ASSERT_EQ(solid.grains.size(), 2U);
  EXPECT_EQ(solid.grains[0].position, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(solid.grains[0].velocity, (Vec<2>{{4.0, 5.0}}));
  EXPECT_EQ(solid.grains[0].spin, 9.0);
  EXPECT_EQ(solid.grains[0].radius, 0.5);
  EXPECT_EQ(solid.box->high[0], 9.0);
  EXPECT_EQ(solid.box->low[1], 0.0);
  const std::string flat = "1 0 -1 0 9 8 \n1 2 3 4 0.5 0 6 0\n";
  EXPECT_EQ(read(flat).grains.at(0).spin, 6.0);
  EXPECT_EQ(read(flat + "1 0.1 -1 0 9 8\n7 2 3 4 0.5 0 6 0\n").grains.at(0).position[0], 7.0) << "the last snapshot";
  EXPECT_EQ(read(flat + "1 0.1 -1 0 9 8\n7 2 3 4 0.5 0 6 0\n", {.step = 0}).grains.at(0).position[0], 1.0);
  EXPECT_EQ(refused("2 0 -1 0 9 8 \n1 2 3 4 0.5 0 6 0\n"), ":2: the file ends after 1 of 2 grains");
}

// The lists that PFC prints and users write: names of their own, vectors in brackets are not needed.
TEST_F(OtherProgramsTest, PfcTables) {
  const auto file = read("ID Radius Pos-X Pos-Y Vel-X Vel-Y Density\n4 0.5 1.0 2.0 0.1 0.2 2650\n");
  EXPECT_EQ(file.grains.at(0).id, 4);
  EXPECT_EQ(file.grains.at(0).position, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(file.grains.at(0).velocity, (Vec<2>{{0.1, 0.2}}));
  EXPECT_EQ(file.left_out, (Lines{"Density"}));
  EXPECT_TRUE(refused("ITASCA GEOMETRY3D\nNODES\n").starts_with(": is a geometry of ITASCA; write the balls"));
}

}  // namespace
}  // namespace repose
