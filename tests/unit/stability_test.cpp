// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/eigen.hpp"
#include "repose/stability/spectrum.hpp"
#include "repose/stability/stiffness_matrix.hpp"
#include "support/discs.hpp"
#include "support/static_pile.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

constexpr double degree_of_arc = std::numbers::pi / 180.0;

/// Rounding, as bisection and inverse iteration leave it in matrices whose largest entries are about `scale`.
double rounding_of(double scale) { return 1e-11 * scale; }

Eigen::MatrixXd dense(const SymmetricMatrix& matrix) {
  const auto size = static_cast<int>(matrix.size);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(size, size);
  for (const auto& one : matrix.lower) {
    const auto row = static_cast<int>(one.row);
    const auto column = static_cast<int>(one.column);
    full(row, column) += one.value;
    if (row != column) full(column, row) += one.value;
  }
  return full;
}

/// The upright normal of a spring below a grain.
const Vec<2> up{{0.0, 1.0}};

// A disc of weight 1 on two fixed ones, with normals at an angle a from the vertical: F = 1/(2 cos a) each, and by
// symmetry the matrix is diagonal, 2 (k sin^2 a - F/r cos^2 a) along x and 2 (k cos^2 a - F/r sin^2 a) along y.
TEST(StiffnessMatrix, OfADiscInANotch) {
  constexpr double k = 300.0;
  for (const double angle : {10.0 * degree_of_arc, 30.0 * degree_of_arc, 60.0 * degree_of_arc}) {
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    const double force = 0.5 / c;
    const double r = 1.0 - force / k;
    const auto made = stiffness_matrix(
        1, {{0, ContactSpring::nothing, {{s, c}}, k, force, r}, {0, ContactSpring::nothing, {{-s, c}}, k, force, r}});
    const auto full = dense(made.matrix);
    EXPECT_NEAR(full(0, 0), 2.0 * (k * s * s - force / r * c * c), rounding_of(k));
    EXPECT_NEAR(full(1, 1), 2.0 * (k * c * c - force / r * s * s), rounding_of(k));
    EXPECT_NEAR(full(0, 1), 0.0, rounding_of(k));
    Spectrum spectrum(made.matrix);
    const auto smallest = spectrum.smallest();
    EXPECT_NEAR(smallest.value, std::min(full(0, 0), full(1, 1)), rounding_of(k));
    EXPECT_NEAR(smallest.vector[full(0, 0) < full(1, 1) ? 0 : 1], 1.0, 1e-9);
  }
}

// One disc on another on a flat floor without friction: springs carry 2 and 1. Along x the matrix is -(1/r) of
// [1 -1; -1 1], with the eigenvalues 0 (both move along) and -2/r (the upper one topples): one unstable direction, one
// neutral. Friction on the floor that holds the lower disc leaves the upper one with -1/r.
TEST(StiffnessMatrix, OfTwoDiscsOnAFloorHasAnUnstableDirection) {
  constexpr double k = 100.0;
  const double r = 1.0 - 1.0 / k;
  std::vector<ContactSpring> springs{{0, ContactSpring::nothing, up, k, 2.0}, {1, 0, up, k, 1.0, r}};
  {
    const auto made = stiffness_matrix(2, springs);
    ASSERT_EQ(made.matrix.size, 4U);
    Spectrum spectrum(made.matrix);
    EXPECT_NEAR(spectrum.smallest().value, -2.0 / r, rounding_of(k));
    EXPECT_EQ(spectrum.below(-1e-9 * k), 1U);
    EXPECT_EQ(spectrum.below(1e-9 * k), 2U);
  }
  springs[0].holds = true;
  const auto made = stiffness_matrix(2, springs);
  ASSERT_EQ(made.matrix.size, 3U);
  Spectrum spectrum(made.matrix);
  EXPECT_NEAR(spectrum.smallest().value, -1.0 / r, rounding_of(k));
  EXPECT_EQ(spectrum.below(1e-9 * k), 1U);
}

// Two discs side by side, each on a fixed one that bears P, between two flat walls that press with H: along x the
// eigenvalues are k - P/r (both move alike) and 3 k - P/r, along y k and k - 2 H/r. The square buckles where P = k r.
TEST(StiffnessMatrix, OfALoadedSquareBuckles) {
  constexpr double k = 50.0;
  constexpr double side = 0.25;
  const Vec<2> right{{1.0, 0.0}};
  for (const double load : {20.0, 44.0, 45.0}) {
    const double r = 0.9;
    const double beside = 1.0 - side / k;
    const auto made = stiffness_matrix(2, {{0, ContactSpring::nothing, up, k, load, r},
                                           {1, ContactSpring::nothing, up, k, load, r},
                                           {0, ContactSpring::nothing, right, k, side},
                                           {1, ContactSpring::nothing, -right, k, side},
                                           {1, 0, right, k, side, beside}});
    Spectrum spectrum(made.matrix);
    const auto smallest = spectrum.smallest();
    const double expected = std::min(k - load / r, k - 2.0 * side / beside);
    EXPECT_NEAR(smallest.value, expected, rounding_of(k));
    EXPECT_NEAR(smallest.vector[0], std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(smallest.vector[2], std::sqrt(0.5), 1e-9);
    EXPECT_EQ(spectrum.below(-rounding_of(k)), load / r > k ? 1U : 0U);
  }
}

/// Discs at random places with springs between those that are near, some of them fixed.
std::vector<ContactSpring> random_springs(std::uint64_t seed, std::size_t grains) {
  Draw draw(seed);
  std::vector<Vec<2>> places;
  const double width = std::sqrt(static_cast<double>(grains));
  for (std::size_t k = 0; k < grains; ++k) places.push_back({{width * draw(), width * draw()}});
  std::vector<ContactSpring> springs;
  for (std::size_t a = 0; a < grains; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto apart = places[a] - places[b];
      const double r = magnitude(apart);
      if (r > 1.3) continue;
      const auto second = draw() < 0.1 ? ContactSpring::nothing : b;
      springs.push_back({a, second, apart * (1.0 / r), 10.0 + 90.0 * draw(), 5.0 * draw(), r});
    }
    if (draw() > 0.2) continue;
    springs.push_back({a, ContactSpring::nothing, up, 50.0, draw()});
    springs.back().holds = draw() < 0.3;
  }
  return springs;
}

// Against all eigenvalues of the full matrix. A random network has floppy and unstable parts, so that some eigenvalues
// are negative and several are near 0.
TEST(Spectrum, IsThatOfTheFullMatrix) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto matrix = stiffness_matrix(60, random_springs(seed, 60)).matrix;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> reference(dense(matrix));
    const auto& values = reference.eigenvalues();
    Spectrum spectrum(matrix);
    const auto smallest = spectrum.smallest();
    EXPECT_NEAR(smallest.value, values[0], rounding_of(values.cwiseAbs().maxCoeff()));
    EXPECT_LT(smallest.residual, 1e-10 * values.cwiseAbs().maxCoeff());
    double overlap = 0.0;
    for (int k = 0; k < values.size(); ++k) {
      overlap += smallest.vector[static_cast<std::size_t>(k)] * reference.eigenvectors()(k, 0);
    }
    EXPECT_NEAR(std::fabs(overlap), 1.0, 1e-9);
    for (int k = 0; k + 1 < values.size(); k += 7) {
      if (values[k + 1] - values[k] < 1e-6) continue;
      EXPECT_EQ(spectrum.below(0.5 * (values[k] + values[k + 1])), static_cast<std::size_t>(k + 1));
    }
  }
}

// The symmetric state of the pile of 45 rows: stable at m g/k = 5.0e-5 and unstable at 6.7e-5. These bounds are those
// between which an independent code saw it buckle; the forces are near (42) to (44), so all diagonals push, and rows
// have gaps.
TEST(Stability, TheEquilateralPileBucklesAsItGetsSofter) {
  const auto smallest_at = [](double softness) {
    const testing::SymmetricPile pile(45, 1.0 / softness);
    EXPECT_LT(pile.largest_overlap_in_rows(), 0.0);
    EXPECT_GT(pile.least_force(), 0.5);  // 1/sqrt(3) at the apex, for hard discs
    const auto stiffness = stiffness_matrix(pile.size(), pile.springs());
    EXPECT_EQ(stiffness.matrix.size, 1980U);
    return Spectrum(stiffness.matrix).smallest().value * softness;
  };
  const double before = smallest_at(5.0e-5);
  const double after = smallest_at(6.7e-5);
  EXPECT_GT(before, 0.0);
  EXPECT_LT(after, 0.0);
  RecordProperty("at_5.0e-5", std::to_string(before));
  RecordProperty("at_6.7e-5", std::to_string(after));
}

}  // namespace
}  // namespace repose
