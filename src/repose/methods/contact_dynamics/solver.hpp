// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

struct SolverSettings {
  /// Of Residual::worst: velocities over gravity times time step.
  double tolerance = 1e-6;
  long most_sweeps = 2000;  ///< forward and backward sweeps at most
  bool accelerated = true;  ///< conjugate residuals; else sweeps alone
};

/// What a solution cost and how good it is.
struct Solution {
  long sweeps = 0;        ///< forward and backward, each pair counted once
  double residual = 0.0;  ///< Residual::worst of the impulses that were left
  bool converged = true;  ///< residual within the tolerance
};

/// Impulses of all contacts with the velocities that they make: a point, or a step from one to another.
template <int D>
struct Motion {
  Vec<D> velocity{};
  Spin<D> rim_velocity{};
};
template <int D>
struct Point {
  std::vector<Impulse<D>> impulses;
  std::vector<Motion<D>> motions;

  void reset(std::size_t contacts, std::size_t bodies) {
    impulses.assign(contacts, {});
    motions.assign(bodies, {});
  }
  void add(double share, const Point& other);
  void scale(double factor);
};

/// How readily the friction of a contact follows.
struct Yield {
  float share = 1.0f;   ///< of the way that it goes in a sweep
  bool pressed = true;  ///< after the last sweep

  void take(bool is_pressed);
};

/// Solves the contact problem by symmetric sweeps of nonlinear Gauss-Seidel from the impulses that the contacts bring.
/// Leaves impulses, and bodies whose velocities are made of them. Source of the sweeps: Moreau (1988), Jean (1999).
///
/// As long as no contact opens, closes, slips or sticks, a sweep is a linear map, and the change that it brings is the
/// residual of a linear system. So steps and the changes that they made are remembered and combined to the smallest
/// change (conjugate residuals, truncated), in the measure of kinetic energy, in which the map is symmetric where no
/// contact slides. A sweep that changes more than foretold shows another set of contacts at work: then it starts anew.
///
/// A packing has more contacts than its grains can obey. Then sweeps end in a drift: the same change again and again, a
/// self-stress without velocities, until a contact opens or slides and the rest can be obeyed. The drift is leapt over.
template <int D>
class Solver {
 public:
  explicit Solver(const SolverSettings& settings) : settings_(settings) {}

  Solution solve(Problem<D>& problem);

 private:
  void begin(const Problem<D>& problem);
  void begin_yielding(const Problem<D>& problem);
  void take_change(const Problem<D>& problem);
  bool look_is_due(const Solution& solution, double enough) const;
  bool small_enough(const Problem<D>& problem, Solution& solution);
  void combine();
  void start_anew(double square);
  bool leap(const Problem<D>& problem);
  void go_on(Problem<D>& problem) const;
  double product(const Point<D>& a, const Point<D>& b) const;

  /// With two, one more than a symmetric map needs, rounding does less harm and contacts that slide do too.
  static constexpr std::size_t most_remembered = 2;

  SolverSettings settings_;
  std::vector<Yield> yield_;                         // of the contacts, once it is asked for
  std::vector<double> masses_;                       // of the bodies; 0: nothing moves it
  Point<D> base_;                                    // where the next change is foretold
  Point<D> foretold_;                                // that change
  Point<D> change_;                                  // of the last sweeps
  std::array<Point<D>, most_remembered + 1> step_;   // made so that their images are orthonormal
  std::array<Point<D>, most_remembered + 1> image_;  // by how much a step reduces the change
  std::size_t remembered_ = 0;
  std::size_t newest_ = 0;
  double foretold_square_ = 0.0;
  std::vector<Impulse<D>> best_;  // of the least residual that was seen
  long next_look_ = 0;            // sweeps
  std::vector<Body<D>> scratch_;
};

}  // namespace repose::contact_dynamics
