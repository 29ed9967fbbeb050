// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pipe.hpp"

#include "repose/record/find_pipe.hpp"
#include "repose/results/column.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"
#include "repose/theory/janssen.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

constexpr double shear = 0.15;  // upwards on every disc, from each wall

/// Discs of diameter 1 one upon the other from the floor at y = 2, each held by both walls of a pipe of width 1. Wall 0
/// is the floor, 1 the left wall, 2 the right one.
struct Stack {
  Pipe pipe{.left_wall = 1, .right_wall = 2, .left = -0.5, .right = 0.5, .floor = 2.0};
  Grains<2> grains;
  Contacts<2> contacts;

  explicit Stack(int count) {
    for (int k = 0; k < count; ++k) grains.add(unit_disc(0.0, 2.5 + k), k);
    const auto touch = [&](std::int64_t disc, std::int64_t wall, const Vec<2>& normal, double force, double tangent) {
      Contact<2> contact;
      contact.first = disc;
      contact.second = wall_partner(wall);
      contact.normal = normal;
      contact.normal_force = force;
      contact.tangential_force = tangent;
      contacts.list.push_back(contact);
    };
    for (int k = 0; k < count; ++k) {
      const double force = 0.5 + 0.1 * k;
      touch(k, 1, {{1.0, 0.0}}, force, shear);    // the tangent of a normal to the right points up
      touch(k, 2, {{-1.0, 0.0}}, force, -shear);  // that of one to the left points down
    }
    touch(0, 0, {{0.0, 1.0}}, count * (1.0 - 2.0 * shear), 0.0);
    for (int k = 1; k < count; ++k) {
      // Once with the upper disc first, once with the lower one.
      const auto lower = static_cast<std::size_t>(k - 1);
      const auto upper = static_cast<std::size_t>(k);
      const double load = (count - k) * (1.0 - 2.0 * shear);
      contacts.list.push_back(k % 2 == 0 ? contact_between(grains, lower, upper, load)
                                         : contact_between(grains, upper, lower, load));
    }
  }
};

// As many slices as discs: each ends at the top of its disc, by the exact area of discs below a level.
TEST(MeasuredColumn, StackOfDiscs) {
  constexpr int count = 12;
  const Stack stack(count);
  const auto column = measure_column(stack.pipe, stack.grains, stack.contacts, count);
  EXPECT_NEAR(column.row.height, count, 1e-12);
  EXPECT_NEAR(column.row.centre, 0.5 * count, 1e-12);
  EXPECT_NEAR(column.row.solid_fraction, std::numbers::pi / 4.0, 1e-9);
  for (int k = 0; k < count; ++k) {
    const auto& slice = column.slices[static_cast<std::size_t>(k)];
    EXPECT_NEAR(slice.top, k + 1.0, 1e-9) << k;
    EXPECT_NEAR(slice.mass, 1.0, 1e-12);
    EXPECT_NEAR(slice.pressure, 0.5 + 0.1 * k, 1e-9) << k;  // the mean of two walls over a length of 1
    EXPECT_NEAR(slice.shear, shear, 1e-9);
    EXPECT_NEAR(slice.load, (count - k) * (1.0 - 2.0 * shear), 1e-12) << k;
  }
}

// Fewer slices of equal area; loads still are those of the levels, and the balance closes in every slice.
TEST(MeasuredColumn, SlicesBalance) {
  const Stack stack(12);
  const auto slices = measure_column(stack.pipe, stack.grains, stack.contacts, 5).slices;
  double mass = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double low = k > 0 ? slices[k - 1].top : 0.0;
    const double above = k < 4 ? slices[k + 1].load : 0.0;
    EXPECT_NEAR(slices[k].load, above + slices[k].mass - 2.0 * slices[k].shear * (slices[k].top - low), 1e-12);
    mass += slices[k].mass;
  }
  EXPECT_NEAR(mass, 12.0, 1e-12);
}

// Grains that fall from above, lie outside the walls or have fallen below the floor do not count; what such a grain
// bears from the column above is a load of the floor. One inside the column that touches nothing counts.
TEST(MeasuredColumn, CountsTheGrainsOfTheColumnAlone) {
  Stack stack(4);
  stack.grains.add(unit_disc(0.0, 20.0), 100);
  stack.grains.add(unit_disc(3.0, 2.5), 101);
  stack.grains.add(unit_disc(0.0, 1.5), 102);
  stack.contacts.list.push_back(contact_between(stack.grains, 0, 6, 0.25));
  const auto column = measure_column(stack.pipe, stack.grains, stack.contacts, 4);
  EXPECT_NEAR(column.row.height, 4.0, 1e-12);
  EXPECT_NEAR(column.row.centre, 2.0, 1e-12);
  EXPECT_NEAR(column.slices[0].load, 4.0 * (1.0 - 2.0 * shear) + 0.25, 1e-12);
  std::erase_if(stack.contacts.list, [](const auto& c) { return c.second == 2 || c.first == 2; });
  const auto hanging = measure_column(stack.pipe, stack.grains, stack.contacts, 4);
  EXPECT_NEAR(hanging.row.centre, 2.0, 1e-12);
  EXPECT_NEAR(hanging.row.solid_fraction, column.row.solid_fraction, 1e-12);
  const auto none = measure_column(stack.pipe, {}, {}, 4);
  EXPECT_EQ(none.row.height, 0.0);
  EXPECT_TRUE(std::isnan(none.row.solid_fraction));
}

std::optional<PipeWalls> pipe_of(const std::string& walls, const std::string& grain = "[0, 3]") {
  return find_pipe(scene_from_text("[[grain]]\nposition = " + grain + "\n[stop]\ntime = 1\n" + walls, "scene"));
}

TEST(FindPipe, TwoUprightWallsAndAFloor) {
  const std::string left = "[[plane]]\nname = \"l\"\npoint = [-3, 0]\nnormal = [1, 0]\n";
  const std::string right = "[[plane]]\nname = \"r\"\npoint = [5, 0]\nnormal = [-1, 0]\n";
  const std::string lid = "[[plane]]\nname = \"lid\"\npoint = [0, 90]\nnormal = [0, -1]\n";
  const std::string floor = "[[plane]]\nname = \"f\"\npoint = [0, 1]\nnormal = [0, 1]\n";
  const std::string pieces =
      "[[wall]]\nname = \"f\"\nfrom = [-3, 1]\nto = [5, 1]\n[[wall]]\nname = \"l\"\nfrom = [-3, 1]\nto = [-3, 40]\n"
      "[[wall]]\nname = \"r\"\nfrom = [5, 1]\nto = [5, 40]\n";
  const auto found = pipe_of(right + lid + floor + left);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->right, 0U);
  EXPECT_EQ(found->left, 3U);
  EXPECT_EQ(found->floor, 2U);
  const auto scene =
      scene_from_text("[[grain]]\nposition = [0, 3]\n[stop]\ntime = 1\n" + right + lid + floor + left, "scene");
  const auto pipe = found->at(recorded_walls(scene, {}, 0.0));
  EXPECT_EQ(pipe.width(), 8.0);
  EXPECT_EQ(pipe.floor, 1.0);
  EXPECT_TRUE(pipe_of(pieces));
  EXPECT_FALSE(pipe_of(left + floor));
  EXPECT_FALSE(pipe_of(left + floor + "[[plane]]\nname = \"r\"\npoint = [-60, 0]\nnormal = [1, 0]\n"));  // faces away
  EXPECT_FALSE(pipe_of(left + right + floor + "[[plane]]\nname = \"s\"\npoint = [0, -5]\nnormal = [1, 1]\n"));
  EXPECT_FALSE(pipe_of(left + right + "[base]\nkind = \"none\"\n"));
  EXPECT_TRUE(pipe_of(left + right + "[base]\nkind = \"row\"\nhalf_width = 9\n"));
}

/// A record of one row whose slices have the stresses of Janssen's law.
Record<2> janssen_record(const std::string& direction, double ratio, double friction) {
  Record<2> record;
  record.scene = scene_from_text(
      "[[grain]]\nposition = [0, 3]\n[stop]\ntime = 1\n[output]\nslices = 40\n[[plane]]\nname = \"l\"\npoint = [-3, "
      "0]\nnormal = [1, 0]\n"
      "[[plane]]\nname = \"r\"\npoint = [5, 0]\nnormal = [-1, 0]\n[[plane]]\nname = \"f\"\npoint = [0, 0]\n"
      "normal = [0, 1]\n",
      "scene");
  record.walls = recorded_walls(record.scene, {}, 0.0);
  theory::Janssen law{
      .dimension = 2, .width = 8.0, .stress_ratio = ratio, .friction = friction, .direction = direction};
  law.solid_fraction = 0.8;
  const double sense = direction == "rest" ? 1.0 : -1.0;
  const double height = 30.0;
  record.series.push_back({.time = 1.0, .grains = 1});
  record.column_series.push_back({.height = height, .centre = 15.0, .solid_fraction = 0.8});
  double carried = 0.0;
  double pressed = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double low = height * k / 40.0;
    const double high = height * (k + 1) / 40.0;
    ColumnSlice slice{.top = high, .mass = 0.8 * 8.0 * (high - low)};
    slice.load = 8.0 * theory::vertical_stress(law, height - low);
    const double above = 8.0 * theory::vertical_stress(law, height - high);
    slice.pressure = ratio * 0.5 * (slice.load + above) / 8.0;
    slice.shear = (above + slice.mass - slice.load) / (2.0 * (high - low));
    carried += slice.shear * 2.0 * (high - low);
    pressed += sense * slice.shear / friction * (high - low);
    record.column_slices.push_back(slice);
  }
  const double floor = record.column_slices.front().load;
  record.wall_series = {{.force = {{-pressed, -0.5 * carried}}, .length = height},
                        {.force = {{pressed, -0.5 * carried}}, .length = height},
                        {.force = {{0.0, -floor}}, .length = 8.0}};
  return record;
}

// K, mobilised friction and both fitted lengths of a column that obeys Janssen's law, at rest and pushed up. K is from
// the mean of two levels, which is off by (slice/length)^2/12.
TEST(ColumnState, FindsTheLawOfJanssen) {
  for (const std::string direction : {"rest", "pushed-up"}) {
    const double sense = direction == "rest" ? 1.0 : -1.0;
    const auto column = measure_column_of(janssen_record(direction, 0.6, 0.4));
    ASSERT_TRUE(column);
    const double length = 8.0 / (2.0 * 0.6 * 0.4);
    EXPECT_NEAR(column->width, 8.0, 1e-12);
    EXPECT_NEAR(column->mass, 0.8 * 8.0 * 30.0, 1e-9);
    ASSERT_TRUE(column->stress_ratio);
    EXPECT_NEAR(column->stress_ratio->mean, 0.6, 1e-9);
    EXPECT_NEAR(column->friction, sense * 0.4, 1e-9);
    EXPECT_NEAR(column->screening_length, sense * length, 1e-6);
    EXPECT_NEAR(column->balance, 0.0, 1e-12);
    EXPECT_NEAR(column->load_ratio, column->janssen_ratio, 1e-6);
    EXPECT_NEAR(column->fit.lambda, length, 1e-6) << direction;
    EXPECT_NEAR(column->fit.lambda_1, length, 1e-4) << direction;
    EXPECT_NEAR(column->fit.lambda_2, length, 1e-4) << direction;
    EXPECT_NEAR(column->layers[20].solid_fraction, 0.8, 1e-9);
    EXPECT_NEAR(column->layers[0].depth, 30.0 - 0.375, 1e-12);
  }
}

// A floor that rises: a slice follows once it has moved half as far. The upper half of the column sets out later.
TEST(ColumnState, FollowsAFloorThatMoves) {
  Record<2> record;
  record.scene = scene_from_text(
      "[[grain]]\nposition = [0, 3]\n[stop]\ntime = 9\n[output]\nwindow = 1\nslices = 4\n[[plane]]\nname = "
      "\"l\"\npoint = [-1, "
      "0]\nnormal = [1, 0]\n"
      "[[plane]]\nname = \"r\"\npoint = [1, 0]\nnormal = [-1, 0]\n[[plane]]\nname = \"f\"\npoint = [0, 0]\n"
      "normal = [0, 1]\nmotion = \"velocity\"\nvelocity = [0, 0.5]\nstart = 1\n",
      "scene");
  const auto add = [&](double time, double floor, const std::vector<double>& tops) {
    record.series.push_back({.time = time});
    record.column_series.push_back({.height = tops.back(), .centre = 0.5 * tops.back(), .solid_fraction = 0.8});
    for (const double top : tops) record.column_slices.push_back({.top = top, .mass = 1.0});
    record.wall_series.insert(record.wall_series.end(), {{}, {}, {.displacement = floor}});
  };
  add(1.0, 0.0, {1.0, 2.0, 3.0, 4.0});
  add(2.0, 0.5, {0.9, 1.8, 2.5, 3.5});  // the upper two stand still
  add(3.0, 1.0, {0.9, 1.8, 2.5, 3.5});  // all have risen by more than 0.5
  record.walls = recorded_walls(record.scene, {}, 0.0);
  const auto column = measure_column_of(record);
  ASSERT_TRUE(column);
  ASSERT_EQ(column->motion.size(), 2U);
  EXPECT_NEAR(column->motion[0].shortening, 0.5, 1e-12);
  EXPECT_NEAR(column->motion[0].top, 0.0, 1e-12);
  EXPECT_NEAR(column->motion[0].front, 2.0, 1e-12);
  EXPECT_NEAR(column->motion[1].front, 4.0, 1e-12);
  EXPECT_NEAR(column->motion[1].top, 0.5, 1e-12);
  EXPECT_NEAR(column->top_follows, 1.0, 1e-12);
  EXPECT_NEAR(column->shortening, 0.5, 1e-12);
  EXPECT_NEAR(column->later_shortening, 0.0, 1e-12);
}

}  // namespace
}  // namespace repose
