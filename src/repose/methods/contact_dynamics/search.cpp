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

constexpr std::size_t line = 8;  // doubles

void add(AlignedDoubles& to, double factor, const AlignedDoubles& other) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += other[k] * factor;
}

void scale(AlignedDoubles& motions, double factor) {
  for (auto& motion : motions) motion *= factor;
}

/// The number of velocity components of a body.
template <int D>
constexpr std::size_t motions_of = D == 2 ? 3 : 6;

/// Calls visit(index, velocity) for each velocity component of body k.
template <int D, class OfBody, class Visit>
void for_each_motion(OfBody& body, std::size_t k, const Visit& visit) {
  std::size_t place = k * motions_of<D>;
  for (int d = 0; d < D; ++d) visit(place++, body.velocity[d]);
  if constexpr (D == 2) {
    visit(place, body.rim_velocity);
  } else {
    for (int d = 0; d < D; ++d) visit(place++, body.rim_velocity[d]);
  }
}

}  // namespace

template <class Impulses>
void Point<Impulses>::add(double factor, const Point& other) {
  for (std::size_t k = 0; k < impulses.size(); ++k) impulses[k] += other.impulses[k] * factor;
  contact_dynamics::add(motions, factor, other.motions);
}

/// The scalar product of two steps in the measure of (twice) the kinetic energy. It uses as many partial sums as a
/// cache line has numbers, because a single sum would wait for itself.
template <int D, class Sweeps>
double Search<D, Sweeps>::product(const Step& a, const Step& b) const {
  std::array<double, line> sum{};
  for (std::size_t k = 0; k < weights_.size(); k += line) {
    for (std::size_t l = 0; l < line; ++l) sum[l] += weights_[k + l] * (a.motions[k + l] * b.motions[k + l]);
  }
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

/// Starts from the velocities that belong to the impulses.
template <int D, class Sweeps>
void Search<D, Sweeps>::begin(Problem<D>& problem) {
  add_impulses(problem, problem.bodies);
  sweeps_.begin(problem);
  yields_ = std::any_of(problem.contacts.begin(), problem.contacts.end(),
                        [](const auto& c) { return std::isinf(c.friction); });
  const auto bodies = problem.bodies.size();
  const auto motions = (bodies * motions_of<D> + line - 1) / line * line;
  weights_.assign(motions, 0.0);
  base_.motions.assign(motions, 0.0);
  for (std::size_t k = 0; k < bodies; ++k) {
    const auto& body = problem.bodies[k];
    const double mass = body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0;
    for_each_motion<D>(body, k, [&](std::size_t place, double velocity) {
      const bool turning = place % motions_of<D> >= D;
      weights_[place] = turning ? mass / inverse_inertia_factor<D> : mass;
      base_.motions[place] = velocity;
    });
  }
  base_.impulses = sweeps_.impulses(problem);
  predicted_.impulses.assign(base_.impulses.size(), {});
  predicted_.motions.assign(motions, 0.0);
  change_ = predicted_;
  for (auto* points : {&step_, &image_}) {
    for (auto& point : *points) point.impulses.resize(base_.impulses.size());
  }
  remembered_ = 0;
  restarts_in_a_row_ = 0;
  predicted_square_ = 0.0;
  leapt_ = false;
  next_check_ = 0;
}

/// Does one sweep in both directions. From some sweep on, only a fraction of the change of infinite friction is
/// applied.
template <int D, class Sweeps>
void Search<D, Sweeps>::sweep(Problem<D>& problem, long sweeps) {
  const auto pressed = [&](std::size_t place) { return sweeps_.pressed(problem, place); };
  const bool partly = yields_ && sweeps >= sweeps_before_yielding;
  if (partly && sweeps == sweeps_before_yielding) yielding_.begin(sweeps_.slots(problem), pressed);
  sweeps_.sweep_both_ways(problem, partly ? yielding_.fractions() : nullptr, change_.impulses);
  if (partly) yielding_.follow(pressed);
}

/// Sets the change of the velocities in the last sweep, which began at the base plus the predicted change.
template <int D, class Sweeps>
void Search<D, Sweeps>::take_change(const Problem<D>& problem) {
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double now) {
      change_.motions[place] = now - (base_.motions[place] + predicted_.motions[place]);
    });
  }
}

/// The true residual costs half a sweep. So it is computed when the velocities hardly change, at growing intervals, and
/// at regular intervals late in the search.
template <int D, class Sweeps>
bool Search<D, Sweeps>::check_is_due(const Solution& solution, double enough) const {
  if (solution.sweeps >= settings_.most_sweeps) return true;
  if (solution.sweeps >= sweeps_before_watching && solution.sweeps % sweeps_per_watch == 0) return true;
  if (solution.sweeps < next_check_) return false;
  double fastest = 0.0;
  for (const double change : change_.motions) fastest = std::max(fastest, std::fabs(change));
  return fastest <= enough;
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
void Search<D, Sweeps>::restart(double square) {
  base_.add(1.0, predicted_);
  std::swap(predicted_, change_);
  predicted_square_ = square;
  remembered_ = 0;
  ++restarts_in_a_row_;
}

/// The number of sweeps for which the change will stay about the same. A change with almost no velocities lasts until
/// the velocities outgrow it. A change that does not shrink and equals that of the previous sweep lasts until the
/// difference between the two has grown to the same size.
template <int D, class Sweeps>
double Search<D, Sweeps>::drift(const Problem<D>& problem, double square) {
  double apart = 0.0;
  sweeps_.for_each(problem, change_.impulses,
                   [&](const auto& c, const auto&, const auto& change) { apart += separate_energy(c, change); });
  double sweeps = std::sqrt(apart / square);
  if (!(sweeps > drift_over_velocity)) sweeps = 0.0;
  if (restarts_in_a_row_ < sweeps_per_check) return sweeps;
  difference_ = change_.impulses;
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] += predicted_.impulses[k] * -1.0;
  double differing = 0.0;
  sweeps_.for_each(problem, difference_,
                   [&](const auto& c, const auto&, const auto& change) { differing += separate_energy(c, change); });
  return std::max(sweeps, std::sqrt(apart / differing));
}

/// Leaps over a drift, at most to the first contact that ends it. Returns false without a drift.
template <int D, class Sweeps>
bool Search<D, Sweeps>::leap(const Problem<D>& problem) {
  const double square = product(change_, change_);
  double length = drift(problem, square);
  if (!(length > shortest_leap)) return false;
  sweeps_.for_each(problem, change_.impulses, [&](const auto& c, const auto& impulse, const auto& change) {
    length = std::min(length, largest_multiple(c, impulse, change));
  });
  if (!(length > shortest_leap) || !std::isfinite(length)) return false;
  restart(square);
  base_.add(length, predicted_);
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
void Search<D, Sweeps>::combine() {
  const double square = product(change_, change_);
  if (!(square <= predicted_square_)) {
    restart(square);
    return;
  }
  const auto slot = (newest_ + 1) % image_.size();
  auto& step = step_[slot];
  auto& image = image_[slot];
  step.motions = predicted_.motions;
  image.motions = predicted_.motions;
  add(image.motions, -1.0, change_.motions);
  Combination combination;
  for (std::size_t back = 0; back < remembered_; ++back) {
    const auto other = (newest_ + image_.size() - back) % image_.size();
    const double along = product(image, image_[other]);
    add(image.motions, -along, image_[other].motions);
    add(step.motions, -along, step_[other].motions);
    combination.others[back] = other;
    combination.along_others[back] = along;
  }
  const double size = std::sqrt(product(image, image));
  if (!(size > 1e-12 * std::sqrt(predicted_square_))) {
    restart(square);
    return;
  }
  combination.factor = 1.0 / size;
  scale(step.motions, combination.factor);
  scale(image.motions, combination.factor);
  combination.along = product(predicted_, image);
  add(base_.motions, combination.along, step.motions);
  add(predicted_.motions, -combination.along, image.motions);
  combination.slot = slot;
  static_assert(most_remembered == 2);
  if (remembered_ == 0) combine_impulses<0>(combination);
  if (remembered_ == 1) combine_impulses<1>(combination);
  if (remembered_ == 2) combine_impulses<2>(combination);
  predicted_square_ = product(predicted_, predicted_);
  newest_ = slot;
  restarts_in_a_row_ = 0;
  remembered_ = std::min(remembered_ + 1, most_remembered);
}

/// Applies the combination to the impulses, in one pass because memory access dominates the cost.
template <int D, class Sweeps>
template <std::size_t Others>
void Search<D, Sweeps>::combine_impulses(const Combination& by) {
  auto* __restrict to_step = step_[by.slot].impulses.data();
  auto* __restrict to_image = image_[by.slot].impulses.data();
  auto* __restrict base = base_.impulses.data();
  auto* __restrict predicted = predicted_.impulses.data();
  const auto* __restrict change = change_.impulses.data();
  std::array<decltype(change), Others> steps;
  std::array<decltype(change), Others> images;
  for (std::size_t back = 0; back < Others; ++back) {
    steps[back] = step_[by.others[back]].impulses.data();
    images[back] = image_[by.others[back]].impulses.data();
  }
  const auto count = predicted_.impulses.size();
  for (std::size_t k = 0; k < count; ++k) {
    auto step = predicted[k];
    auto image = predicted[k];
    image += change[k] * -1.0;
    for (std::size_t back = 0; back < Others; ++back) {
      image += images[back][k] * -by.along_others[back];
      step += steps[back][k] * -by.along_others[back];
    }
    step = step * by.factor;
    image = image * by.factor;
    base[k] += step * by.along;
    predicted[k] += image * -by.along;
    to_step[k] = step;
    to_image[k] = image;
  }
}

/// Sets the problem to the base plus the predicted change.
template <int D, class Sweeps>
void Search<D, Sweeps>::apply_prediction(Problem<D>& problem) {
  sweeps_.set(base_.impulses, predicted_.impulses, problem);
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double& velocity) {
      velocity = base_.motions[place] + predicted_.motions[place];
    });
  }
}

template <int D, class Sweeps>
Solution Search<D, Sweeps>::solve(Problem<D>& problem) {
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
        if (solution.sweeps % sweeps_per_check != 0 || !leap(problem)) combine();
        apply_prediction(problem);
      } else {
        add(base_.motions, 1.0, change_.motions);
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
