// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/core/instruction_set.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"
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
  InstructionSet instructions = chosen_instruction_set();
};

/// The cost and accuracy of a solution.
struct Solution {
  long sweeps = 0;        ///< number of sweeps, each forward and backward
  double residual = 0.0;  ///< Residual::worst of the final impulses
  bool converged = true;  ///< whether the residual is within the tolerance
};

/// The impulses of all contacts and the velocities that they produce: a point, or a step between two points.
struct Point {
  AlignedDoubles impulses;  ///< as the sweeps number them
  AlignedDoubles motions;   ///< as in Motions
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
  explicit Search(const SolverSettings& settings) : settings_(settings), kernels_(kernels_of(settings.instructions)) {}

  /// The result is the same for any size of the team.
  Solution solve(Problem<D>& problem, Team& team);

 private:
  /// Two is one more than a symmetric map needs; it reduces the effect of rounding and of sliding contacts.
  static constexpr std::size_t most_remembered = 2;
  static_assert(most_remembered == Start::most_others);

  void begin(Problem<D>& problem);
  void sweep(Problem<D>& problem, long sweeps);
  void take_change(Problem<D>& problem);
  bool check_is_due(const Solution& solution, double enough) const;
  bool small_enough(const Problem<D>& problem, Solution& solution);
  void correct_velocities(const Problem<D>& problem);
  void combine(Problem<D>& problem);
  void restart();
  double drift(const Problem<D>& problem);
  bool leap(const Problem<D>& problem);
  History history(AlignedDoubles Point::*numbers);
  Motions<D> motions(Problem<D>& problem);
  template <class Piece>
  Taken over_motions(const Piece& piece);

  struct alignas(64) OfPart {  // on a cache line of its own
    Taken taken;
  };

  SolverSettings settings_;
  const Kernels& kernels_;
  Team* team_ = nullptr;
  std::vector<OfPart> of_parts_;
  Sweeps sweeps_;
  Yielding yielding_;
  bool yields_ = false;                       // whether any friction is infinite
  AlignedDoubles weights_;                    // of velocities in twice the kinetic energy; 0 for fixed bodies
  Point base_;                                // the point at which the next change is predicted
  Point predicted_;                           // the predicted change
  Point change_;                              // the change of the last sweep
  std::array<Point, most_remembered> step_;   // remembered steps, whose images are orthonormal; a new one takes the
                                              // place of the oldest, number by number after that has been used
  std::array<Point, most_remembered> image_;  // the decrease of the change by each step
  std::size_t remembered_ = 0;
  std::size_t newest_ = 0;
  Start start_;                 // of the next sweep
  Taken taken_;                 // by the last sweep
  long restarts_in_a_row_ = 0;  // consecutive restarts
  double predicted_square_ = 0.0;
  AlignedDoubles difference_;     // working memory
  std::vector<Impulse<D>> best_;  // impulses with the least residual so far
  bool leapt_ = false;            // whether the search leapt since velocities were last corrected
  long next_check_ = 0;           // sweep before which the residual is not computed again
  std::vector<Body<D>> scratch_;
};

}  // namespace repose::contact_dynamics
