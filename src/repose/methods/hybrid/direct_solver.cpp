// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/eigen.hpp"
#include "repose/core/grains.hpp"
#include "repose/methods/hybrid/acceleration.hpp"
#include "repose/methods/hybrid/soft_solver.hpp"

#include <algorithm>
#include <cmath>

namespace repose::hybrid {

namespace {

using Numbers = Eigen::VectorXd;

constexpr long most_newton_steps = 60;
constexpr long most_of_descent = 20;  // a shorter step of descent is cheaper than more
// An iteration that leaves less than this of the residual keeps its factorisation: Newton's steps of descent, and
// accelerated ones, which learn what the matrix lacks and forget it with the factorisation.
constexpr double quick_descent = 0.1;
constexpr double quick = 0.9;

/// Residuals [weight] that rounding of places alone makes.
double rounding_of(const SoftSystem& system) {
  double extent = 0.0;
  for (const auto& body : system.bodies) {
    extent = std::max({extent, std::fabs(body.start[0]), std::fabs(body.start[1])});
  }
  return 8.0 * std::numeric_limits<double>::epsilon() * extent * system.spring.stiffness / system.weight;
}

}  // namespace

/// The lower triangle, column by column, and its factorisation.
struct DirectSolver::Matrix {
  Eigen::SparseMatrix<double> lower;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> factors;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pattern;  // bodies that are coupled
  std::vector<int> rank;                                         // of each pair of bodies, among those of its first
  std::size_t bodies = 0;
  int block = 0;

  bool suits(const SoftSystem& system, int size) const {
    if (bodies != system.bodies.size() || block != size) return false;
    std::size_t k = 0;
    for (const auto& pair : system.pairs) {
      if (pair.second == nobody) continue;
      if (k == pattern.size() || pattern[k] != std::pair(pair.first, pair.second)) return false;
      ++k;
    }
    return k == pattern.size();
  }

  void lay_out(const SoftSystem& system, int size) {
    bodies = system.bodies.size();
    block = size;
    pattern.clear();
    rank.clear();
    std::vector<std::vector<std::uint32_t>> later(bodies);
    for (const auto& pair : system.pairs) {
      if (pair.second == nobody) continue;
      rank.push_back(static_cast<int>(later[pair.first].size()));
      later[pair.first].push_back(pair.second);
      pattern.emplace_back(pair.first, pair.second);
    }
    const auto unknowns = static_cast<Eigen::Index>(bodies) * block;
    lower.resize(unknowns, unknowns);
    std::vector<int> entries(static_cast<std::size_t>(unknowns));
    for (std::size_t k = 0; k < bodies; ++k) {
      for (int c = 0; c < block; ++c) {
        entries[k * static_cast<std::size_t>(block) + static_cast<std::size_t>(c)] =
            block - c + block * static_cast<int>(later[k].size());
      }
    }
    lower.reserve(entries);
    for (std::size_t k = 0; k < bodies; ++k) {
      const auto at = static_cast<Eigen::Index>(k) * block;
      for (int c = 0; c < block; ++c) {
        for (int r = c; r < block; ++r) lower.insert(at + r, at + c) = 1.0;
        for (const auto other : later[k]) {
          for (int r = 0; r < block; ++r) lower.insert(static_cast<Eigen::Index>(other) * block + r, at + c) = 1.0;
        }
      }
    }
    lower.makeCompressed();
    factors.analyzePattern(lower);
  }

  double* column(std::uint32_t body, int c) {
    return lower.valuePtr() + lower.outerIndexPtr()[static_cast<int>(body) * block + c];
  }
  void add_own(std::uint32_t body, int r, int c, double value) { column(body, c)[r - c] += value; }
  void add_both(std::uint32_t first, int place, int r, int c, double value) {
    column(first, c)[block - c + place * block + r] += value;
  }

  void fill(const SoftSystem& system) {
    std::fill(lower.valuePtr(), lower.valuePtr() + lower.nonZeros(), 0.0);
    for (std::uint32_t k = 0; k < bodies; ++k) {
      const auto& body = system.bodies[k];
      const double inertia = 2.0 * body.mass / (body.duration * system.step);
      add_own(k, 0, 0, inertia);
      add_own(k, 1, 1, inertia);
      if (block == 3) add_own(k, 2, 2, inertia / inverse_inertia_factor<2>);
    }
    std::size_t of_bodies = 0;
    for (const auto& pair : system.pairs) {
      const auto slopes = system.slopes(pair);
      own_block(system, pair.first, slopes.first, slopes.tangent, slopes.drag_first, 1.0);
      if (pair.second == nobody) continue;
      own_block(system, pair.second, slopes.second, slopes.tangent, slopes.drag_second, -1.0);
      block_of_both(system, pair, rank[of_bodies++], slopes);
    }
    // A pinned body has no equation for its x.
    for (std::uint32_t k = 0; k < bodies; ++k) {
      if (system.bodies[k].pinned) column(k, 0)[0] = 1.0;
    }
  }

  void own_block(const SoftSystem& system, std::uint32_t k, const Symmetric& slope, const Vec<2>& tangent, double drag,
                 double side) {
    const bool free = !system.bodies[k].pinned;
    if (free) {
      add_own(k, 0, 0, slope.xx);
      add_own(k, 1, 0, slope.xy);
    }
    add_own(k, 1, 1, slope.yy);
    if (block < 3) return;
    if (free) add_own(k, 2, 0, -side * drag * tangent[0]);
    add_own(k, 2, 1, -side * drag * tangent[1]);
    add_own(k, 2, 2, drag);
  }

  void block_of_both(const SoftSystem& system, const SoftPair& pair, int place, const PairSlopes& slopes) {
    const bool first_free = !system.bodies[pair.first].pinned;
    const bool second_free = !system.bodies[pair.second].pinned;
    const auto add = [&](int r, int c, double value) {
      if ((r == 0 && !second_free) || (c == 0 && !first_free)) return;
      add_both(pair.first, place, r, c, value);
    };
    add(0, 0, -slopes.both.xx);
    add(0, 1, -slopes.both.xy);
    add(1, 0, -slopes.both.xy);
    add(1, 1, -slopes.both.yy);
    if (block < 3) return;
    for (int axis = 0; axis < 2; ++axis) {
      add(2, axis, -slopes.drag_both * slopes.tangent[axis]);
      add(axis, 2, slopes.drag_both * slopes.tangent[axis]);
    }
    add(2, 2, slopes.drag_both);
  }

  bool factorise(const SoftSystem& system) {
    fill(system);
    factors.factorize(lower);
    return factors.info() == Eigen::Success;
  }
  bool is_definite() const { return factors.vectorD().minCoeff() > 0.0; }

  Numbers residuals(const SoftSystem& system) const {
    Numbers found(lower.rows());
    for (std::size_t k = 0; k < bodies; ++k) {
      const auto at = static_cast<Eigen::Index>(k) * block;
      found[at] = system.bodies[k].pinned ? 0.0 : system.unbalanced[k][0];
      found[at + 1] = system.unbalanced[k][1];
      if (block == 3) found[at + 2] = system.unbalanced_turn[k];
    }
    return found;
  }

  void move(SoftSystem& system, const Numbers& step, double by) const {
    for (std::size_t k = 0; k < bodies; ++k) {
      const auto at = static_cast<Eigen::Index>(k) * block;
      system.bodies[k].moved += Vec<2>{{by * step[at], by * step[at + 1]}};
      if (block == 3) system.bodies[k].rolled += by * step[at + 2];
    }
  }
};

DirectSolver::DirectSolver() : matrix_(std::make_unique<Matrix>()) {}
DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;

Solved DirectSolver::solve(SoftSystem& system, double tolerance, bool definite) {
  const int block = system.rolls() ? 3 : 2;
  if (block == 2 && !system.statics) {
    for (auto& body : system.bodies) body.rolled = body.rim_velocity * body.duration;
  }
  if (!matrix_->suits(system, block)) matrix_->lay_out(system, block);
  const double rounding = rounding_of(system);
  Solved solved;
  Acceleration acceleration;
  bool stale = true;
  bool fresh = false;
  system.balance();
  for (;;) {
    const auto worst = system.worst();
    solved.residual = worst.residual;
    solved.worst = worst.body;
    if (!std::isfinite(worst.residual)) return solved;
    if (worst.residual <= tolerance) {
      solved.converged = true;
      return solved;
    }
    if (solved.iterations == (definite ? most_of_descent : most_newton_steps)) return solved;
    if (stale) {
      system.straight = false;
      if (!matrix_->factorise(system)) return solved;
      if (definite && !matrix_->is_definite()) {
        system.straight = true;
        if (!matrix_->factorise(system) || !matrix_->is_definite()) return solved;
      }
      fresh = true;
      acceleration.forget();
    }
    ++solved.iterations;
    const double before = system.sum_of_squares();
    Numbers step = -matrix_->factors.solve(matrix_->residuals(system));
    if (!definite) step = acceleration.step(step);
    double by = 1.0;
    matrix_->move(system, step, by);
    system.balance();
    double after = system.sum_of_squares();
    if (!(after < before)) {
      // With an old matrix, return and compute it; with a new one, go a shorter way.
      constexpr double shortest = 0.05;
      while (!(after < before) && by > shortest && fresh) {
        matrix_->move(system, step, -0.5 * by);
        by *= 0.5;
        system.balance();
        after = system.sum_of_squares();
      }
      acceleration.shortened(by);
      if (!(after < before)) {
        const bool at_rounding = worst.residual <= std::max(tolerance, rounding);
        if (!fresh || at_rounding) {
          matrix_->move(system, step, -by);
          system.balance();
        }
        if (at_rounding) {
          solved.converged = true;
          return solved;
        }
      }
    }
    const double keep = definite ? quick_descent : quick;
    stale = !(after < keep * keep * before);
    fresh = false;
  }
}

}  // namespace repose::hybrid
