// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fabric.hpp"

#include "support/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace repose {
namespace {

Fabric read(const Discs& discs, const Slab& slab, std::size_t bins = 36) {
  const auto fabric = measure_fabric(discs, contact_graph(discs, slab.box, 1e-9), slab, bins, 4);
  EXPECT_TRUE(fabric);
  return fabric.value_or(Fabric{});
}

/// Pairs of touching discs, far from each other. Each pair leans by one of these angles [deg] from the vertical.
Discs pairs_leaning(const std::vector<double>& angles) {
  Discs discs;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double angle = angles[k] * std::numbers::pi / 180.0;
    const Vec<2> foot{{5.0 * static_cast<double>(k) + 2.5, 0.0}};
    const Vec<2> top = foot + Vec<2>{{std::sin(angle), std::cos(angle)}};
    discs.add(k % 2 == 0 ? foot : top, 0.5);  // the order of the two does not matter
    discs.add(k % 2 == 0 ? top : foot, 0.5);
  }
  return discs;
}

Slab around(const Discs& discs) { return slab_between(-5.0, 5.0, sides(2.5 * static_cast<double>(discs.size()))); }

TEST(Fabric, of_the_triangular_lattice_is_isotropic) {
  // 21 rows of horizontal contacts and 21 half-rows of diagonals between them.
  const double rise = std::sqrt(0.75);
  const auto fabric = read(triangular_packing(12, 40), slab_between(8.4 * rise, 29.4 * rise, sides(12.0)));
  EXPECT_EQ(fabric.contacts, 3u * 12u * 21u);
  EXPECT_NEAR(fabric.all.anisotropy.mean, 0.0, 1e-12);
  EXPECT_NEAR(fabric.all.xx, 0.5, 1e-13);
  EXPECT_NEAR(fabric.all.yy, 0.5, 1e-13);
  // |theta| is 30 deg twice and 90 deg: <|sin cos|> = sqrt(3)/6, axis at 45 deg.
  EXPECT_NEAR(fabric.folded.anisotropy.mean, 2.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(fabric.folded.direction_deg.mean, 45.0, 1e-10);
  EXPECT_NEAR(fabric.harmonics[0].cosine, 0.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[1].cosine, 0.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[2].cosine, -2.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[2].sine, 0.0, 1e-12);
  // Bins of 5 degrees: -30 is the twelfth, 30 the twenty-fourth, and all horizontal ones are in the last.
  for (std::size_t k = 0; k < 36; ++k) {
    const bool used = k == 11 || k == 23 || k == 35;
    EXPECT_EQ(fabric.count[k], used ? 12u * 21u : 0u) << fabric.direction_deg[k];
  }
}

TEST(Fabric, of_the_square_lattice_has_only_the_fourth_harmonic) {
  const auto fabric = read(square_packing(12, 40), slab_between(8.25, 29.25, sides(12.0)));
  EXPECT_EQ(fabric.contacts, 2u * 12u * 21u);
  EXPECT_NEAR(fabric.all.anisotropy.mean, 0.0, 1e-12);
  EXPECT_NEAR(fabric.folded.anisotropy.mean, 0.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[0].cosine, 0.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[1].cosine, 2.0, 1e-12);
  EXPECT_NEAR(fabric.harmonics[2].cosine, 0.0, 1e-12);
}

TEST(Fabric, angles_are_from_the_vertical_and_lean_to_the_right) {
  const auto right = pairs_leaning({20.0, 20.0, 20.0});
  const auto leaning = read(right, around(right));
  EXPECT_NEAR(leaning.all.anisotropy.mean, 2.0, 1e-12);
  EXPECT_NEAR(leaning.all.direction_deg.mean, 20.0, 1e-10);
  EXPECT_NEAR(leaning.all.direction_deg.error, 0.0, 1e-10);
  EXPECT_EQ(leaning.count[21], 3u);
  EXPECT_NEAR(leaning.direction_deg[21], 20.0, 1e-12);

  const auto left = pairs_leaning({-50.0, -50.0, -50.0, -50.0});
  const auto other = read(left, around(left));
  EXPECT_NEAR(other.all.direction_deg.mean, -50.0, 1e-10);
  EXPECT_NEAR(other.folded.direction_deg.mean, 50.0, 1e-10);

  const auto both = pairs_leaning({30.0, -30.0});
  const auto upright = read(both, around(both));
  EXPECT_NEAR(upright.all.direction_deg.mean, 0.0, 1e-10);
  EXPECT_NEAR(upright.all.anisotropy.mean, 1.0, 1e-12);  // 2 cos(60 deg)
  EXPECT_NEAR(upright.folded.direction_deg.mean, 30.0, 1e-10);

  const auto level = pairs_leaning({90.0, -90.0});
  EXPECT_NEAR(read(level, around(level)).all.direction_deg.mean, 90.0, 1e-10);
}

TEST(Fabric, harmonics_and_tensor_agree_with_the_angles) {
  Draw draw(4);
  std::vector<double> angles;
  double cosine[7] = {};
  double sine[7] = {};
  double folded_xy = 0.0;
  for (int k = 0; k < 500; ++k) {
    angles.push_back(180.0 * draw() - 90.0);
    const double angle = angles.back() * std::numbers::pi / 180.0;
    for (int m = 2; m <= 6; m += 2) {
      cosine[m] += 2.0 * std::cos(m * angle) / 500.0;
      sine[m] += 2.0 * std::sin(m * angle) / 500.0;
    }
    folded_xy += std::fabs(std::sin(angle) * std::cos(angle)) / 500.0;
  }
  const auto discs = pairs_leaning(angles);
  const auto fabric = read(discs, around(discs), 18);
  ASSERT_EQ(fabric.contacts, 500u);
  for (const auto& harmonic : fabric.harmonics) {
    // Angles are stored as positions near 2500, with 5e-13 of rounding each.
    EXPECT_NEAR(harmonic.cosine, cosine[harmonic.order], 1e-11);
    EXPECT_NEAR(harmonic.sine, sine[harmonic.order], 1e-11);
  }
  EXPECT_NEAR(fabric.all.anisotropy.mean, std::hypot(cosine[2], sine[2]), 1e-11);
  EXPECT_NEAR(fabric.all.xx + fabric.all.yy, 1.0, 1e-13);
  EXPECT_NEAR(fabric.folded.xy, folded_xy, 1e-11);
  EXPECT_NEAR(std::accumulate(fabric.density.begin(), fabric.density.end(), 0.0) * fabric.bin_width, 1.0, 1e-12);
  EXPECT_EQ(std::accumulate(fabric.count.begin(), fabric.count.end(), std::size_t{0}), 500u);
  std::vector<std::size_t> expected(18, 0);
  for (const double angle : angles) {
    for (std::size_t k = 0; k < 18; ++k) {
      const double away = std::remainder(angle - fabric.direction_deg[k], 180.0);
      if (away >= -5.0 && away < 5.0) ++expected[k];
    }
  }
  EXPECT_EQ(fabric.count, expected);
}

TEST(Fabric, contacts_count_by_their_contact_point) {
  Discs discs;  // radii 1 and 3, the contact at y = 1
  discs.add({{10.0, 0.0}}, 1.0);
  discs.add({{10.0, 4.0}}, 3.0);
  const auto box = sides(20.0);
  const auto graph = contact_graph(discs, box, 1e-9);
  EXPECT_TRUE(measure_fabric(discs, graph, slab_between(0.9, 1.1, box), 36, 2));
  EXPECT_FALSE(measure_fabric(discs, graph, slab_between(1.1, 4.1, box), 36, 2));
}

TEST(Fabric, of_sticking_discs_agrees_with_an_independent_code) {
  // Critical angle 90 degrees, 32 x 1000. An independent implementation gives 0.742 and 30.3 degrees in bulk. The
  // values 2/3 and 31.7 of the text ignore shadowing.
  std::vector<double> anisotropies;
  std::vector<double> directions;
  std::vector<double> errors;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto discs = sticking_packing(32, 1000, seed);
    const auto slab = *find_slab(discs, sides(32.0)).slab;
    const auto fabric = read(discs, slab);
    anisotropies.push_back(fabric.all.anisotropy.mean);
    directions.push_back(fabric.folded.direction_deg.mean);
    errors.push_back(squared(fabric.folded.direction_deg.error));
  }
  const auto anisotropy = mean_of(anisotropies);
  const auto direction = mean_of(directions);
  EXPECT_NEAR(anisotropy.mean, 0.742, 4.0 * anisotropy.error + 0.005);  // 0.005: effect of the small width of 32
  EXPECT_NEAR(direction.mean, 30.3, 4.0 * direction.error + 0.2);
  EXPECT_NEAR(std::sqrt(mean_of(errors).mean) / direction.deviation, 1.0, 0.4);
}

}  // namespace
}  // namespace repose
