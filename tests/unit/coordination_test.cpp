// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/coordination.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

namespace repose {
namespace {

Coordination read(const Discs& discs, const Slab& slab, std::size_t blocks = 4) {
  const auto graph = contact_graph(discs, slab.box, 1e-9);
  const std::vector<std::uint8_t> on_walls(discs.size(), 0);
  return measure_coordination(discs, graph, on_walls, rattlers(discs, graph, on_walls), slab, blocks);
}

TEST(Coordination, of_lattices_is_exact) {
  const auto triangular = read(triangular_packing(12, 30), slab_between(4.0, 20.0, sides(12.0)));
  EXPECT_EQ(triangular.mean.mean, 6.0);
  EXPECT_EQ(triangular.mean.error, 0.0);
  EXPECT_EQ(triangular.connectivity[6], 1.0);
  EXPECT_EQ(triangular.without_rattlers.mean, 6.0);
  EXPECT_EQ(triangular.rattlers, 0.0);
  const auto square = read(square_packing(12, 30), slab_between(4.5, 20.5, sides(12.0)));
  EXPECT_EQ(square.discs, 12u * 16u);
  EXPECT_EQ(square.mean.mean, 4.0);
  EXPECT_EQ(square.connectivity[4], 1.0);
}

TEST(Coordination, neighbours_outside_the_slab_and_of_the_base_count) {
  // The slab holds only the row above the base: its discs have two neighbours below, two beside, two above.
  const auto coordination = read(triangular_packing(8, 3), slab_between(0.5, 1.0, sides(8.0)));
  EXPECT_EQ(coordination.discs, 8u);
  EXPECT_EQ(coordination.mean.mean, 6.0);
  // The base itself is not counted, even if it lies in the slab.
  EXPECT_EQ(read(triangular_packing(8, 3), slab_between(-0.5, 1.0, sides(8.0))).discs, 8u);
}

TEST(Coordination, without_rattlers_leaves_their_contacts_out) {
  // Two rows of a lattice with a chain of two on one disc of the upper row, which has 2 + 2 + 1 contacts.
  auto discs = triangular_packing(8, 2);
  const Vec<2> foot = discs.position.back();
  discs.add(foot + Vec<2>{{0.0, 1.0}}, 0.5);
  discs.add(foot + Vec<2>{{0.0, 2.0}}, 0.5);
  const auto coordination = read(discs, slab_between(0.5, 5.0, sides(8.0)));
  EXPECT_EQ(coordination.discs, 10u);
  EXPECT_NEAR(coordination.mean.mean, (7 * 4 + 5 + 2 + 1) / 10.0, 1e-15);
  EXPECT_NEAR(coordination.rattlers, 0.2, 1e-15);
  EXPECT_NEAR(coordination.without_rattlers.mean, 4.0, 1e-15);
  EXPECT_NEAR(coordination.connectivity[1], 0.1, 1e-15);
  EXPECT_NEAR(coordination.connectivity[2], 0.1, 1e-15);
  EXPECT_NEAR(coordination.connectivity[4], 0.7, 1e-15);
  EXPECT_NEAR(coordination.connectivity[5], 0.1, 1e-15);
}

TEST(Coordination, of_a_forest_is_two_and_all_discs_are_rattlers) {
  const auto discs = sticking_packing(32, 1000, 1);
  const auto coordination = read(discs, slab_between(10.0, 50.0, sides(32.0)), 8);
  double sum = 0.0;
  double mean = 0.0;
  for (std::size_t q = 0; q < 7; ++q) {
    sum += coordination.connectivity[q];
    mean += static_cast<double>(q) * coordination.connectivity[q];
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_NEAR(mean, coordination.mean.mean, 1e-14);
  // Each disc has one support and supports one disc on average. Contacts cut by the edges make the difference: at most
  // a dozen of 500 discs.
  EXPECT_NEAR(coordination.mean.mean, 2.0, 0.03);
  EXPECT_EQ(coordination.rattlers, 1.0);
  EXPECT_TRUE(std::isnan(coordination.without_rattlers.mean));
}

}  // namespace
}  // namespace repose
