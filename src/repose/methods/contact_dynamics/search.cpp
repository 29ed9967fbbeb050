// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/search.hpp"

#include "repose/methods/contact_dynamics/line_sweeps.hpp"
#include "repose/methods/contact_dynamics/pack_sweeps.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"
#include "repose/methods/contact_dynamics/self_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace repose::contact_dynamics {

namespace {

/// Every few sweeps the search checks whether the impulses drift. They drift if their change produces almost no
/// velocities, far less than in the slowest motion of a long chain, which conjugate residuals handle. A leap shorter
/// than the last constant is not worth its cost.
constexpr long sweeps_per_check = 4;
constexpr double drift_over_velocity = 1e4;
constexpr double shortest_leap = 8.0;

/// From some sweep on, the residual is computed at regular intervals; a problem that does not converge ends with the
/// best impulses found at one of these checks.
constexpr long sweeps_before_watching = 200;
constexpr long sweeps_per_watch = 20;

/// Until this sweep the whole change of infinite friction is applied.
constexpr long sweeps_before_yielding = 100;

/// Calls visit(index, velocity) for each velocity component of body k.
template <int D, class OfBody, class Visit>
void for_each_motion(OfBody& body, std::size_t k, const Visit& visit) {
  std::size_t place = k * Motions<D>::each;
  for (int d = 0; d < D; ++d) visit(place++, body.velocity[d]);
  if constexpr (D == 2) {
    visit(place, body.rim_velocity);
  } else {
    for (int d = 0; d < D; ++d) visit(place++, body.rim_velocity[d]);
  }
}

}  // namespace

/// The numbers that a start of a sweep combines: impulses or motions.
template <int D, class Sweeps>
History Search<D, Sweeps>::history(AlignedDoubles Point::*numbers) {
  History all{(base_.*numbers).data(), (predicted_.*numbers).data(), (change_.*numbers).data()};
  const auto next = (newest_ + 1) % image_.size();
  all.step = (step_[next].*numbers).data();
  all.image = (image_[next].*numbers).data();
  for (std::size_t ago = 0; ago < most_remembered; ++ago) {
    const auto slot = (newest_ + image_.size() - ago) % image_.size();
    all.steps[ago] = (step_[slot].*numbers).data();
    all.images[ago] = (image_[slot].*numbers).data();
  }
  return all;
}

template <int D, class Sweeps>
Motions<D> Search<D, Sweeps>::motions(Problem<D>& problem) {
  return {problem.bodies.data(), problem.bodies.size(), weights_.data(), history(&Point::motions)};
}

/// Calls piece(range) for each part of the motions, and adds the results in the order of the parts.
template <int D, class Sweeps>
template <class Piece>
Taken Search<D, Sweeps>::over_motions(const Piece& piece) {
  constexpr auto block = Motions<D>::block;
  const auto parts = of_parts_.size();
  const auto add = [&](std::size_t part) {
    const auto blocks = range_of(weights_.size() / block, static_cast<int>(part), static_cast<int>(parts));
    of_parts_[part].taken = piece(Range{blocks.begin * block, blocks.end * block});
  };
  if (parts == 1) {
    add(0);
  } else {
    team_->run([&](int member) {
      const auto own = range_of(parts, member, team_->size());
      for (auto part = own.begin; part < own.end; ++part) add(part);
    });
  }
  Taken all = of_parts_[0].taken;
  for (std::size_t part = 1; part < parts; ++part) {
    const auto& taken = of_parts_[part].taken;
    all.square += taken.square;
    all.along += taken.along;
    all.fastest = std::max(all.fastest, taken.fastest);
  }
  return all;
}

/// Starts from the velocities that belong to the impulses.
template <int D, class Sweeps>
void Search<D, Sweeps>::begin(Problem<D>& problem) {
  add_impulses(problem, problem.bodies);
  sweeps_.begin(problem);
  yields_ = std::any_of(problem.contacts.begin(), problem.contacts.end(),
                        [](const auto& c) { return std::isinf(c.friction); });
  const auto bodies = problem.bodies.size();
  constexpr auto block = Motions<D>::block;
  const auto motions = (bodies * Motions<D>::each + block - 1) / block * block;
  of_parts_.resize(sweeps_.parts(problem));
  weights_.assign(motions, 0.0);
  base_.motions.assign(motions, 0.0);
  for (std::size_t k = 0; k < bodies; ++k) {
    const auto& body = problem.bodies[k];
    const double mass = body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0;
    for_each_motion<D>(body, k, [&](std::size_t place, double velocity) {
      const bool turning = place % Motions<D>::each >= D;
      weights_[place] = turning ? mass / inverse_inertia_factor<D> : mass;
      base_.motions[place] = velocity;
    });
  }
  base_.impulses = sweeps_.impulses(problem);
  for (auto* point : {&predicted_, &change_}) {
    point->impulses.assign(base_.impulses.size(), 0.0);
    point->motions.assign(motions, 0.0);
  }
  for (auto* points : {&step_, &image_}) {
    for (auto& point : *points) {
      point.impulses.resize(base_.impulses.size());
      point.motions.resize(motions);
    }
  }
  start_ = {};
  remembered_ = 0;
  restarts_in_a_row_ = 0;
  predicted_square_ = 0.0;
  leapt_ = false;
  next_check_ = 0;
}

/// Goes to where the search starts the sweep, and does one sweep in both directions. From some sweep on, only a
/// fraction of the change of infinite friction is applied.
template <int D, class Sweeps>
void Search<D, Sweeps>::sweep(Problem<D>& problem, long sweeps) {
  const auto pressed = [&](std::size_t place) { return sweeps_.pressed(problem, place); };
  const bool partly = yields_ && sweeps >= sweeps_before_yielding;
  auto impulses = history(&Point::impulses);
  if (!settings_.accelerated) impulses.change = nullptr;
  if (start_.kind != Start::Kind::here) {
    const auto of = motions(problem);
    predicted_square_ = over_motions([&](Range range) {
                          return Taken{kernels_.template motions<D>().start(of, start_, range), 0.0, 0.0};
                        }).square;
  }
  auto start = start_;
  if (partly && sweeps == sweeps_before_yielding) {
    sweeps_.set(problem, start, impulses, kernels_);
    start.kind = Start::Kind::here;
    yielding_.begin(sweeps_.slots(problem), pressed);
  }
  sweeps_.sweep_both_ways(problem, partly ? yielding_.fractions() : nullptr, start, impulses, kernels_, *team_);
  if (start_.kind == Start::Kind::combine) {
    newest_ = (newest_ + 1) % image_.size();
    remembered_ = std::min(remembered_ + 1, most_remembered);
  }
  if (partly) yielding_.follow(pressed);
}

/// Takes the change of the velocities in the last sweep.
template <int D, class Sweeps>
void Search<D, Sweeps>::take_change(Problem<D>& problem) {
  const auto& kernels = kernels_.template motions<D>();
  const auto of = motions(problem);
  taken_ = over_motions([&](Range range) {
    return settings_.accelerated ? kernels.take(of, remembered_ > 0, range)
                                 : Taken{0.0, 0.0, kernels.follow(of, range)};
  });
}

/// The true residual costs half a sweep. So it is computed when the velocities hardly change, at growing intervals, and
/// at regular intervals late in the search.
template <int D, class Sweeps>
bool Search<D, Sweeps>::check_is_due(const Solution& solution, double enough) const {
  if (solution.sweeps >= settings_.most_sweeps) return true;
  if (solution.sweeps >= sweeps_before_watching && solution.sweeps % sweeps_per_watch == 0) return true;
  if (solution.sweeps < next_check_) return false;
  return taken_.fastest <= enough;
}

/// Whether the residual of these impulses is within the tolerance. Keeps them if they are the best so far.
template <int D, class Sweeps>
bool Search<D, Sweeps>::small_enough(const Problem<D>& problem, Solution& solution) {
  const double now = residual(problem, scratch_).worst();
  next_check_ = solution.sweeps + 2 + solution.sweeps / 16;
  if (now < solution.residual) {
    solution.residual = now;
    best_.clear();
    for (const auto& c : problem.contacts) best_.push_back(c.impulse);
  }
  return now <= settings_.tolerance;
}

/// Restarts from the end of the last sweep, without the remembered steps.
template <int D, class Sweeps>
void Search<D, Sweeps>::restart() {
  start_ = {};
  start_.kind = Start::Kind::restart;
  remembered_ = 0;
  ++restarts_in_a_row_;
}

/// The number of sweeps for which the change will stay about the same. A change with almost no velocities lasts until
/// the velocities outgrow it. A change that does not shrink and equals that of the previous sweep lasts until the
/// difference between the two has grown to the same size.
template <int D, class Sweeps>
double Search<D, Sweeps>::drift(const Problem<D>& problem) {
  const double apart = sweeps_.separate_energy(problem, change_.impulses, kernels_);
  double sweeps = std::sqrt(apart / taken_.square);
  if (!(sweeps > drift_over_velocity)) sweeps = 0.0;
  if (restarts_in_a_row_ < sweeps_per_check) return sweeps;
  difference_ = change_.impulses;
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] += predicted_.impulses[k] * -1.0;
  return std::max(sweeps, std::sqrt(apart / sweeps_.separate_energy(problem, difference_, kernels_)));
}

/// Leaps over a drift, at most to the first contact that ends it. Returns false without a drift.
template <int D, class Sweeps>
bool Search<D, Sweeps>::leap(const Problem<D>& problem) {
  double length = drift(problem);
  if (!(length > shortest_leap)) return false;
  sweeps_.for_each(problem, change_.impulses, [&](const auto& c, const auto& impulse, const auto& change) {
    length = std::min(length, largest_multiple(c, impulse, change));
  });
  if (!(length > shortest_leap) || !std::isfinite(length)) return false;
  restart();
  start_.leap = length;
  restarts_in_a_row_ = 0;
  leapt_ = true;
  return true;
}

/// Leaps magnify rounding in the accumulated velocities. This replaces them by the velocities from the impulses.
template <int D, class Sweeps>
void Search<D, Sweeps>::correct_velocities(const Problem<D>& problem) {
  for (std::size_t k = 0; k < scratch_.size(); ++k) {
    for_each_motion<D>(scratch_[k], k, [&](std::size_t place, double right) { base_.motions[place] += right; });
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double now) { base_.motions[place] -= now; });
  }
  leapt_ = false;
}

/// Combines the last step with the remembered ones, from the difference between the predicted and the actual change, to
/// a base with the least predicted change. The velocities determine the coefficients; the impulses follow.
template <int D, class Sweeps>
void Search<D, Sweeps>::combine(Problem<D>& problem) {
  if (!(taken_.square <= predicted_square_)) return restart();
  const auto of = motions(problem);
  const auto product = [&](const Start& projected, With with) {
    return over_motions([&](Range range) {
             return Taken{kernels_.template motions<D>().product(of, projected, with, range), 0.0, 0.0};
           })
        .square;
  };
  Start next;
  next.kind = Start::Kind::combine;
  for (auto& k = next.others; k < remembered_; ++k) {
    next.along_others[k] = k == 0 ? taken_.along : product(next, With::next);
  }
  const double size = std::sqrt(product(next, With::itself));
  if (!(size > 1e-12 * std::sqrt(predicted_square_))) return restart();
  next.factor = 1.0 / size;
  next.along = product(next, With::predicted);
  start_ = next;
  restarts_in_a_row_ = 0;
}

template <int D, class Sweeps>
Solution Search<D, Sweeps>::solve(Problem<D>& problem, Team& team) {
  team_ = &team;
  Solution solution;
  problem.bodies = problem.free;
  if (problem.contacts.empty()) return solution;
  best_.clear();
  solution.residual = std::numeric_limits<double>::infinity();
  if (!small_enough(problem, solution) && settings_.most_sweeps > 0) {
    const double enough = settings_.tolerance * velocity_scale(problem);
    begin(problem);
    for (;;) {
      sweep(problem, solution.sweeps);
      ++solution.sweeps;
      take_change(problem);
      if (check_is_due(solution, enough)) {
        sweeps_.store(problem);
        if (small_enough(problem, solution)) break;
        if (leapt_) correct_velocities(problem);
      }
      if (solution.sweeps >= settings_.most_sweeps) break;
      if (settings_.accelerated) {
        if (solution.sweeps % sweeps_per_check != 0 || !leap(problem)) combine(problem);
      }
    }
    for (std::size_t k = 0; k < best_.size(); ++k) problem.contacts[k].impulse = best_[k];
  }
  add_impulses(problem, problem.bodies);
  solution.converged = solution.residual <= settings_.tolerance;
  return solution;
}

template class Search<2, LineSweeps<2>>;
template class Search<3, LineSweeps<3>>;
template class Search<2, PackSweeps>;

}  // namespace repose::contact_dynamics
