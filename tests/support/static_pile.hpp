// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/eigen.hpp"
#include "repose/stability/stiffness_matrix.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace repose::testing {

/// The equilateral pile of frictionless discs of diameter and weight 1 on its fixed lowest row, at rest in its
/// symmetric state, stable or not. Contacts along the diagonals alone are springs, which pull too during Newton's
/// method; along the rows there are gaps.
class SymmetricPile {
 public:
  SymmetricPile(int rows, double stiffness) : stiffness_(stiffness) {
    const double rise = std::sqrt(3.0) / 2.0;
    std::vector<std::vector<std::size_t>> at;
    for (int r = 0; r < rows; ++r) {
      at.emplace_back();
      for (int j = 0; j < rows - r; ++j) {
        at.back().push_back(place_.size());
        place_.push_back({{j + 0.5 * r, r * rise}});
        fixed_.push_back(r == 0);
        if (j > 0) beside_.push_back({place_.size() - 2, place_.size() - 1});
        if (r == 0) continue;
        const auto& below = at[static_cast<std::size_t>(r - 1)];
        for (int side = 0; side < 2; ++side) {
          below_.push_back({place_.size() - 1, below[static_cast<std::size_t>(j + side)]});
        }
      }
    }
    while (largest_net_force() > 1e-9) step();
  }

  std::size_t size() const { return place_.size(); }

  /// The contacts along the diagonals.
  std::vector<ContactSpring> springs() const {
    std::vector<ContactSpring> all;
    for (const auto& [upper, lower] : below_) {
      const auto apart = place_[upper] - place_[lower];
      const double distance = magnitude(apart);
      all.push_back({upper, fixed_[lower] ? ContactSpring::nothing : lower, apart * (1.0 / distance), stiffness_,
                     stiffness_ * (1.0 - distance), distance});
    }
    return all;
  }

  /// The largest overlap of two neighbours in a row above the base.
  double largest_overlap_in_rows() const {
    double largest = -1.0;
    for (const auto& [left, right] : beside_) {
      if (!fixed_[left]) largest = std::max(largest, 1.0 - magnitude(place_[right] - place_[left]));
    }
    return largest;
  }

  double least_force() const {
    double least = stiffness_;
    for (const auto& spring : springs()) least = std::min(least, spring.force);
    return least;
  }

 private:
  struct Pair {
    std::size_t a;
    std::size_t b;
  };

  std::vector<Vec<2>> net_forces() const {
    std::vector<Vec<2>> net(place_.size(), Vec<2>{{0.0, -1.0}});
    for (const auto& spring : springs()) {
      net[spring.first] += spring.normal * spring.force;
      if (spring.second != ContactSpring::nothing) net[spring.second] -= spring.normal * spring.force;
    }
    for (std::size_t k = 0; k < net.size(); ++k) {
      if (fixed_[k]) net[k] = {};
    }
    return net;
  }

  double largest_net_force() const {
    double largest = 0.0;
    for (const auto& force : net_forces()) largest = std::max(largest, magnitude(force));
    return largest;
  }

  void step() {
    const auto stiffness = stiffness_matrix(place_.size(), springs());
    const auto size = static_cast<int>(stiffness.matrix.size);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& one : stiffness.matrix.lower) {
      entries.emplace_back(static_cast<int>(one.row), static_cast<int>(one.column), one.value);
    }
    Eigen::SparseMatrix<double> lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd net(size);
    const auto forces = net_forces();
    const auto each = [&](auto act) {
      for (std::size_t k = 0; k < place_.size(); ++k) {
        const auto& freedom = stiffness.freedom[k];
        for (std::size_t i = 0; i < freedom.directions.size(); ++i) {
          act(k, freedom.directions[i], static_cast<int>(freedom.first + i));
        }
      }
    };
    each([&](std::size_t k, const Vec<2>& direction, int row) { net[row] = dot(forces[k], direction); });
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(lower);
    const Eigen::VectorXd moved = factors.solve(net);
    each([&](std::size_t k, const Vec<2>& direction, int row) { place_[k] += direction * moved[row]; });
  }

  double stiffness_;
  std::vector<Vec<2>> place_;
  std::vector<bool> fixed_;
  std::vector<Pair> below_;   // an upper disc and one on which it lies
  std::vector<Pair> beside_;  // neighbours in a row
};

}  // namespace repose::testing
