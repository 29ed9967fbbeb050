// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/relax.hpp"

#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

/// Sweeps over contacts one by one, in their order. The contacts of the problem hold the impulses. For any dimension,
/// with or without pistons.
template <int D>
class LineSweeps {
 public:
  /// One entry per contact.
  using Impulses = std::vector<Impulse<D>>;

  /// Call this when the velocities of the bodies agree with the impulses of the contacts.
  void begin(Problem<D>&) {}

  /// The number of contacts for which impulses have entries.
  std::size_t slots(const Problem<D>& problem) const { return problem.contacts.size(); }
  bool pressed(const Problem<D>& problem, std::size_t slot) const {
    return problem.contacts[slot].impulse.normal > 0.0;
  }

  Impulses impulses(const Problem<D>& problem) const {
    Impulses all;
    all.reserve(problem.contacts.size());
    for (const auto& c : problem.contacts) all.push_back(c.impulse);
    return all;
  }

  /// Sets the impulses to base + change.
  void set(const Impulses& base, const Impulses& change, Problem<D>& problem) const {
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      auto& impulse = problem.contacts[k].impulse;
      impulse = base[k];
      impulse += change[k];
    }
  }

  /// Copies the impulses to the contacts of the problem, which hold them already.
  void store(Problem<D>&) const {}

  /// Calls visit(contact, impulse, change) for each contact.
  template <class Visit>
  void for_each(const Problem<D>& problem, const Impulses& changes, const Visit& visit) const {
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      visit(problem.contacts[k], problem.contacts[k].impulse, changes[k]);
    }
  }

  /// Relaxes all contacts, first to last and back. `changes` gets the sum of the changes of both directions.
  /// `fractions` has the fraction of the change of friction that is applied, for each contact; nullptr: the whole
  /// change.
  void sweep_both_ways(Problem<D>& problem, const double* fractions, Impulses& changes) const {
    const auto sweep = [&](const auto& among) {
      problem.rolling ? sweep_both_ways<true>(among, problem, fractions, changes)
                      : sweep_both_ways<false>(among, problem, fractions, changes);
    };
    problem.pistons ? sweep(problem.with_pistons()) : sweep(FreeBodies{});
  }

 private:
  template <bool Rolling, class Bodies>
  static void sweep_both_ways(const Bodies& among, Problem<D>& problem, const double* fractions, Impulses& changes) {
    auto* bodies = problem.bodies.data();
    const auto count = problem.contacts.size();
    const auto fraction = [&](std::size_t k) { return fractions ? fractions[k] : 1.0; };
    for (std::size_t k = 0; k < count; ++k) {
      auto& c = problem.contacts[k];
      Impulse<D> change;
      relax_translation(among, fraction(k), c, bodies[c.first], bodies[c.second], change);
      if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], change);
      changes[k] = change;
    }
    for (std::size_t k = count; k-- > 0;) {
      auto& c = problem.contacts[k];
      if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], changes[k]);
      relax_translation(among, fraction(k), c, bodies[c.first], bodies[c.second], changes[k]);
    }
  }
};

}  // namespace repose::contact_dynamics
