// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/csv_tables.hpp"
#include "repose/io/exports.hpp"
#include "repose/io/grains_file.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/start_file.hpp"
#include "repose/io/state.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <tuple>

// Spheres in files: what is written is read back with the same bits, and other programs' files keep all three axes.

namespace repose {
namespace {

using Lines = std::vector<std::string>;

class Files3dTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  GrainsFile<3> read(const std::string& text, const GrainsFileOptions& options = {}) const {
    std::ofstream(path("f"), std::ios::binary) << text;
    return read_grains_file<3>(path("f"), options);
  }
  std::string refused(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path("f").size());
    }
    return "none";
  }
  std::string content(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const testing::TemporaryFolder folder_;
};

/// Numbers that need all 17 digits, including extreme ones. Every third radius is a power of two, whose spin is exact.
Moment<3> awkward_moment() {
  Grains<3> grains;
  for (int k = 0; k < 50; ++k) {
    Grain<3> grain;
    grain.position = {{std::sin(k) * std::pow(10.0, k % 7 - 3), -std::exp(0.37 * k), std::cos(2.0 * k) / 7.0}};
    grain.velocity = {{k == 7 ? 5e-324 : std::cos(3.0 * k) / 3.0, k == 8 ? -0.0 : 1e300 / (k + 1.0), 0.1 * k - 2.0}};
    grain.radius = k % 3 == 0 ? 0.25 : 0.5 + 0.1 * std::sin(5.0 * k);
    grain.rim_velocity = Vec<3>{{std::sin(7.0 * k), -std::cos(k) / 9.0, 1e-5 * k}};
    grain.mass = grain.radius * grain.radius * grain.radius / 3.0;
    grain.inverse_mass = k % 5 == 0 ? 0.0 : 1.0 / grain.mass;
    grains.add(grain, 2 * k, k % 10 == 0, static_cast<std::uint16_t>(k % 3));
  }
  Contacts<3> contacts;
  for (int k = 0; k < 20; ++k) {
    Contact<3> contact;
    contact.first = 2 * k;
    contact.second = k % 6 == 0 ? wall_partner(k % 2) : 2 * k + 2;
    contact.normal = {{0.48, 0.6, 0.64}};
    contact.overlap = 1e-3 / (k + 1.0);
    contact.relative_overlap = 2e-3 / (k + 1.0);
    contact.normal_force = k == 3 ? -0.125 : std::exp(-k);
    contact.tangential_force = {{0.1 * k, std::sin(k), -1.0 / (k + 3.0)}};
    contact.slip = {{1e-9 * k, -1e-7, std::cos(k)}};
    contact.rolling = {{k / 7.0, 0.0, -0.25}};
    contact.first_lever = 0.3 + 1e-3 * k;
    contact.sliding = k % 4 == 0;
    contacts.list.push_back(contact);
  }
  contacts.sort();
  return {1.0 / 3.0, 12345, {grains, {}}, contacts};
}

void write_state(const std::string& path, const Moment<3>& moment) {
  Hdf5File file(path);
  write_grains(file, moment.grains);
  write_contacts(file, blocks_of(moment.contacts), moment.grains, true);
  file.commit();
}

TEST_F(Files3dTest, StatesReadBackTheSameBits) {
  const auto moment = awkward_moment();
  write_state(path("state.h5"), moment);
  const Hdf5Reader file(path("state.h5"));
  EXPECT_EQ(dimension_of_state(file), 3);
  const auto grains = read_grains<3>(file);
  ASSERT_EQ(grains.size(), moment.grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& one = grains.line[k];
    const auto& other = moment.grains->line[k];
    EXPECT_EQ(one.position, other.position);
    EXPECT_EQ(one.velocity, other.velocity);
    if (k % 3 == 0) {
      EXPECT_EQ(one.rim_velocity, other.rim_velocity);
    }
    // Over the radius and times it again: two roundings of a relative 1.1e-16 each, and one of its inverse.
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(one.rim_velocity[a], other.rim_velocity[a], 4e-16);
    EXPECT_EQ(one.radius, other.radius);
    EXPECT_EQ(one.mass, other.mass);
    EXPECT_EQ(one.inverse_mass, other.inverse_mass);
    EXPECT_EQ(grains.id[k], moment.grains->id[k]);
    EXPECT_EQ(grains.base[k], moment.grains->base[k]);
    EXPECT_EQ(grains.material[k], moment.grains->material[k]);
  }
  const auto contacts = read_contacts<3>(file);
  ASSERT_EQ(contacts.size(), moment.contacts.size());
  const auto all = [](const Contact<3>& c) {
    return std::tie(c.first, c.second, c.normal, c.overlap, c.relative_overlap, c.normal_force, c.tangential_force,
                    c.slip, c.rolling, c.first_lever, c.sliding);
  };
  for (std::size_t k = 0; k < contacts.size(); ++k) EXPECT_EQ(all(contacts.list[k]), all(moment.contacts.list[k])) << k;
}

TEST_F(Files3dTest, ColumnsHaveThreeNumbersAndTheirMeanings) {
  write_state(path("state.h5"), awkward_moment());
  const Hdf5Reader file(path("state.h5"));
  for (const auto* name : {"grains/position", "grains/velocity", "grains/spin"}) {
    EXPECT_EQ(file.shape(name), (std::vector<std::size_t>{50, 3})) << name;
  }
  for (const auto* name : {"normal", "tangential_force", "history", "rolling", "point"}) {
    EXPECT_EQ(file.shape(std::string("contacts/") + name), (std::vector<std::size_t>{20, 3})) << name;
  }
  EXPECT_EQ(file.text("contacts/tangential_force", "meaning"), "on the first, in the tangent plane");
  EXPECT_EQ(file.text("grains/spin", "meaning"), "angular velocity, along its axis");
  const auto in_the_plane = [](const auto& columns, const std::string& name) {
    for (const auto& column : columns) {
      if (column.name == name) return column.meaning;
    }
    return std::string("no such column");
  };
  EXPECT_EQ(in_the_plane(grain_state_columns<2>(), "spin"), "angular velocity, counter-clockwise");
  EXPECT_EQ(in_the_plane(contact_columns<2>(), "tangential_force"),
            "on the first, along the normal turned by +90 degrees");
}

TEST_F(Files3dTest, ASphereWithoutAPlaceIsRefused) {
  for (int axis = 0; axis < 3; ++axis) {
    Grains<3> grains;
    Grain<3> grain;
    grain.radius = grain.mass = 1.0;
    grain.position[axis] = std::nan("");
    grains.add(grain, 4);
    Hdf5File file(path("state.h5"));
    write_grains(file, OrderedGrains<3>(grains, {}));
    file.commit();
    EXPECT_THROW(read_grains<3>(Hdf5Reader(path("state.h5"))), InputError) << axis;
  }
}

/// A state of one contact, so that each of its numbers can be changed.
struct SmallState {
  Grains<3> grains;
  Contacts<3> contacts;

  SmallState() {
    Grain<3> grain;
    grain.radius = grain.mass = 0.5;
    grains.add(grain, 0);
    grains.half_step.resize(1);
    contacts.list.push_back({});
  }
  std::string hash() const { return state_hash(grains, blocks_of(contacts)); }
};

TEST_F(Files3dTest, EveryNumberOfTheMotionCountsInTheHash) {
  const auto before = SmallState().hash();
  EXPECT_EQ(before, SmallState().hash());
  std::vector<std::string> hashes{before};
  const auto changed = [&](const auto& change) {
    SmallState state;
    change(state);
    hashes.push_back(state.hash());
  };
  constexpr double least = 5e-324;
  for (int a = 0; a < 3; ++a) {
    changed([&](auto& s) { s.grains.line[0].position[a] = least; });
    changed([&](auto& s) { s.grains.line[0].velocity[a] = least; });
    changed([&](auto& s) { s.grains.line[0].rim_velocity[a] = least; });
    changed([&](auto& s) { s.grains.half_step[0].velocity[a] = least; });
    changed([&](auto& s) { s.grains.half_step[0].rim_velocity[a] = least; });
    changed([&](auto& s) { s.contacts.list[0].slip[a] = least; });
  }
  changed([&](auto& s) { s.grains.line[0].mass = 0.25; });
  changed([&](auto& s) { s.grains.line[0].radius = 0.25; });
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end()) << "two states have the same hash";
}

// The stream of a plane state is fixed: ids; x, y, vx, vy, rim velocity, radius, mass of each; half steps; contacts.
TEST_F(Files3dTest, TheHashOfAPlaneStateIsThatOfItsNumbersInOrder) {
  Grains<2> grains;
  for (int k = 0; k < 2; ++k) {
    Grain<2> grain;
    grain.position = {{1.0 + k, 2.0}};
    grain.velocity = {{3.0, 4.0 - k}};
    grain.rim_velocity = 5.0;
    grain.radius = 6.0;
    grain.mass = 7.0;
    grains.add(grain, 8 + k);
    grains.half_step.resize(grains.size());
    grains.half_step.back() = {{{9.0, 10.0}}, 11.0};
  }
  Contacts<2> contacts;
  contacts.list.push_back({.first = 8, .second = 9, .slip = 12.0});
  Hash hash;
  const auto add = [&](auto value) { hash.add(&value, sizeof value); };
  for (const std::int64_t id : {8, 9}) add(id);
  for (int k = 0; k < 2; ++k) {
    for (const double number : {1.0 + k, 2.0, 3.0, 4.0 - k, 5.0, 6.0, 7.0}) add(number);
  }
  for (int k = 0; k < 2; ++k) {
    for (const double number : {9.0, 10.0, 11.0}) add(number);
  }
  add(std::int64_t{8});
  add(std::int64_t{9});
  add(12.0);
  EXPECT_EQ(state_hash(grains, blocks_of(contacts)), hash.text());
}

TEST_F(Files3dTest, TablesKeepAllThreeAxes) {
  const auto file = read("x,y,z,vx,vy,vz,omegax,omegay,omegaz,radius,id,fixed\n1,2,3,4,5,6,7,8,9,0.5,4,1\n");
  ASSERT_EQ(file.grains.size(), 1U);
  const auto& row = file.grains[0];
  EXPECT_EQ(row.position, (Vec<3>{{1.0, 2.0, 3.0}}));
  EXPECT_EQ(row.velocity, (Vec<3>{{4.0, 5.0, 6.0}}));
  EXPECT_EQ(row.spin, (Vec<3>{{7.0, 8.0, 9.0}}));
  EXPECT_TRUE(row.fixed);
  EXPECT_TRUE(file.left_out.empty());
  const auto paraview = read(
      "\"Points:0\",\"Points:1\",\"Points:2\",\"spin:0\",\"spin:1\",\"spin:2\",\"radius\"\n"
      "1,2,3,4,5,6,0.5\n");
  EXPECT_EQ(paraview.grains.at(0).spin, (Vec<3>{{4.0, 5.0, 6.0}}));
}

TEST_F(Files3dTest, FilesInThePlaneAreRefused) {
  EXPECT_EQ(refused("x,y,radius\n1,2,3\n"),
            ":1: must have the columns x, y, z, and radius or diameter; has x, y, radius");
  EXPECT_EQ(refused("ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff pp\n0 1\n0 1\n0 1\n"
                    "ITEM: ATOMS x y radius\n1 2 3\n"),
            ":9: must have the columns x y z (or xu yu zu, xs ys zs, xsu ysu zsu) and radius or diameter: dump custom "
            "... id type x y z radius");
  EXPECT_EQ(refused("1\nProperties=species:S:1:pos:R:2:radius:R:1\nA 0 1 1\n"),
            ":2: is an XYZ file in two dimensions; spheres need pos:R:3");
  EXPECT_EQ(refused("1 0 -1 0 9 8 \n1 2 3 4 0.5 0 6 0\n"), ":1: is in two dimensions; spheres need three");
  EXPECT_EQ(refused("x,y,z,vz,radius\n1,2,3,fast,1\n"), ":2: vz = fast: must be a finite number");
}

TEST_F(Files3dTest, LammpsDumps) {
  const auto file = read(
      "ITEM: UNITS\nsi\nITEM: TIMESTEP\n70\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n"
      "-1 9\n0 8\n-2 6\nITEM: ATOMS id type xs ys zs vz omegax diameter c_stress\n"
      "3 2 0.25 0.5 0.125 4 5 1 nan\n");
  const auto& row = file.grains.at(0);
  EXPECT_EQ(row.position, (Vec<3>{{-1.0 + 0.25 * 10.0, 4.0, -1.0}}));
  EXPECT_EQ(row.velocity, (Vec<3>{{0.0, 0.0, 4.0}}));
  EXPECT_EQ(row.spin, (Vec<3>{{5.0, 0.0, 0.0}}));
  ASSERT_TRUE(file.box);
  EXPECT_EQ(file.box->low, (Vec<3>{{-1.0, 0.0, -2.0}}));
  EXPECT_EQ(file.box->high, (Vec<3>{{9.0, 8.0, 6.0}}));
  EXPECT_EQ(file.box->sides, (std::array<std::string, 3>{"periodic", "open", "open"}));
  EXPECT_EQ(file.snapshot, 70);
  EXPECT_EQ(file.left_out, (Lines{"c_stress"}));
}

// The mass of an atom of style sphere is that of a sphere: density pi d^3/6.
TEST_F(Files3dTest, LammpsDataFiles) {
  const auto file = read(
      "LAMMPS data file via write_data, units = si\n\n2 atoms\n2 atom types\n\n-1 9 xlo xhi\n0 20 ylo yhi\n-5 50 zlo "
      "zhi\n\nAtoms # sphere\n\n7 2 1.0 3.0 1.5 2.5 0.25 0 0 0\n3 1 0.5 3.0 4.0 0.5 -2 0 0 0\n\nVelocities\n\n"
      "3 0.1 0.2 0.3 1 2 3\n7 0 0 0 0 0 -4\n");
  ASSERT_EQ(file.grains.size(), 2U);
  EXPECT_EQ(file.grains[0].id, 3);
  EXPECT_EQ(file.grains[0].position, (Vec<3>{{4.0, 0.5, -2.0}}));
  EXPECT_EQ(file.grains[0].velocity, (Vec<3>{{0.1, 0.2, 0.3}}));
  EXPECT_EQ(file.grains[0].spin, (Vec<3>{{1.0, 2.0, 3.0}}));
  EXPECT_NEAR(*file.grains[1].mass, 3.0 * std::numbers::pi / 6.0, 1e-15) << "one rounding of a product";
  ASSERT_TRUE(file.box);
  EXPECT_EQ(file.box->low, (Vec<3>{{-1.0, 0.0, -5.0}}));
  EXPECT_EQ(file.box->high, (Vec<3>{{9.0, 20.0, 50.0}}));
}

TEST_F(Files3dTest, FilesOfOtherPrograms) {
  const auto mercury = read("1 0.5 -1 0 -2 9 8 7 \n1 2 3 4 5 6 0.5 0 0 0 7 8 9 0\n");
  EXPECT_EQ(mercury.grains.at(0).position, (Vec<3>{{1.0, 2.0, 3.0}}));
  EXPECT_EQ(mercury.grains.at(0).spin, (Vec<3>{{7.0, 8.0, 9.0}}));
  EXPECT_EQ(mercury.box->low, (Vec<3>{{-1.0, 0.0, -2.0}}));
  EXPECT_EQ(mercury.box->high, (Vec<3>{{9.0, 8.0, 7.0}}));
  const auto yade = read("#format x_y_z_r_matId\n1\t2\t3\t0.5\t1\n");
  EXPECT_EQ(yade.grains.at(0).position, (Vec<3>{{1.0, 2.0, 3.0}}));
  EXPECT_EQ(yade.grains.at(0).material, 1);
  const auto xyz = read(
      "1\nLattice=\"20 0 0 0 30 0 0 0 40\" Origin=\"-10 0 1\" pbc=\"T T F\" "
      "Properties=species:S:1:pos:R:3:velo:R:3:omega:R:3:radius:R:1\nsand 0 1 2 3 4 5 6 7 8 0.5\n");
  EXPECT_EQ(xyz.grains.at(0).position, (Vec<3>{{0.0, 1.0, 2.0}}));
  EXPECT_EQ(xyz.grains.at(0).velocity, (Vec<3>{{3.0, 4.0, 5.0}}));
  EXPECT_EQ(xyz.grains.at(0).spin, (Vec<3>{{6.0, 7.0, 8.0}}));
  EXPECT_EQ(xyz.box->high, (Vec<3>{{10.0, 30.0, 41.0}}));
  EXPECT_EQ(xyz.box->sides, (std::array<std::string, 3>{"periodic", "periodic", "open"}));
}

/// `spins` are those of the file: of a state divided by the radius, of a dump as printed.
void expect_same_bits(const std::vector<GrainRow<3>>& rows, const Grains<3>& grains, std::int64_t first_id,
                      const std::vector<Vec<3>>& spins) {
  ASSERT_EQ(rows.size(), grains.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    const auto& grain = grains.line[k];
    EXPECT_EQ(row.id, grains.id[k] + first_id);
    EXPECT_EQ(row.position, grain.position);
    EXPECT_EQ(row.velocity, grain.velocity);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::signbit(row.velocity[axis]), std::signbit(grain.velocity[axis]));
    EXPECT_EQ(row.spin, spins[k]);
    EXPECT_EQ(row.radius, grain.radius);
    EXPECT_EQ(row.mass, grain.mass);
    EXPECT_EQ(row.material, grains.material[k]);
    EXPECT_EQ(row.fixed, grain.fixed());
    EXPECT_EQ(row.base, grains.base[k] == 1);
  }
}

std::vector<Vec<3>> spins_of(const Grains<3>& grains, bool by_inverse) {
  std::vector<Vec<3>> spins;
  for (const auto& grain : grains.line) {
    Vec<3> spin;
    for (int a = 0; a < 3; ++a) {
      spin[a] = by_inverse ? grain.rim_velocity[a] * (1.0 / grain.radius) : grain.rim_velocity[a] / grain.radius;
    }
    spins.push_back(spin);
  }
  return spins;
}

TEST_F(Files3dTest, ExportedDumpsReadBackTheSameBits) {
  const auto moment = awkward_moment();
  Box<3> box;
  box.periodic = box.periodic_y = true;
  box.x_min = -7.0;
  box.x_max = 8.0;
  box.y_min = -1.0 / 3.0;
  box.y_max = 9.0;
  WholeFile file(path("grains.dump"));
  add_grains_for_lammps<3>(file, {0.0, 1, {}, {}}, box);  // a snapshot without grains before
  add_grains_for_lammps<3>(file, moment, box);
  file.commit();
  const auto back = read_grains_file<3>(path("grains.dump"));
  expect_same_bits(back.grains, *moment.grains, 1, spins_of(*moment.grains, false));
  ASSERT_TRUE(back.box);
  EXPECT_EQ(back.box->sides, (std::array<std::string, 3>{"periodic", "periodic", "open"}));
  EXPECT_EQ(back.box->low[1], -1.0 / 3.0);
  double top = -1e300;
  for (const auto& grain : moment.grains->line) top = std::max(top, grain.position[2] + grain.radius);
  EXPECT_EQ(back.box->high[2], top) << "the height is that of the grains";
}

TEST_F(Files3dTest, ExportedTablesReadBackTheSameBits) {
  const auto moment = awkward_moment();
  write_state(path("run.h5"), moment);
  const Hdf5Reader reader(path("run.h5"));
  for (const auto& table : csv_tables(reader)) write_csv(path(table.name + ".csv"), reader, table);
  expect_same_bits(read_grains_file<3>(path("grains.csv")).grains, *moment.grains, 0, spins_of(*moment.grains, true));
  EXPECT_NE(content("contacts.csv").find("tangential_force_x,tangential_force_y,tangential_force_z"),
            std::string::npos);
}

// Fields over the distance from an axis and the height: a row for each place, r fastest.
TEST_F(Files3dTest, FieldsAboutAnAxisAreOneTable) {
  Hdf5File made(path("fields.h5"));
  made.group("axial");
  made.dataset("axial/r", std::vector<double>{0.5, 1.5, 2.5}, 1, "L", "");
  made.dataset("axial/z", std::vector<double>{1.0, 2.0}, 1, "L", "");
  made.dataset("axial/density", std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 3, "M/L^3", "");
  made.commit();
  const Hdf5Reader reader(path("fields.h5"));
  const auto tables = csv_tables(reader);
  ASSERT_EQ(tables.size(), 1U);
  write_csv(path("axial.csv"), reader, tables[0]);
  const auto text = content("axial.csv");
  EXPECT_EQ(text.substr(text.find("r,z,density")),
            "r,z,density\n0.5,1,1\n1.5,1,2\n2.5,1,3\n0.5,2,4\n1.5,2,5\n2.5,2,6\n");
}

// Spheres whose centres lie in a plane are discs for a scene of two dimensions.
TEST_F(Files3dTest, APlanarFileOfSpheresIsReadInThePlane) {
  Grains<3> grains;
  Grain<3> grain;
  grain.position = {{1.0, 7.0, 3.0}};
  grain.velocity = {{4.0, 5.0, 6.0}};
  grain.rim_velocity = Vec<3>{{0.5, 1.0, 1.5}};
  grain.radius = 0.5;
  grain.mass = 2.0;
  grain.inverse_mass = 0.5;
  grains.add(grain, 0);
  WholeFile file(path("grains.dump"));
  add_grains_for_lammps<3>(file, {0.0, 1, {grains, {}}, {}}, {});
  file.commit();
  const auto row = read_grains_file<2>(path("grains.dump"), {.plane = Plane::xz}).grains.at(0);
  EXPECT_EQ(row.position, (Vec<2>{{1.0, 3.0}}));
  EXPECT_EQ(row.velocity, (Vec<2>{{4.0, 6.0}}));
  EXPECT_EQ(row.third, 7.0);
  EXPECT_EQ(row.spin, -2.0) << "y points away from the eye";
  EXPECT_EQ(row.mass, 2.0);
}

}  // namespace
}  // namespace repose
