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
  /// Of Residual::worst: velocities over gravity times time step.
  double tolerance = 1e-6;
  long most_sweeps = 2000;  ///< forward and backward sweeps at most
  bool accelerated = true;  ///< conjugate residuals; else sweeps alone
  bool packed = true;       ///< contacts of discs eight at a time, in an order of their own; else one by one
};

/// What a solution cost and how good it is.
struct Solution {
  long sweeps = 0;        ///< forward and backward, each pair counted once
  double residual = 0.0;  ///< Residual::worst of the impulses that were left
  bool converged = true;  ///< residual within the tolerance
};

/// Impulses of all contacts with the velocities that they make: a point, or a step from one to another.
template <class Impulses>
struct Point {
  Impulses impulses;
  AlignedDoubles motions;  ///< velocities and rim velocities, body by body, then zeros to whole cache lines

  void add(double share, const Point& other);
};

/// Solves a contact problem by symmetric sweeps of nonlinear Gauss-Seidel from the impulses that the contacts bring.
/// Leaves impulses, and bodies whose velocities are made of them. Source of the sweeps: Moreau (1988), Jean (1999).
///
/// As long as no contact opens, closes, slips or sticks, a sweep is a linear map, and the change that it brings is the
/// residual of a linear system. So steps and the changes that they made are remembered and combined to the smallest
/// change (conjugate residuals, truncated), in the measure of kinetic energy, in which the map is symmetric where no
/// contact slides. A sweep that changes more than foretold shows another set of contacts at work: then it starts anew.
///
/// A packing has more contacts than its grains can obey. Then sweeps end in a drift: the same change again and again, a
/// self-stress without velocities, until a contact opens or slides and the rest can be obeyed. The drift is leapt over.
///
/// `Sweeps` is LineSweeps<D>, or PackSweeps for discs.
template <int D, class Sweeps>
class Search {
 public:
  explicit Search(const SolverSettings& settings) : settings_(settings) {}

  Solution solve(Problem<D>& problem);

 private:
  using Step = Point<typename Sweeps::Impulses>;

  /// With two, one more than a symmetric map needs, rounding does less harm and contacts that slide do too.
  static constexpr std::size_t most_remembered = 2;

  /// How a step and its image are made orthogonal to others, scaled, and taken.
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
  bool look_is_due(const Solution& solution, double enough) const;
  bool small_enough(const Problem<D>& problem, Solution& solution);
  void correct_velocities(const Problem<D>& problem);
  void combine();
  template <std::size_t Others>
  void combine_impulses(const Combination& by);
  void start_anew(double square);
  double drift(const Problem<D>& problem, double square);
  bool leap(const Problem<D>& problem);
  void go_on(Problem<D>& problem);
  double product(const Step& a, const Step& b) const;

  SolverSettings settings_;
  Sweeps sweeps_;
  Yielding yielding_;
  bool yields_ = false;                          // whether some friction is infinite
  AlignedDoubles weights_;                       // of the motions in twice the kinetic energy; 0: of what nothing moves
  Step base_;                                    // where the next change is foretold
  Step foretold_;                                // that change
  Step change_;                                  // of the last sweeps
  std::array<Step, most_remembered + 1> step_;   // made so that their images are orthonormal
  std::array<Step, most_remembered + 1> image_;  // by how much a step reduces the change
  std::size_t remembered_ = 0;
  std::size_t newest_ = 0;
  long anew_in_a_row_ = 0;  // sweeps after which nothing could be combined
  double foretold_square_ = 0.0;
  typename Sweeps::Impulses difference_;  // room to work in
  std::vector<Impulse<D>> best_;          // of the least residual that was seen
  bool leapt_ = false;                    // since velocities were last corrected
  long next_look_ = 0;                    // sweeps
  std::vector<Body<D>> scratch_;
};

}  // namespace repose::contact_dynamics
