// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/exports.hpp"
#include "repose/run_folder/moment_stress.hpp"
#include "repose/run_folder/moments.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

// Spheres, their contacts and walls as VTK, OVITO and LAMMPS get them.

namespace repose {
namespace {

class Exports3dTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string content(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const testing::TemporaryFolder folder_;
};

/// Two spheres of radius 0.5 that touch across the side of a box of depth 10, and a wall below the first.
Moment<3> pair_across_a_side() {
  Grains<3> grains;
  for (int k = 0; k < 2; ++k) {
    Grain<3> grain;
    grain.position = {{0.0, k == 0 ? 0.25 : 9.25, 0.5}};
    grain.radius = 0.5;
    grain.mass = 1.0;
    grain.inverse_mass = 1.0;
    grain.rim_velocity = Vec<3>{{0.0, 0.5, 1.0}};
    grains.add(grain, k);
  }
  Contacts<3> contacts;
  contacts.list.push_back(
      {.first = 0, .second = -1, .normal = {{0.0, 0.0, 1.0}}, .normal_force = 2.0, .first_lever = 0.5});
  contacts.list.push_back({.first = 0,
                           .second = 1,
                           .normal = {{0.0, 1.0, 0.0}},
                           .normal_force = 3.0,
                           .tangential_force = {{3.0, 0.0, 4.0}},
                           .first_lever = 0.5});
  return {0.5, 7, {grains, {}}, contacts};
}

Box<3> deep_box() {
  Box<3> box;
  box.periodic_y = true;
  box.y_min = 0.0;
  box.y_max = 10.0;
  return box;
}

const auto& values_of(const std::vector<VtkArray>& arrays, const std::string& name, std::size_t components) {
  for (const auto& array : arrays) {
    if (array.name != name) continue;
    EXPECT_EQ(array.components, components) << name;
    return std::get<std::vector<double>>(array.values);
  }
  throw std::out_of_range(name);
}

using Numbers = std::vector<double>;

TEST_F(Exports3dTest, SpheresForVtkArePointsInSpace) {
  auto moment = pair_across_a_side();
  moment.stress = {{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}, {}};
  moment.extent = {0.75, 1.0};
  const auto data = grains_for_vtk(moment);
  EXPECT_EQ(data.points, (Numbers{0.0, 0.25, 0.5, 0.0, 9.25, 0.5}));
  EXPECT_EQ(values_of(data.point_data, "spin", 3), (Numbers{0.0, 1.0, 2.0, 0.0, 1.0, 2.0}));
  const auto& stress = values_of(data.point_data, "stress", 9);
  EXPECT_EQ(Numbers(stress.begin(), stress.begin() + 9), (Numbers{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}));
  EXPECT_EQ(values_of(data.point_data, "stress_volume", 1), (Numbers{0.75, 1.0}));
  // m v^2/2 + I w^2/2 with I = 2/5 m r^2: the rim velocity squared is 1.25.
  EXPECT_DOUBLE_EQ(values_of(data.point_data, "kinetic_energy", 1)[0], 0.5 * 1.25 / 2.5);
}

TEST_F(Exports3dTest, ContactsForVtkEndAtTheNearestImage) {
  const auto data = contacts_for_vtk(pair_across_a_side(), deep_box(), true);
  ASSERT_EQ(data.points.size(), 12U);
  EXPECT_EQ(Numbers(data.points.begin() + 3, data.points.begin() + 6), (Numbers{0.0, 0.25, 0.0})) << "at the wall";
  EXPECT_EQ(Numbers(data.points.begin() + 9, data.points.end()), (Numbers{0.0, -0.75, 0.5})) << "outside the box";
  EXPECT_EQ(values_of(data.cell_data, "force", 3), (Numbers{0.0, 0.0, 2.0, 3.0, 3.0, 4.0}));
  EXPECT_EQ(values_of(data.cell_data, "tangential_force", 3), (Numbers{0.0, 0.0, 0.0, 3.0, 0.0, 4.0}));
  EXPECT_EQ(values_of(data.point_data, "tangential_force", 3),
            (Numbers{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 4.0, 3.0, 0.0, 4.0}));
  EXPECT_EQ(values_of(data.point_data, "normal_force", 1), (Numbers{2.0, 2.0, 3.0, 3.0}));
}

TEST_F(Exports3dTest, WallsForVtkAreTriangles) {
  const WallSurface square{
      {{{0.0, 0.0, 0.0}}, {{1.0, 0.0, 0.0}}, {{1.0, 1.0, 0.0}}, {{0.0, 1.0, 0.0}}}, {{0, 1, 2}, {0, 2, 3}}, 3};
  const auto data = walls_for_vtk(std::vector<WallSurface>{square, square});
  EXPECT_EQ(data.points.size(), 24U);
  EXPECT_EQ(data.triangles, (std::vector<std::int64_t>{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
  EXPECT_FALSE(data.vertices);
}

TEST_F(Exports3dTest, TheTextsOfSmallDumps) {
  WholeFile grains(path("grains.dump"));
  WholeFile contacts(path("contacts.dump"));
  add_grains_for_lammps(grains, pair_across_a_side(), deep_box());
  add_contacts_for_lammps(contacts, pair_across_a_side(), deep_box());
  grains.commit();
  contacts.commit();
  const std::string head = "ITEM: TIME\n0.5\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ";
  const std::string box = "ITEM: BOX BOUNDS ff pp ff\n-0.5 0.5\n0 10\n0 1\n";
  EXPECT_EQ(content("grains.dump"),
            head + "ATOMS\n2\n" + box +
                "ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius mass fixed base\n"
                "1 1 0 0.25 0.5 0 0 0 0 1 2 0.5 1 0 0\n2 1 0 9.25 0.5 0 0 0 0 1 2 0.5 1 0 0\n");
  // The tangential force is the length of the vector (3, 0, 4); the only bond between grains has the mean force.
  EXPECT_EQ(content("contacts.dump"),
            head + "ENTRIES\n1\n" + box +
                "ITEM: ENTRIES index batom1 batom2 force tangential overlap sliding Width\n1 1 2 3 5 0 0 0.15\n");
}

/// The area [L^2] of triangles, and the largest distance of a corner from the surface by `off`.
template <class Off>
std::pair<double, double> area_and_error(const WallSurface& surface, const Off& off) {
  double area = 0.0;
  double error = 0.0;
  for (const auto& corners : surface.triangles) {
    const auto& a = surface.points.at(corners[0]);
    area +=
        0.5 * magnitude(cross(Vec<3>(surface.points.at(corners[1]) - a), Vec<3>(surface.points.at(corners[2]) - a)));
    for (const auto corner : corners) error = std::max(error, std::fabs(off(surface.points[corner])));
  }
  return {area, error};
}

// An oblique axis, and a side that is perpendicular to it.
const Vec<3> oblique{{0.48, 0.6, 0.64}};
const Vec<3> beside{{0.8, 0.0, -0.6}};

RecordedWall<3> wall_of(WallShape<3>::Kind kind, double half_length) {
  RecordedWall<3> recorded;
  recorded.wall.point = {{1.0, -2.0, 3.0}};
  recorded.wall.normal = oblique;
  recorded.wall.half_length = half_length;
  recorded.wall.shape.kind = kind;
  recorded.wall.shape.side = beside;
  return recorded;
}

// A polygon of n corners on a circle has the area n/2 sin(2 pi/n) r^2; a band between two of them is n trapezia.
TEST(WallsInFilesTest, ShapesHaveTheirAreasAndPlaces) {
  using Kind = WallShape<3>::Kind;
  constexpr double rounding = 1e-13;  // of some ten products of numbers below 10
  const double n = 48.0;
  const auto surface = [](const RecordedWall<3>& wall) { return surfaces_of({wall}, {}).at(0); };
  const auto off_plane = [](const Vec<3>& p) { return dot(Vec<3>(p - Vec<3>{{1.0, -2.0, 3.0}}), oblique); };

  const auto disc = surface(wall_of(Kind::disc, 2.0));
  EXPECT_NEAR(area_and_error(disc, off_plane).first, 0.5 * n * std::sin(2.0 * std::numbers::pi / n) * 4.0, 1e-12);
  EXPECT_LT(area_and_error(disc, off_plane).second, rounding);

  auto rectangle = wall_of(Kind::rectangle, std::sqrt(5.0));
  rectangle.wall.shape.corners[0] = {{2.0, 1.0}};
  const auto flat = surface(rectangle);
  EXPECT_NEAR(area_and_error(flat, off_plane).first, 8.0, rounding);
  for (const auto& corner : flat.points) {
    EXPECT_NEAR(std::fabs(dot(Vec<3>(corner - rectangle.wall.point), beside)), 2.0, rounding);
  }

  auto triangle = wall_of(Kind::triangle, 2.0);
  triangle.wall.shape.corners = {{{{0.0, 0.0}}, {{2.0, 0.0}}, {{0.0, 1.5}}}};
  EXPECT_NEAR(area_and_error(surface(triangle), off_plane).first, 1.5, rounding);

  const auto distance = [&](const Vec<3>& p) {
    return magnitude(tangential(Vec<3>(p - Vec<3>{{1.0, -2.0, 3.0}}), oblique));
  };
  auto cylinder = wall_of(Kind::frustum, 3.0);
  cylinder.wall.shape.corners = {{{{1.5, -2.0}}, {{1.5, 2.0}}}};
  const auto [side, off_cylinder] =
      area_and_error(surface(cylinder), [&](const Vec<3>& p) { return distance(p) - 1.5; });
  EXPECT_NEAR(side, n * 2.0 * 1.5 * std::sin(std::numbers::pi / n) * 4.0, 1e-12);
  EXPECT_LT(off_cylinder, rounding);

  auto cone = wall_of(Kind::frustum, 3.0);
  cone.wall.shape.corners = {{{{0.0, 0.0}}, {{2.0, 1.0}}}};
  const auto [mantle, off_cone] =
      area_and_error(surface(cone), [&](const Vec<3>& p) { return distance(p) - 2.0 * off_plane(p); });
  const double half_chord = 2.0 * std::sin(std::numbers::pi / n);
  const double slant2 = 1.0 + squared(2.0 * std::cos(std::numbers::pi / n));
  EXPECT_NEAR(mantle, n * half_chord * std::sqrt(slant2), 1e-12) << "triangles from the tip to the chords of the rim";
  EXPECT_LT(off_cone, rounding);
  EXPECT_EQ(surface(cone).triangles.size(), 48U) << "those at the tip have no area";
}

TEST(WallsInFilesTest, APlaneReachesBeyondTheGrainsAndOpenWallsAreLeftOut) {
  auto plane = wall_of(WallShape<3>::Kind::disc, std::numeric_limits<double>::infinity());
  plane.wall.normal = {{0.0, 0.0, 1.0}};
  plane.wall.shape.side = {};
  plane.wall.point = {};
  auto open = plane;
  open.open = true;
  const auto moment = pair_across_a_side();
  const auto surfaces = surfaces_of({open, plane}, moment);
  ASSERT_EQ(surfaces.size(), 1U);
  EXPECT_EQ(surfaces[0].number, 1);
  double low = 0.0;
  double high = 0.0;
  for (const auto& point : surfaces[0].points) {
    EXPECT_EQ(point[2], 0.0);
    low = std::min(low, point[1]);
    high = std::max(high, point[1]);
  }
  EXPECT_EQ(low, -0.75) << "two radii before the first centre";
  EXPECT_EQ(high, 10.25);
}

/// Spheres of radius 0.5 at the points of a cubic lattice, `count` along each axis and a unit apart, which press on
/// each other with the forces `pressure` along the axes. The lowest layer stands on a floor.
Moment<3> cubic_lattice(int count, const Vec<3>& pressure) {
  Grains<3> grains;
  Contacts<3> contacts;
  const auto number = [&](int x, int y, int z) { return std::int64_t{x + count * (y + count * z)}; };
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x) {
        Grain<3> grain;
        grain.position = {{x + 0.5, y + 0.5, z + 0.5}};
        grain.radius = 0.5;
        grain.mass = grain.inverse_mass = 1.0;
        grains.add(grain, number(x, y, z));
        const std::array<std::int64_t, 3> next{number((x + 1) % count, y, z), number(x, (y + 1) % count, z),
                                               number(x, y, z + 1)};
        for (int a = 0; a < 3; ++a) {
          if (a == 2 && z + 1 == count) continue;
          Contact<3> contact{.first = number(x, y, z), .second = next[static_cast<std::size_t>(a)]};
          contact.normal[a] = -1.0;
          contact.normal_force = pressure[a];
          contact.first_lever = 0.5;
          contacts.list.push_back(contact);
        }
        if (z > 0) continue;
        Contact<3> contact{.first = number(x, y, z), .second = -1, .normal = {{0.0, 0.0, 1.0}}};
        contact.normal_force = pressure[2];
        contact.first_lever = 0.5;
        contacts.list.push_back(contact);
      }
    }
  }
  contacts.sort();
  return {0.0, 0, {grains, {}}, contacts};
}

// In a cubic lattice the cells are unit cubes, so the stress is the force per contact. The top layer has no contact
// above, and its cells are not closed: half a contact of force 2 in a sphere of volume pi/6.
TEST(SphereStressTest, ACubicLatticeHasTheForcesOfItsContactsAsStress) {
  auto moment = cubic_lattice(4, {{2.0, 3.0, 5.0}});
  Box<3> box;
  box.periodic = box.periodic_y = true;
  box.x_min = box.y_min = 0.0;
  box.x_max = box.y_max = 4.0;
  RecordedWall<3> floor;
  floor.wall.normal = {{0.0, 0.0, 1.0}};
  add_stress(moment, {floor}, box);
  ASSERT_EQ(moment.stress.size(), 64U);
  for (std::size_t k = 0; k < 64; ++k) {
    const bool top = k >= 48;
    const double volume = top ? std::numbers::pi / 6.0 : 1.0;
    EXPECT_NEAR(moment.extent[k], volume, 1e-9) << k;  // the tolerance of voro++
    const Numbers expected{2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, top ? 2.5 : 5.0};
    for (std::size_t c = 0; c < 9; ++c) EXPECT_NEAR(moment.stress[k][c] * volume, expected[c], 1e-8) << k << " " << c;
  }
}

// The first index is that of the force, the second that of the branch.
TEST(SphereStressTest, TheSumIsThatOverContacts) {
  auto moment = pair_across_a_side();
  add_stress(moment, {}, deep_box());
  std::array<double, 9> sum{};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t c = 0; c < 9; ++c) sum[c] += moment.extent[k] * moment.stress[k][c];
  }
  // On the wall: force (0, 0, 2), branch (0, 0, 0.5); between the spheres: force (3, 3, 4), branch (0, 1, 0).
  const std::array<double, 9> expected{0.0, 3.0, 0.0, 0.0, 3.0, 0.0, 0.0, 4.0, 1.0};
  for (std::size_t c = 0; c < 9; ++c) EXPECT_NEAR(sum[c], expected[c], 1e-14) << c;
}

}  // namespace
}  // namespace repose
