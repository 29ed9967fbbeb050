// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_cells.hpp"

#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace repose {
namespace {

BaseLoad load_at(double x, double y, const Vec<3>& force = {{0.0, 0.0, -1.0}}) { return {{{x, y}}, force}; }

std::vector<BaseLoad> random_loads(std::size_t count) {
  std::vector<BaseLoad> loads;
  for (std::size_t k = 0; k < count; ++k) {
    const auto random = [&](std::uint32_t draw) { return 2.0 * uniform(3, Purpose::lattice_place, k, draw) - 1.0; };
    loads.push_back(load_at(7.0 * random(0), 4.0 * random(1), {{random(2), random(3), -1.0 - random(4)}}));
  }
  return loads;
}

// Each cell has the sum of the loads within half a side of its middle, and all cells together have the whole force.
TEST(BaseCells, SumsOfForces) {
  const auto loads = random_loads(2000);
  const auto base = measure_base_cells(loads, 1.3, {});
  EXPECT_EQ(base.side, (std::array{1.3, 1.3}));
  Vec<3> all{};
  for (const auto& load : loads) all += load.force;
  Vec<3> of_cells{};
  std::int64_t count = 0;
  for (const auto& cell : base.cells) {
    Vec<3> force{};
    std::int64_t within = 0;
    for (const auto& load : loads) {
      if (std::fabs(load.place[0] - cell.x) > 0.65 || std::fabs(load.place[1] - cell.y) > 0.65) continue;
      force += load.force;
      ++within;
    }
    EXPECT_EQ(cell.count, within);
    EXPECT_NEAR(cell.pressure * 1.69, -force[2], 1e-12);
    EXPECT_NEAR(cell.shear_x * 1.69, force[0], 1e-12);
    EXPECT_NEAR(cell.shear_y * 1.69, force[1], 1e-12);
    of_cells += Vec<3>{{cell.shear_x, cell.shear_y, -cell.pressure}} * base.area();
    count += cell.count;
  }
  EXPECT_EQ(count, 2000);
  EXPECT_LT(magnitude(of_cells - all), 1e-10);
  EXPECT_NEAR(base.load, -all[2], 1e-10);
  EXPECT_NEAR(base.traction[0], all[0], 1e-10);
  EXPECT_NEAR(base.traction[1], all[1], 1e-10);
  // By ascending x, then y.
  for (std::size_t k = 1; k < base.cells.size(); ++k) {
    const auto& a = base.cells[k - 1];
    const auto& b = base.cells[k];
    EXPECT_TRUE(a.x < b.x || (a.x == b.x && a.y < b.y));
  }
}

// Sides are halves and wholes, so that places on edges are exact.
TEST(BaseCells, APointLoadLandsInItsCell) {
  const auto cell_of = [](double x, double y) {
    const auto base = measure_base_cells({load_at(x, y, {{0.5, -0.25, -8.0}})}, 2.0, {});
    EXPECT_EQ(base.cells.size(), 1U);
    EXPECT_EQ(base.cells[0].count, 1);
    EXPECT_EQ(base.cells[0].pressure, 2.0);
    EXPECT_EQ(base.cells[0].shear_x, 0.125);
    EXPECT_EQ(base.cells[0].shear_y, -0.0625);
    return Vec<2>{{base.cells[0].x, base.cells[0].y}};
  };
  EXPECT_EQ(cell_of(0.0, 0.0), (Vec<2>{{0.0, 0.0}}));
  EXPECT_EQ(cell_of(0.9, -0.9), (Vec<2>{{0.0, 0.0}}));
  EXPECT_EQ(cell_of(3.1, -7.5), (Vec<2>{{4.0, -8.0}}));
  // On an edge: the cell of larger x or y.
  EXPECT_EQ(cell_of(1.0, -1.0), (Vec<2>{{2.0, 0.0}}));
  EXPECT_EQ(cell_of(-3.0, 3.0), (Vec<2>{{-2.0, 4.0}}));
  EXPECT_EQ(cell_of(1.0 - 1e-12, -1.0 + 1e-12), (Vec<2>{{0.0, 0.0}}));
}

// A box of 10 along x has three cells of 10/3 for a width of 3; one of 0.4 along y has a single cell.
TEST(BaseCells, CellsDivideAPeriodicBox) {
  Box<3> box;
  box.periodic = true;
  box.x_min = -5.0;
  box.x_max = 5.0;
  const auto base =
      measure_base_cells({load_at(-5.0, 0.0), load_at(4.99, 0.0), load_at(0.0, 0.0), load_at(5.0, 0.0)}, 3.0, box);
  EXPECT_EQ(base.side, (std::array{10.0 / 3.0, 3.0}));
  ASSERT_EQ(base.cells.size(), 3U);
  EXPECT_NEAR(base.cells[0].x, -10.0 / 3.0, 1e-14);
  EXPECT_EQ(base.cells[0].count, 2);  // x = 5 is x = -5
  EXPECT_NEAR(base.cells[1].x, 0.0, 1e-14);
  EXPECT_NEAR(base.cells[2].x, 10.0 / 3.0, 1e-14);
  EXPECT_NEAR(base.cells[0].pressure, 0.2, 1e-14);
  box.periodic_y = true;
  box.y_min = 1.0;
  box.y_max = 1.4;
  const auto narrow = measure_base_cells(random_loads(50), 3.0, box);
  EXPECT_EQ(narrow.cells.size(), 3U);
  for (const auto& cell : narrow.cells) EXPECT_NEAR(cell.y, 1.2, 1e-14);
}

// One sphere that has rolled far away costs one cell; one that is lost to infinity has none.
TEST(BaseCells, FarPlaces) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto base = measure_base_cells({load_at(0.0, 0.0), load_at(1e300, -1e300), load_at(infinity, 0.0)}, 1.0, {});
  ASSERT_EQ(base.cells.size(), 2U);
  EXPECT_EQ(base.load, 2.0);
  EXPECT_TRUE(measure_base_cells({}, 1.0, {}).cells.empty());
}

}  // namespace
}  // namespace repose
