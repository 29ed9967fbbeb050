// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/restitution.hpp"

#include "repose/methods/contact_dynamics/clusters.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"

#include <algorithm>
#include <cmath>

namespace repose::contact_dynamics {

namespace {

/// Impulses with a residual up to this, over the fastest closing velocity, are taken for a solution.
constexpr double solved = 1e-4;

/// Larger impulses than this, over the mass of a contact and the fastest closing velocity, grow because no impulses
/// satisfy the law: their rounding would show in the velocities.
constexpr double largest_impulse = 1e6;

/// A rise of the kinetic energy up to this, over the kinetic energy before, comes from the tolerance of the solver;
/// slightly smaller impulses take it back. A rise of the second size is rounding.
constexpr double small_gain = 1e-3;
constexpr double rounding = 1e-14;

/// The largest s in [0, 1] with square s^2 + linear s + constant <= 0, for a square >= 0; 0 if there is none.
double largest_fraction(double square, double linear, double constant) {
  if (square + linear + constant <= 0.0) return 1.0;
  if (constant > 0.0) return 0.0;
  const double root = std::sqrt(std::max(0.0, linear * linear - 4.0 * square * constant));
  // The larger root, without cancellation for either sign of the linear term.
  const double s = linear > 0.0 ? -2.0 * constant / (linear + root) : (root - linear) / (2.0 * square);
  return std::isfinite(s) ? std::clamp(s, 0.0, 1.0) : 0.0;
}

/// The change of the kinetic energy of a cluster less the work of moving walls on it, if the impulses are those of a
/// base and s times a change: a polynomial in s.
struct Gain {
  double square = 0.0;
  double linear = 0.0;
  double constant = 0.0;
  double before = 0.0;  ///< the kinetic energy before, in the frame of the walls that touch, at most

  double whole() const { return square + linear + constant; }
};

/// The velocities with these impulses.
template <int D>
std::vector<Body<D>> bodies_with(const Problem<D>& problem, const std::vector<Impulse<D>>& impulses) {
  auto bodies = problem.free;
  const auto among = problem.with_pistons();
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    const auto& c = problem.contacts[k];
    among.push(c, impulses[k].normal, impulses[k].tangent, bodies[c.first], bodies[c.second]);
    among.turn(c, impulses[k].roll, bodies[c.first], bodies[c.second]);
  }
  return bodies;
}

/// The gains of the clusters for impulses of a base and s times (the end less the base).
template <int D>
std::vector<Gain> gains_of(const Problem<D>& problem, const Clusters& clusters, const std::vector<Impulse<D>>& base,
                           const std::vector<Impulse<D>>& end) {
  const auto at_base = bodies_with(problem, base);
  const auto at_end = bodies_with(problem, end);
  std::vector<Gain> all(problem.free.size());
  for (std::uint32_t k = 0; k < problem.free.size(); ++k) {
    const auto &free = problem.free[k], &from = at_base[k], &to = at_end[k];
    if (!(free.inverse_mass > 0.0)) continue;
    auto& gain = all[clusters.of_body(k)];
    const auto add = [&](const auto& v, const auto& v_base, const auto& v_end, double mass) {
      const auto change = v_end - v_base;
      gain.square += 0.5 * mass * repose::squared(change);
      gain.linear += mass * inner(v_base, change);
      gain.constant += 0.5 * mass * (repose::squared(v_base) - repose::squared(v));
      gain.before += 0.5 * mass * repose::squared(v);
    };
    add(free.velocity, from.velocity, to.velocity, 1.0 / free.inverse_mass);
    add(free.rim_velocity, from.rim_velocity, to.rim_velocity, 1.0 / (inverse_inertia_factor<D> * free.inverse_mass));
  }
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    const auto& c = problem.contacts[k];
    const auto& wall = problem.free[c.second];
    const bool stands = repose::squared(wall.velocity) == 0.0 && repose::squared(wall.rim_velocity) == 0.0;
    if (wall.inverse_mass > 0.0 || stands) continue;
    auto& gain = all[clusters.of(k)];
    const auto work = [&](const Impulse<D>& p) { return driven_work(c, p, wall); };
    gain.constant -= work(base[k]);
    gain.linear -= work(end[k]) - work(base[k]);
    gain.before += std::fabs(work(end[k]));
  }
  return all;
}

template <int D>
double product(const ContactLine<D>& c, const Impulse<D>& p, const std::vector<Body<D>>& bodies) {
  const auto &a = bodies[c.first], &b = bodies[c.second];
  return p.normal * opening_velocity(c, a, b) + inner(p.tangent, slip_velocity(c, a, b)) +
         inner(p.roll, roll_velocity(c, a, b));
}

template <int D>
class Impact {
 public:
  using Impulses = std::vector<Impulse<D>>;

  Impact(const std::vector<Rebound<D>>& rebounds, Solver<D>& solver, Problem<D>& problem)
      : rebounds_(rebounds),
        solver_(solver),
        problem_(problem),
        clusters_(problem),
        kept_(rebounds.size(), 1.0),
        open_(problem.free.size(), 1),
        full_solved_(problem.free.size(), 0) {
    for (const auto& c : problem_.contacts) plain_.push_back(c.normal_bias);
  }

  ImpactReport solve() {
    report_.impacts = static_cast<long>(rebounds_.size());
    const Impulses none(problem_.contacts.size());
    solve_open();
    full_ = impulses();
    judge();
    for (std::size_t k = 0; k < full_solved_.size(); ++k) full_solved_[k] = lawful_[k];
    close(none, false);
    for (const bool everywhere : {false, true}) {
      if (!any_open()) break;
      reduce(everywhere);
      solve_open();
      judge();
      close(none, everywhere);
    }
    add_impulses(problem_, problem_.bodies);
    for (const double kept : kept_) {
      report_.reduced += kept < 1.0 ? 1 : 0;
      report_.restitution_lost += 1.0 - kept;
    }
    report_.solution.converged = report_.solution.residual <= solved;
    return report_;
  }

 private:
  bool any_open() const {
    return std::any_of(places_.begin(), places_.end(), [&](auto k) { return open_[clusters_.of(k)] != 0; });
  }

  Impulses impulses() const {
    Impulses all;
    for (const auto& c : problem_.contacts) all.push_back(c.impulse);
    return all;
  }

  /// Solves the contacts of the open clusters, from no impulses.
  void solve_open() {
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      problem_.contacts[k].normal_bias = plain_[k];
      problem_.contacts[k].tangent_bias = {};
    }
    for (std::size_t k = 0; k < rebounds_.size(); ++k) {
      if (kept_[k] == 0.0) continue;
      problem_.contacts[rebounds_[k].contact].normal_bias = rebounds_[k].normal_bias;
      problem_.contacts[rebounds_[k].contact].tangent_bias = rebounds_[k].tangent_bias;
    }
    places_.clear();
    Problem<D> part = problem_;
    part.contacts.clear();
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      if (!open_[clusters_.of(k)]) continue;
      problem_.contacts[k].impulse = {};
      part.contacts.push_back(problem_.contacts[k]);
      places_.push_back(k);
    }
    const auto solution = solver_.solve(part);
    report_.solution.sweeps += solution.sweeps;
    report_.contact_sweeps += solution.sweeps * static_cast<long>(places_.size());
    for (std::size_t k = 0; k < places_.size(); ++k) problem_.contacts[places_[k]].impulse = part.contacts[k].impulse;
  }

  /// Finds the open clusters whose impulses obey the law, and the contacts that violate it or supply energy.
  void judge() {
    add_impulses(problem_, problem_.bodies);
    lawful_.assign(problem_.free.size(), 1);
    offends_.assign(problem_.contacts.size(), 0);
    worst_.assign(problem_.free.size(), 0.0);
    for (const auto k : places_) {
      const auto& c = problem_.contacts[k];
      const double residual =
          violation(c, problem_.bodies[c.first], problem_.bodies[c.second]) / problem_.velocity_scale;
      const double work = product(c, c.impulse, problem_.free) + product(c, c.impulse, problem_.bodies);
      const double stress = std::max(c.impulse.normal, magnitude(c.impulse.tangent)) / c.normal_mass;
      const bool obeys = residual <= solved && stress <= largest_impulse * problem_.velocity_scale;
      offends_[k] = !obeys || work > 0.0;
      if (!obeys) lawful_[clusters_.of(k)] = 0;
      worst_[clusters_.of(k)] = std::max(worst_[clusters_.of(k)], obeys ? residual : std::max(residual, solved));
    }
  }

  std::vector<Gain> gains(const Impulses& base, const Impulses& end) const {
    return gains_of(problem_, clusters_, base, end);
  }

  /// Closes the open clusters whose impulses obey the law and create no energy, or all of them if there is no other
  /// choice.
  void close(const Impulses& none, bool all) {
    auto now = impulses();
    const auto from_none = gains(none, now);
    std::vector<char> closes(problem_.free.size(), 0);
    for (std::uint32_t k = 0; k < closes.size(); ++k) {
      if (!open_[k]) continue;
      closes[k] = all || (lawful_[k] && from_none[k].whole() <= small_gain * from_none[k].before);
    }
    for (const auto k : places_) {
      const auto& gain = from_none[clusters_.of(k)];
      if (!closes[clusters_.of(k)] || gain.whole() <= rounding * gain.before) continue;
      now[k] = now[k] * largest_fraction(gain.square, gain.linear, 0.0);
    }
    std::vector<double> fraction(problem_.free.size(), 0.0);
    const auto changes = gains(now, full_);
    for (std::uint32_t k = 0; k < closes.size(); ++k) {
      if (!closes[k] || !full_solved_[k]) continue;
      fraction[k] = largest_fraction(changes[k].square, changes[k].linear, changes[k].constant);
    }
    for (const auto k : places_) {
      const auto cluster = clusters_.of(k);
      if (!closes[cluster]) continue;
      if (reduced_) now[k] += (full_[k] - now[k]) * fraction[cluster];
      problem_.contacts[k].impulse = now[k];
    }
    for (std::size_t k = 0; k < rebounds_.size(); ++k) {
      const auto cluster = clusters_.of(rebounds_[k].contact);
      if (closes[cluster] && kept_[k] < 1.0) kept_[k] = fraction[cluster];
    }
    for (std::uint32_t k = 0; k < closes.size(); ++k) {
      if (!closes[k]) continue;
      open_[k] = 0;
      report_.solution.residual = std::max(report_.solution.residual, worst_[k]);
    }
  }

  /// Takes restitution from the rebounds of open clusters: those that share a moving body with an offending contact, or
  /// all.
  void reduce(bool everywhere) {
    reduced_ = true;
    std::vector<char> near(problem_.free.size(), 0);
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const auto& c = problem_.contacts[k];
      if (offends_[k]) near[c.first] = near[c.second] = 1;
    }
    const auto touched = [&](std::uint32_t body) { return near[body] && problem_.free[body].inverse_mass > 0.0; };
    for (std::size_t k = 0; k < rebounds_.size(); ++k) {
      const auto& c = problem_.contacts[rebounds_[k].contact];
      if (!open_[clusters_.of(rebounds_[k].contact)]) continue;
      if (everywhere || touched(c.first) || touched(c.second)) kept_[k] = 0.0;
    }
  }

  const std::vector<Rebound<D>>& rebounds_;
  Solver<D>& solver_;
  Problem<D>& problem_;
  Clusters clusters_;
  std::vector<double> kept_;         // fraction of the restitution of each rebound
  std::vector<double> plain_;        // normal biases without restitution
  std::vector<std::size_t> places_;  // of the contacts that were solved last
  Impulses full_;                    // with all restitution
  bool reduced_ = false;
  std::vector<char> open_;         // of each cluster: it has no impulses yet
  std::vector<char> full_solved_;  // of each cluster: the law has a solution with all restitution
  std::vector<char> lawful_;       // of each cluster: the last impulses obey the law
  std::vector<double> worst_;      // of each cluster: the worst residual
  std::vector<char> offends_;      // of each contact
  ImpactReport report_;
};

}  // namespace

template <int D>
ImpactReport solve_impact(const std::vector<Rebound<D>>& rebounds, Solver<D>& solver, Problem<D>& problem) {
  return Impact<D>(rebounds, solver, problem).solve();
}

template <int D>
bool ran_away(const Problem<D>& problem) {
  const double largest = largest_impulse * velocity_scale(problem);
  return std::any_of(problem.contacts.begin(), problem.contacts.end(), [&](const auto& c) {
    return !(c.impulse.normal <= largest * c.normal_mass && magnitude(c.impulse.tangent) <= largest * c.tangent_mass);
  });
}

template <int D>
bool gains_energy(const Problem<D>& problem) {
  double before = 0.0, after = 0.0;
  for (std::size_t k = 0; k < problem.free.size(); ++k) {
    const auto &free = problem.free[k], &body = problem.bodies[k];
    if (!(free.inverse_mass > 0.0)) continue;
    const double factor = 1.0 / free.inverse_mass, turning = factor / inverse_inertia_factor<D>;
    before += factor * repose::squared(free.velocity) + turning * repose::squared(free.rim_velocity);
    after += factor * repose::squared(body.velocity) + turning * repose::squared(body.rim_velocity);
  }
  return after > before;
}

template <int D>
void take_back_gains(Problem<D>& problem) {
  if (!gains_energy(problem)) return;
  const Clusters clusters(problem);
  std::vector<Impulse<D>> now;
  for (const auto& c : problem.contacts) now.push_back(c.impulse);
  const auto gains = gains_of(problem, clusters, std::vector<Impulse<D>>(now.size()), now);
  for (std::size_t k = 0; k < now.size(); ++k) {
    const auto& gain = gains[clusters.of(k)];
    if (gain.whole() <= rounding * gain.before) continue;
    problem.contacts[k].impulse = now[k] * largest_fraction(gain.square, gain.linear, 0.0);
  }
  add_impulses(problem, problem.bodies);
}

template ImpactReport solve_impact(const std::vector<Rebound<2>>&, Solver<2>&, Problem<2>&);
template ImpactReport solve_impact(const std::vector<Rebound<3>>&, Solver<3>&, Problem<3>&);
template bool ran_away(const Problem<2>&);
template bool ran_away(const Problem<3>&);
template bool gains_energy(const Problem<2>&);
template bool gains_energy(const Problem<3>&);
template void take_back_gains(Problem<2>&);
template void take_back_gains(Problem<3>&);

}  // namespace repose::contact_dynamics
