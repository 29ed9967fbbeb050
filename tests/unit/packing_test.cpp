// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/packing.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace repose {
namespace {

using std::numbers::pi;

Packing read(const Discs& discs, const Box<2>& box, const PackingOptions& options = {}) {
  const auto result = analyse_packing(discs, box, options);
  EXPECT_EQ(result.problem, "");
  return result.packing.value_or(Packing{});
}

PackingOptions everything() {
  PackingOptions options;
  options.correlations = options.structure = options.local_density = true;
  return options;
}

TEST(PackingSlab, lies_about_the_mean_height_above_the_base_centres) {
  Discs discs;
  discs.add({{1.0, 2.0}}, 0.5, true);
  discs.add({{3.0, 4.0}}, 0.5, true);
  for (const double y : {5.0, 7.0, 9.0, 11.0}) discs.add({{2.0, y}}, 0.5);
  const auto slab = find_slab(discs, sides(10.0)).slab;
  ASSERT_TRUE(slab);
  EXPECT_EQ(slab->base_height, 3.0);
  EXPECT_EQ(slab->mean_height, 5.0);
  EXPECT_EQ(slab->low, 3.0 + 0.4 * 5.0);
  EXPECT_EQ(slab->high, 3.0 + 1.4 * 5.0);
  EXPECT_EQ(centres_in(discs, *slab), (std::vector<std::uint32_t>{2, 3, 4}));
  // The lower edge belongs to the slab, the upper one does not.
  EXPECT_TRUE(slab->holds({{2.0, slab->low}}));
  EXPECT_FALSE(slab->holds({{2.0, slab->high}}));

  const auto other = find_slab(discs, sides(10.0), {0.0, 1.0, 1.0}).slab;
  ASSERT_TRUE(other);
  EXPECT_EQ(other->low, 1.0);
  EXPECT_EQ(other->high, 8.0);
}

TEST(PackingSlab, reports_why_there_is_none) {
  const auto box = sides(10.0);
  const auto problem = [&](const Discs& discs, const Box<2>& in, const PackingOptions& options = {}) {
    const auto result = analyse_packing(discs, in, options);
    EXPECT_FALSE(result.packing);
    return result.problem;
  };
  Discs base;
  base.add({{1.0, 0.0}}, 0.5, true);
  EXPECT_EQ(problem({}, box), "nothing was deposited");
  EXPECT_EQ(problem(base, box), "nothing was deposited");
  Discs afloat;
  afloat.add({{1.0, 5.0}}, 0.5);
  EXPECT_EQ(problem(afloat, box), "there are no base grains to count heights from");
  PackingOptions on_floor;
  on_floor.slab.base_height = 0.5;
  EXPECT_TRUE(analyse_packing(afloat, box, on_floor).packing);
  on_floor.slab.base_height = 5.0;
  EXPECT_EQ(problem(afloat, box, on_floor), "the deposited discs lie no higher than the base");

  Discs ends = base;  // all deposited discs lie outside the slab
  ends.add({{1.0, 0.1}}, 0.5);
  ends.add({{1.0, 9.9}}, 0.5);
  EXPECT_EQ(problem(ends, box), "no deposited centre lies in the slab, 2 <= y < 7");
  PackingOptions empty;
  empty.slab.low = empty.slab.high = 1.0;
  EXPECT_EQ(problem(ends, box, empty), "the slab from 1 to 1 mean heights is empty");
  EXPECT_EQ(problem(ends, Box<2>{}), "the packing is unbounded in x: it needs a periodic box or side walls");
  ends.add({{1.0, std::numeric_limits<double>::quiet_NaN()}}, 0.5);
  EXPECT_EQ(problem(ends, box), "disc 3 has no finite position or no positive radius");
  PackingOptions wrong;
  wrong.gap = -1.0;
  EXPECT_EQ(problem(ends, box, wrong), "gap must be >= 0; column, bin_width and strip must be > 0");
  wrong = {};
  wrong.density_bins = 0;
  EXPECT_EQ(problem(ends, box, wrong), "blocks, directions and density_bins must be at least 1");
}

TEST(Packing, of_grains_is_ordered_by_id_and_wrapped) {
  Grains<2> grains;
  Grain<2> grain;
  grain.radius = 0.25;
  grain.position = {{12.0, 1.0}};
  grains.add(grain, 7);
  grain.position = {{3.0, 2.0}};
  grains.add(grain, 2, true);
  const auto discs = discs_of({grains, sides(10.0)});
  EXPECT_EQ(discs.position[0], (Vec<2>{{3.0, 2.0}}));
  EXPECT_EQ(discs.position[1], (Vec<2>{{2.0, 1.0}}));
  EXPECT_EQ(discs.base, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(deposited_count(discs), 1u);
  EXPECT_EQ(mean_diameter(discs), 0.5);
}

TEST(Packing, of_the_triangular_lattice_is_exact_in_every_measure) {
  // Rows 1 to 41: ybar = 21 rows. The slab from 8.4 to 29.4 rows holds 21 whole rows.
  const auto packing = read(triangular_packing(32, 42), sides(32.0), everything());
  EXPECT_NEAR(packing.solid_fraction.mean, pi / (2.0 * std::sqrt(3.0)), 1e-12);
  EXPECT_EQ(packing.coordination.discs, 32u * 21u);
  EXPECT_EQ(packing.coordination.mean.mean, 6.0);
  EXPECT_EQ(packing.coordination.connectivity[6], 1.0);
  EXPECT_NEAR(packing.fabric->all.anisotropy.mean, 0.0, 1e-12);
  EXPECT_NEAR(packing.fabric->folded.direction_deg.mean, 45.0, 1e-9);
  EXPECT_EQ(packing.regime, PackingRegime::dense_ordered);
  EXPECT_EQ(packing.regime_by_structure, PackingRegime::dense_ordered);
  // Two columns with tops of equal height: the surface is flat. All Voronoi cells are the same hexagon.
  EXPECT_NEAR(packing.surface->roughness, 0.0, 1e-12);
  EXPECT_EQ(packing.local_density->cells, 32u * 21u);
  EXPECT_EQ(packing.local_density->open, 0u);
  EXPECT_NEAR(packing.local_density->density.mean, pi / (2.0 * std::sqrt(3.0)), 1e-9);  // tolerance of voro++
  EXPECT_NEAR(packing.local_density->density.deviation, 0.0, 1e-9);
  EXPECT_NEAR(packing.local_density->solid_fraction, pi / (2.0 * std::sqrt(3.0)), 1e-9);
  EXPECT_EQ(packing.local_density->count[90], 32u * 21u);
  EXPECT_TRUE(packing.pair_correlation && packing.structure_factor);
}

TEST(Packing, of_the_square_lattice_is_exact) {
  const auto packing = read(square_packing(24, 42), sides(24.0));
  EXPECT_NEAR(packing.solid_fraction.mean, pi / 4.0, 1e-12);
  EXPECT_EQ(packing.coordination.mean.mean, 4.0);
  EXPECT_EQ(packing.coordination.connectivity[4], 1.0);
  EXPECT_NEAR(packing.fabric->all.anisotropy.mean, 0.0, 1e-12);
  EXPECT_NEAR(packing.fabric->harmonics[1].cosine, 2.0, 1e-12);
  EXPECT_EQ(packing.regime, PackingRegime::dense_close);
  EXPECT_FALSE(packing.pair_correlation || packing.structure_factor || packing.local_density);
}

TEST(Packing, a_floor_and_walls_count_as_neighbours) {
  // A square packing on a floor between side walls.
  Discs discs;
  for (int row = 0; row < 9; ++row) {
    for (int k = 0; k < 6; ++k) discs.add({{k + 0.5, row + 0.5}}, 0.5);
  }
  PackingOptions options;
  options.slab = {-0.5, 1.5, 0.5};  // ybar = 4: all but the uppermost three rows
  const auto box = sides(6.0, false);
  const auto apart = read(discs, box, options);
  EXPECT_EQ(apart.coordination.discs, 6u * 6u);
  EXPECT_NEAR(apart.coordination.mean.mean, (36 * 4 - 2 * 6 - 6) / 36.0, 1e-14);
  options.walls = {0.0, 0.0, 6.0};
  EXPECT_EQ(read(discs, box, options).coordination.mean.mean, 4.0);
}

TEST(Packing, of_sticking_discs_agrees_with_an_independent_code) {
  // Critical angle 90 degrees at the paper's size, 32 x 1000: an independent implementation gives 0.374, and z = 2.
  std::vector<double> fractions, coordinations, fraction_errors, coordination_errors, ratios;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    PackingOptions options;
    options.local_density = true;
    const auto packing = read(sticking_packing(32, 1000, seed), sides(32.0), options);
    fractions.push_back(packing.solid_fraction.mean);
    fraction_errors.push_back(squared(packing.solid_fraction.error));
    coordinations.push_back(packing.coordination.mean.mean);
    coordination_errors.push_back(squared(packing.coordination.mean.error));
    ratios.push_back(packing.local_density->solid_fraction / packing.solid_fraction.mean);
    EXPECT_EQ(packing.local_density->open, 0u);
    EXPECT_NEAR(packing.local_density->density.mean, packing.solid_fraction.mean, 0.15);
    EXPECT_EQ(packing.regime, PackingRegime::loose_random);
    EXPECT_EQ(packing.regime_by_structure, PackingRegime::loose_random);
  }
  const auto fraction = mean_of(fractions);
  EXPECT_NEAR(fraction.mean, 0.374, 4.0 * fraction.error + 0.0005);  // given to three digits
  EXPECT_NEAR(mean_of(coordinations).mean, 2.0, 4.0 * mean_of(coordinations).error + 0.002);
  // The cells of the discs in the slab cover about the area of the slab.
  EXPECT_NEAR(mean_of(ratios).mean, 1.0, 0.01);
  // Errors estimated from one packing. That of z is too large, about threefold: contacts across the edges of blocks
  // make the coordination of blocks scatter, while over the whole slab every contact counts at both ends.
  EXPECT_NEAR(std::sqrt(mean_of(fraction_errors).mean) / fraction.deviation, 0.85, 0.25);
  EXPECT_NEAR(std::sqrt(mean_of(coordination_errors).mean) / mean_of(coordinations).deviation, 3.0, 1.0);
}

TEST(Packing, local_density_of_cells_that_tile_the_slab_is_its_solid_fraction) {
  // Random discs in a slab with its mirror images above and below, so that cells end exactly at the edges.
  const auto slab = slab_between(0.0, 12.0, sides(15.0));
  auto discs = independent_discs(150, slab, 11);
  const auto inside = discs.size();
  for (std::size_t k = 0; k < inside; ++k) {
    const auto place = discs.position[k];
    discs.add({{place[0], -place[1]}}, 0.5);
    discs.add({{place[0], 24.0 - place[1]}}, 0.5);
  }
  const auto density = local_density(discs, slab, 50);
  EXPECT_EQ(density.cells, 150u);
  EXPECT_NEAR(density.solid_fraction, 150 * pi / 4.0 / slab.area(), 1e-9);
  // For equal discs, the mean of the inverse is the inverse of the solid fraction.
  double sum = 0.0;
  for (std::size_t k = 0; k < density.count.size(); ++k) sum += density.probability[k] * density.bin_width;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(PackingRegime, has_the_boundaries_of_paper_one) {
  EXPECT_EQ(regime_of(0.35), PackingRegime::loose_random);
  EXPECT_EQ(regime_of(0.599), PackingRegime::loose_random);
  EXPECT_EQ(regime_of(0.6), PackingRegime::moderate_random);
  EXPECT_EQ(regime_of(0.7), PackingRegime::dense_close);
  EXPECT_EQ(regime_of(0.8), PackingRegime::dense_ordered);
  EXPECT_EQ(regime_of(0.9069), PackingRegime::dense_ordered);
  EXPECT_FALSE(regime_of(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(name_of(PackingRegime::moderate_random), "moderate random");
}

TEST(PackingRegime, by_structure_takes_the_most_frequent_number_of_contacts) {
  EXPECT_EQ(regime_of({0, 0.3, 0.4, 0.3, 0, 0, 0}, 2.0), PackingRegime::loose_random);
  EXPECT_EQ(regime_of({0, 0.5, 0.2, 0.3, 0, 0, 0}, 1.8), PackingRegime::loose_random);
  EXPECT_EQ(regime_of({0, 0, 0.3, 0.4, 0.3, 0, 0}, 3.0), PackingRegime::moderate_random);
  EXPECT_EQ(regime_of({0, 0, 0.1, 0.3, 0.5, 0.1, 0}, 3.6), PackingRegime::dense_close);
  EXPECT_EQ(regime_of({0, 0, 0, 0.2, 0.4, 0.4, 0}, 4.2), PackingRegime::dense_ordered);
  EXPECT_FALSE(regime_of({1, 0, 0, 0, 0, 0, 0}, 0.0));
}

}  // namespace
}  // namespace repose
