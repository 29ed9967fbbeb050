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

/// Whether impulses drift is looked at now and then. They do where their change makes next to no velocities, far less
/// than in the slowest motion of a long chain, which is a matter for conjugate residuals; a leap is to be worth it.
constexpr long sweeps_per_look = 4;
constexpr double drift_over_velocity = 1e4;
constexpr double shortest_leap = 8.0;

/// What does not converge ends with the best that was seen at one of these looks.
constexpr long sweeps_before_watching = 200;
constexpr long sweeps_per_watch = 20;

/// Infinite friction goes wholly to what solves its contact until this sweep.
constexpr long sweeps_before_yielding = 100;

constexpr std::size_t line = 8;  // doubles

void add(AlignedDoubles& to, double share, const AlignedDoubles& other) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += other[k] * share;
}

void scale(AlignedDoubles& motions, double factor) {
  for (auto& motion : motions) motion *= factor;
}

/// How many motions a body has.
template <int D>
constexpr std::size_t motions_of = D == 2 ? 3 : 6;

/// Calls with the place of each motion and the velocity of the body that it is.
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
void Point<Impulses>::add(double share, const Point& other) {
  for (std::size_t k = 0; k < impulses.size(); ++k) impulses[k] += other.impulses[k] * share;
  contact_dynamics::add(motions, share, other.motions);
}

/// Twice the kinetic energy that the two have in common. As many sums as a cache line has numbers, for one would have
/// to wait for itself.
template <int D, class Sweeps>
double Search<D, Sweeps>::product(const Step& a, const Step& b) const {
  std::array<double, line> sum{};
  for (std::size_t k = 0; k < weights_.size(); k += line) {
    for (std::size_t l = 0; l < line; ++l) sum[l] += weights_[k + l] * (a.motions[k + l] * b.motions[k + l]);
  }
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

/// From velocities that go with the impulses.
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
  foretold_.impulses.assign(base_.impulses.size(), {});
  foretold_.motions.assign(motions, 0.0);
  change_ = foretold_;
  for (auto* points : {&step_, &image_}) {
    for (auto& point : *points) point.impulses.resize(base_.impulses.size());
  }
  remembered_ = 0;
  anew_in_a_row_ = 0;
  foretold_square_ = 0.0;
  leapt_ = false;
  next_look_ = 0;
}

/// Friction follows partly from some sweep on.
template <int D, class Sweeps>
void Search<D, Sweeps>::sweep(Problem<D>& problem, long sweeps) {
  const auto pressed = [&](std::size_t place) { return sweeps_.pressed(problem, place); };
  const bool partly = yields_ && sweeps >= sweeps_before_yielding;
  if (partly && sweeps == sweeps_before_yielding) yielding_.begin(sweeps_.places(problem), pressed);
  sweeps_.sweep_to_and_fro(problem, partly ? yielding_.shares() : nullptr, change_.impulses);
  if (partly) yielding_.follow(pressed);
}

/// How the last sweeps changed the velocities; they began where the change was foretold from.
template <int D, class Sweeps>
void Search<D, Sweeps>::take_change(const Problem<D>& problem) {
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double now) {
      change_.motions[place] = now - (base_.motions[place] + foretold_.motions[place]);
    });
  }
}

/// The true residual costs half a sweep: looked at when the velocities hardly change, ever less often, and now and
/// then.
template <int D, class Sweeps>
bool Search<D, Sweeps>::look_is_due(const Solution& solution, double enough) const {
  if (solution.sweeps >= settings_.most_sweeps) return true;
  if (solution.sweeps >= sweeps_before_watching && solution.sweeps % sweeps_per_watch == 0) return true;
  if (solution.sweeps < next_look_) return false;
  double fastest = 0.0;
  for (const double change : change_.motions) fastest = std::max(fastest, std::fabs(change));
  return fastest <= enough;
}

/// Whether these impulses are what was wanted; keeps them if they are the best so far.
template <int D, class Sweeps>
bool Search<D, Sweeps>::small_enough(const Problem<D>& problem, Solution& solution) {
  const double now = residual(problem, scratch_).worst();
  next_look_ = solution.sweeps + 2 + solution.sweeps / 16;
  if (now < solution.residual) {
    solution.residual = now;
    best_.clear();
    for (const auto& c : problem.contacts) best_.push_back(c.impulse);
  }
  return now <= settings_.tolerance;
}

/// From where the last sweeps ended, without what is remembered.
template <int D, class Sweeps>
void Search<D, Sweeps>::start_anew(double square) {
  base_.add(1.0, foretold_);
  std::swap(foretold_, change_);
  foretold_square_ = square;
  remembered_ = 0;
  ++anew_in_a_row_;
}

/// For how many sweeps the change will be much the same: where it makes next to no velocities, until those outgrow it;
/// where it does not shrink and is that of the sweep before, until what differs adds up to as much.
template <int D, class Sweeps>
double Search<D, Sweeps>::drift(const Problem<D>& problem, double square) {
  double apart = 0.0;
  sweeps_.for_each(problem, change_.impulses,
                   [&](const auto& c, const auto&, const auto& change) { apart += energy_apart(c, change); });
  double sweeps = std::sqrt(apart / square);
  if (!(sweeps > drift_over_velocity)) sweeps = 0.0;
  if (anew_in_a_row_ < sweeps_per_look) return sweeps;
  difference_ = change_.impulses;
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] += foretold_.impulses[k] * -1.0;
  double differing = 0.0;
  sweeps_.for_each(problem, difference_,
                   [&](const auto& c, const auto&, const auto& change) { differing += energy_apart(c, change); });
  return std::max(sweeps, std::sqrt(apart / differing));
}

/// Leaps over a drift, at most to the first contact that ends it. False where there is none.
template <int D, class Sweeps>
bool Search<D, Sweeps>::leap(const Problem<D>& problem) {
  const double square = product(change_, change_);
  double room = drift(problem, square);
  if (!(room > shortest_leap)) return false;
  sweeps_.for_each(problem, change_.impulses, [&](const auto& c, const auto& impulse, const auto& change) {
    room = std::min(room, room_along(c, impulse, change));
  });
  if (!(room > shortest_leap) || !std::isfinite(room)) return false;
  start_anew(square);
  base_.add(room, foretold_);
  anew_in_a_row_ = 0;
  leapt_ = true;
  return true;
}

/// Leaps magnify the rounding of the velocities that are carried along: gives them those of the impulses.
template <int D, class Sweeps>
void Search<D, Sweeps>::correct_velocities(const Problem<D>& problem) {
  for (std::size_t k = 0; k < scratch_.size(); ++k) {
    for_each_motion<D>(scratch_[k], k, [&](std::size_t place, double right) { base_.motions[place] += right; });
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double now) { base_.motions[place] -= now; });
  }
  leapt_ = false;
}

/// From what the last step changed against what was foretold: a base where the least change is to be expected.
/// Velocities decide; impulses follow.
template <int D, class Sweeps>
void Search<D, Sweeps>::combine() {
  const double square = product(change_, change_);
  if (!(square <= foretold_square_)) {
    start_anew(square);
    return;
  }
  const auto slot = (newest_ + 1) % image_.size();
  auto& step = step_[slot];
  auto& image = image_[slot];
  step.motions = foretold_.motions;
  image.motions = foretold_.motions;
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
  if (!(size > 1e-12 * std::sqrt(foretold_square_))) {
    start_anew(square);
    return;
  }
  combination.factor = 1.0 / size;
  scale(step.motions, combination.factor);
  scale(image.motions, combination.factor);
  combination.along = product(foretold_, image);
  add(base_.motions, combination.along, step.motions);
  add(foretold_.motions, -combination.along, image.motions);
  combination.slot = slot;
  static_assert(most_remembered == 2);
  if (remembered_ == 0) combine_impulses<0>(combination);
  if (remembered_ == 1) combine_impulses<1>(combination);
  if (remembered_ == 2) combine_impulses<2>(combination);
  foretold_square_ = product(foretold_, foretold_);
  newest_ = slot;
  anew_in_a_row_ = 0;
  remembered_ = std::min(remembered_ + 1, most_remembered);
}

/// The same with the impulses, all at once: memory is what it costs.
template <int D, class Sweeps>
template <std::size_t Others>
void Search<D, Sweeps>::combine_impulses(const Combination& by) {
  auto* __restrict to_step = step_[by.slot].impulses.data();
  auto* __restrict to_image = image_[by.slot].impulses.data();
  auto* __restrict base = base_.impulses.data();
  auto* __restrict foretold = foretold_.impulses.data();
  const auto* __restrict change = change_.impulses.data();
  std::array<decltype(change), Others> steps;
  std::array<decltype(change), Others> images;
  for (std::size_t back = 0; back < Others; ++back) {
    steps[back] = step_[by.others[back]].impulses.data();
    images[back] = image_[by.others[back]].impulses.data();
  }
  const auto count = foretold_.impulses.size();
  for (std::size_t k = 0; k < count; ++k) {
    auto step = foretold[k];
    auto image = foretold[k];
    image += change[k] * -1.0;
    for (std::size_t back = 0; back < Others; ++back) {
      image += images[back][k] * -by.along_others[back];
      step += steps[back][k] * -by.along_others[back];
    }
    step = step * by.factor;
    image = image * by.factor;
    base[k] += step * by.along;
    foretold[k] += image * -by.along;
    to_step[k] = step;
    to_image[k] = image;
  }
}

/// To where the foretold change leads.
template <int D, class Sweeps>
void Search<D, Sweeps>::go_on(Problem<D>& problem) {
  sweeps_.set(base_.impulses, foretold_.impulses, problem);
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    for_each_motion<D>(problem.bodies[k], k, [&](std::size_t place, double& velocity) {
      velocity = base_.motions[place] + foretold_.motions[place];
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
      if (look_is_due(solution, enough)) {
        sweeps_.store(problem);
        if (small_enough(problem, solution)) break;
        if (leapt_) correct_velocities(problem);
      }
      if (solution.sweeps >= settings_.most_sweeps) break;
      if (settings_.accelerated) {
        if (solution.sweeps % sweeps_per_look != 0 || !leap(problem)) combine();
        go_on(problem);
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
