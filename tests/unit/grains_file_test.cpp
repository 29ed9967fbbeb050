// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grains_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/csv_tables.hpp"
#include "repose/io/exports.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace repose {
namespace {

class GrainsFileTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  GrainsFile<2> file(const std::string& text, const GrainsFileOptions& options = {}) const {
    std::ofstream(path("f"), std::ios::binary) << text;
    return read_grains_file<2>(path("f"), options);
  }
  std::vector<GrainRow<2>> read(const std::string& text) const { return file(text).grains; }

  /// The problems of a file, without its path, with which each line must begin.
  std::vector<std::string> refused(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      auto lines = error.problems();
      for (auto& line : lines) {
        EXPECT_TRUE(line.starts_with(path("f") + ":")) << line;
        line = line.substr(path("f").size() + 1);
      }
      return lines;
    }
    ADD_FAILURE() << "was not refused:\n" << text;
    return {};
  }

  const testing::TemporaryFolder folder_;
};

using Lines = std::vector<std::string>;

TEST_F(GrainsFileTest, TableWithAllColumns) {
  const auto rows = read(
      "# a comment\n\nid,x,y,diameter,vx,vy,spin,mass,material,fixed,base\n7,1.5,-2e-3,1,+4,5,6,0.25,3,1,1\n"
      "3,0,1,0.5,0,0,0,1,0,0,0\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].id, 3) << "not by ascending id";
  const auto& row = rows[1];
  EXPECT_EQ(row.id, 7);
  EXPECT_EQ(row.position, (Vec<2>{{1.5, -2e-3}}));
  EXPECT_EQ(row.velocity, (Vec<2>{{4.0, 5.0}}));
  EXPECT_EQ(row.spin, 6.0);
  EXPECT_EQ(row.radius, 0.5);
  EXPECT_EQ(row.mass, 0.25);
  EXPECT_EQ(row.material, 3);
  EXPECT_TRUE(row.fixed && row.base);
  EXPECT_FALSE(rows[0].fixed || rows[0].base);
}

TEST_F(GrainsFileTest, TablesOfOtherProgramsAreReadToo) {
  for (const auto* text : {"x,y,radius\n1,2,3\n",
                           "x;y;radius\r\n1;2;3\r\n",
                           "x\ty\tradius\n1\t2\t3",
                           "radius,y,x\n3,2,1\n",
                           "\xEF\xBB\xBF\"x\", \"y\" , \"radius\"\n \"1\", 2 ,3\n",
                           "x y radius\n1 2 3\n",
                           "# x y radius\n1 2 3\n",
                           "% x, y, radius\r1, 2, 3\r",
                           "x;y;radius\n1,0;2,0;3,0\n",
                           "x y radius\n1,0 2,0 3,0\n",
                           "x,y,radius\n1.0D+00,2.0D+00,0.3d1\n",
                           "X,Y,Radius\n1,2,3\n",
                           "x,y,r\n1,2,3\n",
                           "x,y,d\n1,2,6\n",
                           "x,y,radius,\n1,2,3,\n",
                           ",x,y,radius\n0,1,2,3\n",
                           "x,y,z,radius\n1,2,0,3\n",
                           "x,y,radius,fx\n1,2,3,nan\n",
                           "\"Points:0\",\"Points:1\",\"Points:2\",\"radius\",\"diameter\"\n1,2,0,3,6\n",
                           "Position.X Position.Y Position.Z Radius\n1 2 0 3\n",
                           "pos-x pos-y radius\n1 2 3\n",
                           "written by hand\nx,y,radius\n1,2,3\n",
                           "x,y,radius,distance,r\n1,2,3,5,9\n"}) {
    const auto rows = read(text);
    ASSERT_EQ(rows.size(), 1U) << text;
    EXPECT_EQ(rows[0].position, (Vec<2>{{1.0, 2.0}})) << text;
    EXPECT_EQ(rows[0].radius, 3.0) << text;
    EXPECT_FALSE(rows[0].id || rows[0].mass) << text;
  }
}

TEST_F(GrainsFileTest, WordsForTruthAndNumbersForIds) {
  const auto rows = read("id,x,y,radius,fixed,type\n2.0,1,2,3,True,sand\n1.000000e+00,1,8,3,FALSE,clay\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].id, 1);
  EXPECT_FALSE(rows[0].fixed);
  EXPECT_TRUE(rows[1].fixed);
  EXPECT_EQ(rows[1].material, 0);
  EXPECT_EQ(rows[0].material, 1);
  EXPECT_EQ(rows[0].line, 3U);
}

TEST_F(GrainsFileTest, ColumnsAreNamed) {
  const auto table = file(",x,y,radius,fx,colour\n0,1,2,3,4,red\n");
  EXPECT_EQ(table.format, "table");
  EXPECT_EQ(table.used, (Lines{"x", "y", "radius"}));
  EXPECT_EQ(table.left_out, (Lines{"column 1 (without a name)", "fx", "colour"}));
}

// Lengths are those of the first column with a unit, here m: a radius of 500 mm is 0.5 m, a velocity of 20 cm/s 0.2
// m/s.
TEST_F(GrainsFileTest, UnitsInTheHead) {
  const auto table = file("x (m),y [m],radius [mm],mass (g),vx (cm/s)\n1,2,500,30,20\n");
  EXPECT_EQ(table.units.length, 1.0);
  EXPECT_EQ(table.units.mass, 1e-3);
  ASSERT_EQ(table.grains.size(), 1U);
  EXPECT_DOUBLE_EQ(table.grains[0].radius, 0.5);
  EXPECT_DOUBLE_EQ(table.grains[0].velocity[0], 0.2);
  EXPECT_EQ(table.grains[0].mass, 30.0);
  const auto small = file("x_mm,y_mm,d_mm\n1,2,5\n");
  EXPECT_EQ(small.grains.at(0).radius, 2.5);
  EXPECT_EQ(file("x y radius\nmm mm mm\n1 2 3\n").units.length, 1e-3) << "a row of units";
  EXPECT_EQ(refused("x (furlong),y (m),radius\n1,2,3\n"),
            (Lines{"1: x: the unit furlong is unknown; use m, cm, mm, um, kg, g, m/s"}));
}

TEST_F(GrainsFileTest, PlanesOfATable) {
  const std::string text = "x,y,z,vx,vy,vz,omegax,omegay,omegaz,radius\n1,2,3,4,5,6,7,8,9,1\n";
  const auto xz = file(text, {.plane = Plane::xz}).grains.at(0);
  EXPECT_EQ(xz.position, (Vec<2>{{1.0, 3.0}}));
  EXPECT_EQ(xz.velocity, (Vec<2>{{4.0, 6.0}}));
  EXPECT_EQ(xz.third, 2.0);
  EXPECT_EQ(xz.spin, -8.0) << "x to the right and z up: y points away from the eye";
  const auto yz = file(text, {.plane = Plane::yz}).grains.at(0);
  EXPECT_EQ(yz.position, (Vec<2>{{2.0, 3.0}}));
  EXPECT_EQ(yz.spin, 7.0);
  EXPECT_EQ(refused("x,z,radius\n1,2,3\n"),
            (Lines{"1: must have the columns x, y, and radius or diameter; for these set "
                   "start.plane = \"xz\"; has x, z, radius"}));
}

TEST_F(GrainsFileTest, ProblemsOfTables) {
  EXPECT_EQ(refused(""), (Lines{" is empty: no line with the names of the columns"}));
  EXPECT_EQ(refused("x,y,radius\n"), (Lines{" no grains"}));
  EXPECT_EQ(refused("1,2,3\n"), (Lines{"1: must be the names of the columns, above the numbers"}));
  EXPECT_EQ(refused("x,y\n1,2\n"), (Lines{"1: must have the columns x, y, and radius or diameter; has x, y"}));
  EXPECT_EQ(refused("x,y,radius,position_x\n1,2,1,2\n"), (Lines{"1: position_x: occurs twice"}));
  EXPECT_EQ(refused("x,y,r,R\n1,2,1,2\n"), (Lines{"1: R: occurs twice"}));
  EXPECT_EQ(
      refused("# units\nx,y,radius\n1,2\n1,2,3,4\nnan,1,1\n1,inf,1\n1,1,one\n1,1,0\n1,1,-2\n1,,1\n1e999,1,1\n"),
      (Lines{"3: has 2 values; must have 3", "4: has 4 values; must have 3", "5: x = nan: must be a finite number",
             "6: y = inf: must be a finite number", "7: radius = one: must be a finite number",
             "8: radius = 0: must be > 0 [L]", "9: radius = -2: must be > 0 [L]", "10: y = : must be a finite number",
             "11: x = 1e999: must be a finite number"}));
  EXPECT_EQ(refused("id,x,y,radius,mass,material,fixed\n1,0,0,1,0,0,0\n2.5,0,0,1,1,0,0\n1,0,0,1,1,-1,0\n"
                    "1,0,0,1,1,65536,0\n1,0,0,1,1,0,2\n"),
            (Lines{"2: mass = 0: must be > 0 [M]", "3: id = 2.5: must be a whole number",
                   "4: material = -1: must be a whole number from 0 to 65535",
                   "5: material = 65536: must be a whole number from 0 to 65535",
                   "6: fixed = 2: must be 0 or 1, true or false"}));
  EXPECT_EQ(refused("id,x,y,radius\n4,0,0,1\n5,0,0,1\n4,0,0,1\n"), (Lines{"4: id = 4: is already in line 2"}));
}

TEST_F(GrainsFileTest, ManyProblemsAreCounted) {
  std::string text = "x,y,radius\n";
  for (int k = 0; k < 33; ++k) text += "1,1,bad\n";
  const auto lines = refused(text);
  ASSERT_EQ(lines.size(), 21U);
  EXPECT_EQ(lines[19], "21: radius = bad: must be a finite number");
  EXPECT_EQ(lines[20], " and 13 more problems");
}

TEST_F(GrainsFileTest, OtherFilesAreRefused) {
  EXPECT_TRUE(refused(std::string("x,y,radius\n\0", 12)).at(0).starts_with(" is binary; must be text"));
  EXPECT_TRUE(refused("\x89HDF\r\n\x1a\n").at(0).starts_with(" is an HDF5 file"));
  EXPECT_TRUE(refused("# vtk DataFile Version 3.0\nx\nASCII\n").at(0).starts_with(" is a legacy VTK file; open it in"));
  EXPECT_TRUE(refused("<?xml version=\"1.0\"?>\n<VTKFile>\n").at(0).starts_with(" is an XML file"));
  EXPECT_TRUE(refused("{\"x\": [1]}\n").at(0).starts_with(" is a JSON file; write a table"));
  EXPECT_THROW(read_grains_file<2>(path("nowhere")), InputError);
  EXPECT_THROW(read_grains_file<2>(folder_.path()), InputError);
}

std::string snapshot(const std::string& columns, const std::string& atoms, int count, int step = 5,
                     const std::string& bounds = "ff ff pp\n-10 30\n0 8\n-0.5 0.5\n") {
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" + std::to_string(count) +
         "\nITEM: BOX BOUNDS " + bounds + "ITEM: ATOMS " + columns + "\n" + atoms;
}

TEST_F(GrainsFileTest, LammpsDump) {
  const auto rows = read(snapshot("id type x y z vx vy vz omegax omegaz radius mass c_stress",
                                  "9 2 1 2 0 3 4 0 0 5 0.5 7 1e9\n4 1 6 7 0 0 0 0 0 0 0.25 1 nan \n", 2));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].id, 4);
  const auto& row = rows[1];
  EXPECT_EQ(row.id, 9);
  EXPECT_EQ(row.material, 1) << "types count from 1";
  EXPECT_EQ(row.position, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(row.velocity, (Vec<2>{{3.0, 4.0}}));
  EXPECT_EQ(row.spin, 5.0);
  EXPECT_EQ(row.radius, 0.5);
  EXPECT_EQ(row.mass, 7.0);
  EXPECT_FALSE(row.fixed);
}

TEST_F(GrainsFileTest, PositionsOfADump) {
  const auto place = [&](const std::string& columns) {
    return read(snapshot(columns + " diameter", "0.25 0.5 1 2 3\n", 1)).front();
  };
  EXPECT_EQ(place("xs ys xu yu").position, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(place("xu yu x y").position, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(place("xs ys ix iy").position, (Vec<2>{{-10.0 + 0.25 * 40.0, 0.5 * 8.0}}));
  EXPECT_EQ(place("xsu ysu ix iy").radius, 1.5);
}

TEST_F(GrainsFileTest, FactsOfADump) {
  const auto dump = file("ITEM: UNITS\nsi\n" + snapshot("id type x y z radius c_stress", "1 2 3 4 0.25 0.5 nan\n", 1, 7,
                                                        "pp ff pp\n-1 9\n0 8\n-0.5 0.5\n"));
  EXPECT_EQ(dump.format, "LAMMPS dump");
  EXPECT_EQ(dump.snapshot, 7);
  EXPECT_EQ(dump.units.length, 1.0);
  EXPECT_EQ(dump.left_out, (Lines{"c_stress"}));
  ASSERT_TRUE(dump.box);
  EXPECT_EQ(dump.box->low[0], -1.0);
  EXPECT_EQ(dump.box->high[0], 9.0);
  EXPECT_EQ(dump.box->sides[0], "periodic");
  EXPECT_EQ(dump.box->sides[1], "open");
  EXPECT_EQ(dump.grains.at(0).third, 0.25);
  EXPECT_EQ(dump.grains.at(0).type, 2);
  const auto upright = file(snapshot("x y z radius", "1 2 3 0.5\n", 1), {.plane = Plane::xz});
  EXPECT_EQ(upright.grains.at(0).position, (Vec<2>{{1.0, 3.0}}));
  EXPECT_EQ(upright.box->high[1], 0.5) << "the third axis of the box is the height";
}

TEST_F(GrainsFileTest, TheLastSnapshotOfADumpCounts) {
  const auto rows = read("ITEM: UNITS\nlj\nITEM: TIME\n0.1\n" + snapshot("x y radius", "bad bad bad\n1 1 1\n", 2, 1) +
                         "ITEM: TIME\n0.2\n" + snapshot("radius x y", "1 2 3\n", 1, 2));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].position, (Vec<2>{{2.0, 3.0}}));
}

TEST_F(GrainsFileTest, ASnapshotOfADumpCanBeChosen) {
  std::ofstream(path("f")) << snapshot("x y radius", "1 1 1\n", 1, 10) +
                                  snapshot("x y radius", "2 2 1\n3 3 1\n", 2, 20) +
                                  snapshot("x y radius", "bad 4 1\n", 1, 30) + "ITEM: TIMESTEP\n40\n";
  EXPECT_EQ(read_grains_file<2>(path("f"), {.step = 10}).grains.at(0).position[0], 1.0);
  EXPECT_EQ(read_grains_file<2>(path("f"), {.step = 20}).grains.size(), 2U);
  EXPECT_THROW(read_grains_file<2>(path("f"), {.step = 30}), InputError);
  EXPECT_THROW(read_grains_file<2>(path("f")), InputError) << "the last one is not complete";
  std::ofstream(path("g")) << snapshot("x y radius", "1 1 1\n", 1, 10);
  try {
    read_grains_file<2>(path("g"), {.step = 11});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path("g") + ":10: no snapshot of step 11; the last is of step 10");
  }
  std::ofstream(path("t")) << "x,y,radius\n1,1,1\n";
  EXPECT_THROW(read_grains_file<2>(path("t"), {.step = 0}), InputError);
}

TEST_F(GrainsFileTest, ProblemsOfDumps) {
  const auto only = [&](const std::string& text, const std::string& line) { EXPECT_EQ(refused(text), (Lines{line})); };
  const std::string columns =
      "9: must have the columns x y (or xu yu, xs ys, xsu ysu) and radius or diameter: dump custom ... id type x y z "
      "radius";
  only(snapshot("id x y", "1 1 1\n", 1), columns);
  only(snapshot("id x ys radius", "1 1 1 1\n", 1), columns);
  only(snapshot("x y radius", "", 0), " no grains");
  only(snapshot("x y radius", "1 1 1\n", 2), "10: the file ends after 1 of 2 grains");
  only(snapshot("x y radius", "1 1 1\n2 2 2\n", 1), "11: must be an ITEM: of a LAMMPS text dump");
  only(snapshot("x y radius", "1 1\n", 1), "10: has 2 values; must have 3");
  only(snapshot("x y radius", "1 nan 1\n", 1), "10: y = nan: must be a finite number");
  only(snapshot("type x y radius", "0 1 1 1\n", 1), "10: type = 0: must be a whole number from 1 to 65536");
  only(snapshot("xs ys radius", "0 0 1\n", 1, 5, "xy xz yz pp pp pp\n0 9 1\n0 8 0\n0 1 0\n"),
       "9: scaled positions in a tilted box: dump x y or xu yu");
  only("ITEM: TIMESTEP\nsoon\n", "2: must be the number of a step");
  only("ITEM: TIMESTEP\n", "1: the file ends in the middle of a snapshot");
  only("ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n1\n", "4: the file ends in the middle of a snapshot");
  only("ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n-1\n", "4: must be the number of atoms");
  only("ITEM: TIMESTEP\n3\nITEM: BOX BOUNDS pp pp pp\n0 1\nwide\n", "5: must be the bounds of the box");
  only("ITEM: TIMESTEP\n3\n" + snapshot("x y radius", "1 1 1\n", 1),
       "3: a snapshot begins before the one above has its ITEM: ATOMS");
  only("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y radius\n1 1 1\n",
       "3: ITEM: TIMESTEP and ITEM: NUMBER OF ATOMS must come before");
  only("ITEM: TIME\n3\n", "1: no snapshot: no ITEM: TIMESTEP");
  only("ITEM: TIMESTEP\n3\nITEM: NUMBER OF ENTRIES\n1\n", "3: is a dump of contacts (local), not of grains");
  only("ITEM: TIMESTEP\n3\nITEM: COLOUR\n1\n", "3: is an unknown ITEM: of a LAMMPS text dump");
  only(snapshot("id x y radius", "3 1 1 1\n3 2 2 1\n", 2), "11: id = 3: is already in line 10");
}

/// Numbers that need all 17 digits, including extreme ones.
Moment<2> awkward_moment() {
  Grains<2> grains;
  for (int k = 0; k < 50; ++k) {
    Grain<2> grain;
    grain.position = {{std::sin(k) * std::pow(10.0, k % 7 - 3), -std::exp(0.37 * k)}};
    grain.velocity = {{k == 7 ? 5e-324 : std::cos(3.0 * k) / 3.0, k == 8 ? -0.0 : 1e300 / (k + 1.0)}};
    grain.radius = 0.5 + 0.1 * std::sin(5.0 * k);
    grain.mass = grain.radius * grain.radius / 3.0;
    grain.inverse_mass = k % 5 == 0 ? 0.0 : 1.0 / grain.mass;
    grains.add(grain, 2 * k, k % 10 == 0, static_cast<std::uint16_t>(k % 3));
  }
  return {1.0 / 3.0, 12345, {grains, {}}, {}};
}

void expect_same_bits(const std::vector<GrainRow<2>>& rows, const Grains<2>& grains, std::int64_t first_id) {
  ASSERT_EQ(rows.size(), grains.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    const auto& grain = grains.line[k];
    EXPECT_EQ(row.id, grains.id[k] + first_id);
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(row.position[axis], grain.position[axis]);
      EXPECT_EQ(row.velocity[axis], grain.velocity[axis]);
      EXPECT_EQ(std::signbit(row.velocity[axis]), std::signbit(grain.velocity[axis]));
    }
    EXPECT_EQ(row.radius, grain.radius);
    EXPECT_EQ(row.mass, grain.mass);
    EXPECT_EQ(row.material, grains.material[k]);
    EXPECT_EQ(row.fixed, grain.fixed());
    EXPECT_EQ(row.base, grains.base[k] == 1);
  }
}

TEST_F(GrainsFileTest, ExportedDumpsReadBackTheSameBits) {
  const auto moment = awkward_moment();
  WholeFile file(path("grains.dump"));
  add_grains_for_lammps<2>(file, {0.0, 1, {}, {}}, {});  // a snapshot without grains before
  add_grains_for_lammps<2>(file, moment, {});
  file.commit();
  expect_same_bits(read_grains_file<2>(path("grains.dump")).grains, *moment.grains, 1);
}

TEST_F(GrainsFileTest, ExportedTablesReadBackTheSameBits) {
  const auto moment = awkward_moment();
  Hdf5File file(path("run.h5"));
  write_grains(file, moment.grains);
  file.commit();
  const Hdf5Reader reader(path("run.h5"));
  const auto tables = csv_tables(reader);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].name, "grains");
  write_csv(path("grains.csv"), reader, tables[0]);
  expect_same_bits(read_grains_file<2>(path("grains.csv")).grains, *moment.grains, 0);
}

}  // namespace
}  // namespace repose
