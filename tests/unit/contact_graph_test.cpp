// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_graph.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace repose {
namespace {

void expect_as_all_pairs(const Discs& discs, const Box<2>& box, double gap) {
  const auto graph = contact_graph(discs, box, gap);
  ASSERT_EQ(graph.start.size(), discs.size() + 1);
  std::size_t found = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < discs.size(); ++j) {
      if (j != i && touch(discs, box, gap, i, j)) expected.push_back(j);
    }
    const auto neighbours = graph.of(i);
    EXPECT_EQ(std::vector<std::uint32_t>(neighbours.begin(), neighbours.end()), expected) << "disc " << i;
    found += expected.size();
  }
  EXPECT_EQ(graph.contacts(), found / 2);
}

TEST(ContactGraph, equals_all_pairs_bit_for_bit) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Draw draw(seed);
    // Boxes down to two cells or one, with size ratios up to 1 to 5.
    const double width = seed % 3 == 0 ? 2.1 : 3.0 + 20.0 * draw();
    const auto box = sides(width, seed % 2 == 0);
    Discs discs;
    for (int k = 0; k < 300; ++k) discs.add({{width * draw(), 30.0 * draw()}}, 0.1 + 0.4 * draw());
    for (const double gap : {0.0, 1e-9, 0.05}) expect_as_all_pairs(discs, box, gap);
  }
}

TEST(ContactGraph, equals_all_pairs_where_rounding_decides) {
  // All gaps of a lattice are zero except for rounding: without a tolerance some count and some do not.
  const auto discs = triangular_packing(12, 20);
  for (const double gap : {0.0, 1e-16, 1e-15, 1e-9}) expect_as_all_pairs(discs, sides(12.0), gap);
  expect_as_all_pairs(sticking_packing(10, 400, 3), sides(10.0), 1e-9);
}

TEST(ContactGraph, nothing_and_one_disc_have_no_contact) {
  EXPECT_EQ(contact_graph({}, sides(5.0), 0.0).contacts(), 0u);
  Discs one;
  one.add({{1.0, 1.0}}, 0.5);
  EXPECT_EQ(contact_graph(one, sides(5.0), 0.0).contacts(), 0u);
}

TEST(ContactGraph, the_gap_is_in_mean_diameters_of_the_pair) {
  Discs discs;
  discs.add({{0.0, 0.0}}, 1.0);
  discs.add({{4.0, 1e-9}}, 3.0);
  discs.add({{10.0, 20.0}}, 3.0);
  discs.add({{14.0 + 4e-4, 20.0}}, 1.0);
  const auto box = sides(100.0, false);
  EXPECT_EQ(contact_graph(discs, box, 0.9e-4).contacts(), 1u);
  EXPECT_EQ(contact_graph(discs, box, 1.1e-4).contacts(), 2u);
}

TEST(ContactGraph, walls_count_as_neighbours) {
  Discs discs;
  discs.add({{0.5, 0.5}}, 0.5);
  discs.add({{2.0, 0.5 + 1e-6}}, 0.5);
  discs.add({{9.5, 3.0}}, 0.5);
  const PackingWalls walls{0.0, 0.0, 10.0};
  EXPECT_EQ(wall_contacts(discs, walls, 1e-9), (std::vector<std::uint8_t>{2, 0, 1}));
  EXPECT_EQ(wall_contacts(discs, walls, 1e-5), (std::vector<std::uint8_t>{2, 1, 1}));
  EXPECT_EQ(wall_contacts(discs, {}, 1e-5), (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(ContactGraph, rattlers_are_removed_one_after_another) {
  // On three base discs: a disc in a pocket stays; a chain on top of it is removed from its end; a floating disc too.
  Discs discs;
  for (int k = 0; k < 3; ++k) discs.add({{k + 1.0, 0.0}}, 0.5, true);
  const double rise = std::sqrt(0.75);
  discs.add({{1.5, rise}}, 0.5);
  discs.add({{1.5, rise + 1.0}}, 0.5);
  discs.add({{1.5, rise + 2.0}}, 0.5);
  discs.add({{6.0, 5.0}}, 0.5);
  const auto graph = contact_graph(discs, sides(10.0, false), 1e-9);
  const std::vector<std::uint8_t> no_walls(discs.size(), 0);
  EXPECT_EQ(rattlers(discs, graph, no_walls), (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(rattlers(discs, graph, no_walls, 1), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1}));
  // A wall beside the end of the chain holds the whole chain.
  std::vector<std::uint8_t> wall(discs.size(), 0);
  wall[5] = 1;
  EXPECT_EQ(rattlers(discs, graph, wall), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1}));
}

TEST(ContactGraph, a_forest_without_rattlers_is_only_the_base) {
  const auto discs = sticking_packing(16, 500, 5);
  const auto graph = contact_graph(discs, sides(16.0), 1e-9);
  EXPECT_EQ(graph.contacts(),
            16u + 500u);  // the base touches itself across the sides of the box; each disc touches one below
  EXPECT_EQ(rattlers(discs, graph, std::vector<std::uint8_t>(discs.size(), 0)), [&] {
    std::vector<std::uint8_t> expected(discs.size(), 1);
    std::fill_n(expected.begin(), 16, std::uint8_t{0});
    return expected;
  }());
}

}  // namespace
}  // namespace repose
