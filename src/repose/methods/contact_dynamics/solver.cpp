// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/solver.hpp"

#include "repose/methods/contact_dynamics/relax.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"
#include "repose/methods/contact_dynamics/self_stress.hpp"

#include <algorithm>
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

/// Where friction is high, sweeps can end in a cycle: a contact opens, its friction is gone, it is pressed together
/// again. From this sweep on the friction of a contact goes only part of the way, less at every turn.
constexpr long sweeps_before_yielding = 100;
constexpr float share_at_turn = 0.8f;
constexpr float share_at_no_turn = 1.005f;

/// The friction of all contacts goes wholly to what solves the contact.
struct Wholly {
  static constexpr bool partly = false;
};
struct Partly {
  static constexpr bool partly = true;
  Yield* of;
};

/// Solves each contact as if the others held still, first to last and back, all in the mirrored order, so that the map
/// is symmetric. Normal and tangential parts of a disc or sphere act on each other through the friction limit alone.
/// Adds up what was changed: as the difference of the impulses it would drown in their rounding.
template <bool Rolling, int D, class Bodies, class Way>
void sweep_to_and_fro(const Bodies& among, const Way& way, Problem<D>& problem, std::vector<Impulse<D>>& changes) {
  auto* bodies = problem.bodies.data();
  const auto count = problem.contacts.size();
  const auto share = [&](std::size_t k) {
    if constexpr (Way::partly) return static_cast<double>(way.of[k].share);
    return 1.0;
  };
  for (std::size_t k = 0; k < count; ++k) {
    auto& c = problem.contacts[k];
    Impulse<D> change;
    relax_translation(among, share(k), c, bodies[c.first], bodies[c.second], change);
    if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], change);
    changes[k] = change;
  }
  for (std::size_t k = count; k-- > 0;) {
    auto& c = problem.contacts[k];
    if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], changes[k]);
    relax_translation(among, share(k), c, bodies[c.first], bodies[c.second], changes[k]);
    if constexpr (Way::partly) way.of[k].take(c.impulse.normal > 0.0);
  }
}

template <int D>
void sweep_to_and_fro(Problem<D>& problem, std::vector<Yield>* yield, std::vector<Impulse<D>>& changes) {
  const auto sweep = [&](const auto& among, const auto& way) {
    problem.rolling ? sweep_to_and_fro<true>(among, way, problem, changes)
                    : sweep_to_and_fro<false>(among, way, problem, changes);
  };
  const auto either = [&](const auto& among) { yield ? sweep(among, Partly{yield->data()}) : sweep(among, Wholly{}); };
  problem.pistons ? either(problem.with_pistons()) : either(FreeBodies{});
}

}  // namespace

void Yield::take(bool is_pressed) {
  share = is_pressed == pressed ? std::min(1.0f, share * share_at_no_turn) : share * share_at_turn;
  pressed = is_pressed;
}

template <int D>
void Point<D>::add(double share, const Point& other) {
  for (std::size_t k = 0; k < impulses.size(); ++k) impulses[k] += other.impulses[k] * share;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    motions[k].velocity += other.motions[k].velocity * share;
    motions[k].rim_velocity += other.motions[k].rim_velocity * share;
  }
}

template <int D>
void Point<D>::scale(double factor) {
  for (auto& impulse : impulses) impulse = impulse * factor;
  for (auto& motion : motions) {
    motion.velocity *= factor;
    motion.rim_velocity *= factor;
  }
}

/// Twice the kinetic energy that the two have in common.
template <int D>
double Solver<D>::product(const Point<D>& a, const Point<D>& b) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    const auto& u = a.motions[k];
    const auto& v = b.motions[k];
    sum +=
        masses_[k] * (dot(u.velocity, v.velocity) + inner(u.rim_velocity, v.rim_velocity) / inverse_inertia_factor<D>);
  }
  return sum;
}

template <int D>
void Solver<D>::begin(const Problem<D>& problem) {
  const auto contacts = problem.contacts.size();
  const auto bodies = problem.bodies.size();
  masses_.clear();
  base_.impulses.clear();
  base_.motions.clear();
  for (const auto& body : problem.bodies) {
    masses_.push_back(body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0);
    base_.motions.push_back({body.velocity, body.rim_velocity});
  }
  for (const auto& c : problem.contacts) base_.impulses.push_back(c.impulse);
  foretold_.reset(contacts, bodies);
  change_.reset(contacts, bodies);
  remembered_ = 0;
  foretold_square_ = 0.0;
  next_look_ = 0;
}

/// From here on friction follows partly.
template <int D>
void Solver<D>::begin_yielding(const Problem<D>& problem) {
  yield_.clear();
  for (const auto& c : problem.contacts) yield_.push_back({1.0f, c.impulse.normal > 0.0});
}

/// How the last sweeps changed the velocities; they began where the change was foretold from.
template <int D>
void Solver<D>::take_change(const Problem<D>& problem) {
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    const auto& now = problem.bodies[k];
    const auto& base = base_.motions[k];
    const auto& foretold = foretold_.motions[k];
    change_.motions[k].velocity = now.velocity - (base.velocity + foretold.velocity);
    change_.motions[k].rim_velocity = now.rim_velocity - (base.rim_velocity + foretold.rim_velocity);
  }
}

/// The true residual costs half a sweep: looked at when the velocities hardly change, ever less often, and now and then.
template <int D>
bool Solver<D>::look_is_due(const Solution& solution, double enough) const {
  if (solution.sweeps >= settings_.most_sweeps) return true;
  if (solution.sweeps >= sweeps_before_watching && solution.sweeps % sweeps_per_watch == 0) return true;
  if (solution.sweeps < next_look_) return false;
  double fastest = 0.0;
  for (const auto& motion : change_.motions) {
    fastest = std::max(fastest, squared(motion.velocity) + repose::squared(motion.rim_velocity));
  }
  return fastest <= enough * enough;
}

/// Whether these impulses are what was wanted; keeps them if they are the best so far.
template <int D>
bool Solver<D>::small_enough(const Problem<D>& problem, Solution& solution) {
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
template <int D>
void Solver<D>::start_anew(double square) {
  base_.add(1.0, foretold_);
  std::swap(foretold_, change_);
  foretold_square_ = square;
  remembered_ = 0;
}

/// Leaps over a drift to the first contact that ends it, but only so far that the velocities which the change makes
/// nevertheless do not outgrow it. False where there is no drift.
template <int D>
bool Solver<D>::leap(const Problem<D>& problem) {
  const double square = product(change_, change_);
  const double apart = energy_apart(problem.contacts, change_.impulses);
  if (!(apart > drift_over_velocity * drift_over_velocity * square)) return false;
  const double room = std::min(room_along(problem.contacts, change_.impulses), std::sqrt(apart / square));
  if (!(room > shortest_leap) || !std::isfinite(room)) return false;
  start_anew(square);
  base_.add(room, foretold_);
  return true;
}

/// From what the last step changed against what was foretold: a base where the least change is to be expected.
template <int D>
void Solver<D>::combine() {
  const double square = product(change_, change_);
  if (!settings_.accelerated || !(square <= foretold_square_)) {
    start_anew(square);
    return;
  }
  const auto slot = (newest_ + 1) % image_.size();
  auto& step = step_[slot];
  auto& image = image_[slot];
  step = foretold_;
  image = foretold_;
  image.add(-1.0, change_);
  for (std::size_t back = 0; back < remembered_; ++back) {
    const auto other = (newest_ + image_.size() - back) % image_.size();
    const double along = product(image, image_[other]);
    image.add(-along, image_[other]);
    step.add(-along, step_[other]);
  }
  const double size = std::sqrt(product(image, image));
  if (!(size > 1e-12 * std::sqrt(foretold_square_))) {
    start_anew(square);
    return;
  }
  step.scale(1.0 / size);
  image.scale(1.0 / size);
  const double along = product(foretold_, image);
  base_.add(along, step);
  foretold_.add(-along, image);
  foretold_square_ = product(foretold_, foretold_);
  newest_ = slot;
  remembered_ = std::min(remembered_ + 1, most_remembered);
}

/// To where the foretold change leads.
template <int D>
void Solver<D>::go_on(Problem<D>& problem) const {
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    auto& impulse = problem.contacts[k].impulse;
    impulse = base_.impulses[k];
    impulse += foretold_.impulses[k];
  }
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    auto& body = problem.bodies[k];
    body.velocity = base_.motions[k].velocity + foretold_.motions[k].velocity;
    body.rim_velocity = base_.motions[k].rim_velocity + foretold_.motions[k].rim_velocity;
  }
}

template <int D>
Solution Solver<D>::solve(Problem<D>& problem) {
  Solution solution;
  problem.bodies = problem.free;
  if (problem.contacts.empty()) return solution;
  best_.clear();
  solution.residual = std::numeric_limits<double>::infinity();
  if (!small_enough(problem, solution) && settings_.most_sweeps > 0) {
    const double enough = settings_.tolerance * velocity_scale(problem);
    add_impulses(problem, problem.bodies);
    begin(problem);
    for (;;) {
      const bool partly = solution.sweeps >= sweeps_before_yielding;
      if (solution.sweeps == sweeps_before_yielding) begin_yielding(problem);
      sweep_to_and_fro(problem, partly ? &yield_ : nullptr, change_.impulses);
      ++solution.sweeps;
      take_change(problem);
      if (look_is_due(solution, enough) && small_enough(problem, solution)) break;
      if (solution.sweeps >= settings_.most_sweeps) break;
      if (!settings_.accelerated || solution.sweeps % sweeps_per_look != 0 || !leap(problem)) combine();
      go_on(problem);
    }
    for (std::size_t k = 0; k < best_.size(); ++k) problem.contacts[k].impulse = best_[k];
  }
  add_impulses(problem, problem.bodies);
  solution.converged = solution.residual <= settings_.tolerance;
  return solution;
}

template struct Point<2>;
template struct Point<3>;
template class Solver<2>;
template class Solver<3>;

}  // namespace repose::contact_dynamics
