// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/problem.hpp"
#include "repose/methods/contact_dynamics/yielding.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

struct SolverSettings {
  double tolerance = 1e-6;  ///< largest accepted Residual::worst, in gravity times time step
  long most_sweeps = 2000;  ///< largest number of sweeps, each forward and backward
  bool accelerated = true;  ///< conjugate residuals; otherwise sweeps alone
  bool packed = true;       ///< discs: eight contacts at a time in an order of their own; otherwise one by one
};

/// The cost and accuracy of a solution.
struct Solution {
  long sweeps = 0;        ///< number of sweeps, each forward and backward
  double residual = 0.0;  ///< Residual::worst of the final impulses
  bool converged = true;  ///< whether the residual is within the tolerance
};

/// The impulses of all contacts and the velocities that they produce: a point, or a step between two points.
template <class Impulses>
struct Point {
  Impulses impulses;
  AlignedDoubles motions;  ///< velocities and rim velocities, body by body, padded with zeros to whole cache lines

  void add(double factor, const Point& other);
};

/// Solves a contact problem by symmetric sweeps of nonlinear Gauss-Seidel, starting from the impulses of the contacts.
/// Sets the impulses, and the velocities of the bodies from them. Source of the sweeps: Moreau (1988), Jean (1999).
///
/// As long as no contact opens, closes, slips or sticks, a sweep is a linear map, and its change is the residual of a
/// linear system. So the search remembers steps and the changes that they made, and combines them to the smallest
/// change (truncated conjugate residuals). It uses the measure of kinetic energy, in which the map is symmetric if no
/// contact slides. If a sweep changes more than predicted, another set of contacts is active, and the search restarts.
///
/// A packing has more contacts than its grains have degrees of freedom. Then sweeps may end in a drift: they repeat the
/// same change, a self-stress without velocities, until a contact opens or slides and the others can be satisfied. The
/// search leaps over the drift.
///
/// `Sweeps` is LineSweeps<D>, or PackSweeps for discs.
template <int D, class Sweeps>
class Search {
 public:
  explicit Search(const SolverSettings& settings) : settings_(settings) {}

  Solution solve(Problem<D>& problem);

 private:
  using Step = Point<typename Sweeps::Impulses>;

  /// Two is one more than a symmetric map needs; it reduces the effect of rounding and of sliding contacts.
  static constexpr std::size_t most_remembered = 2;

  /// The coefficients with which a step and its image are made orthogonal to others, scaled and applied.
  struct Combination {
    std::array<std::size_t, most_remembered> others{};
    std::array<double, most_remembered> along_others{};
    double factor = 1.0;
    double along = 0.0;
    std::size_t slot = 0;
  };

  void begin(Problem<D>& problem);
  void sweep(Problem<D>& problem, long sweeps);
  void take_change(const Problem<D>& problem);
  bool check_is_due(const Solution& solution, double enough) const;
  bool small_enough(const Problem<D>& problem, Solution& solution);
  void correct_velocities(const Problem<D>& problem);
  void combine();
  template <std::size_t Others>
  void combine_impulses(const Combination& by);
  void restart(double square);
  double drift(const Problem<D>& problem, double square);
  bool leap(const Problem<D>& problem);
  void apply_prediction(Problem<D>& problem);
  double product(const Step& a, const Step& b) const;

  SolverSettings settings_;
  Sweeps sweeps_;
  Yielding yielding_;
  bool yields_ = false;                          // whether any friction is infinite
  AlignedDoubles weights_;                       // of velocities in twice the kinetic energy; 0 for fixed bodies
  Step base_;                                    // the point at which the next change is predicted
  Step predicted_;                               // the predicted change
  Step change_;                                  // the change of the last sweep
  std::array<Step, most_remembered + 1> step_;   // remembered steps, whose images are orthonormal
  std::array<Step, most_remembered + 1> image_;  // the decrease of the change by each step
  std::size_t remembered_ = 0;
  std::size_t newest_ = 0;
  long restarts_in_a_row_ = 0;  // consecutive restarts
  double predicted_square_ = 0.0;
  typename Sweeps::Impulses difference_;  // working memory
  std::vector<Impulse<D>> best_;          // impulses with the least residual so far
  bool leapt_ = false;                    // whether the search leapt since velocities were last corrected
  long next_check_ = 0;                   // sweep before which the residual is not computed again
  std::vector<Body<D>> scratch_;
};

}  // namespace repose::contact_dynamics
