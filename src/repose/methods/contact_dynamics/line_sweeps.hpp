// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/relax.hpp"

#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

/// Sweeps over contacts one by one, in their order; they hold their impulses themselves. For any dimension and pistons.
template <int D>
class LineSweeps {
 public:
  /// One per contact.
  using Impulses = std::vector<Impulse<D>>;

  /// The bodies of the problem have the velocities that go with the impulses of its contacts.
  void begin(Problem<D>&) {}

  /// How many contacts impulses have room for.
  std::size_t places(const Problem<D>& problem) const { return problem.contacts.size(); }
  bool pressed(const Problem<D>& problem, std::size_t place) const {
    return problem.contacts[place].impulse.normal > 0.0;
  }

  Impulses impulses(const Problem<D>& problem) const {
    Impulses all;
    all.reserve(problem.contacts.size());
    for (const auto& c : problem.contacts) all.push_back(c.impulse);
    return all;
  }

  /// Takes a sum for impulses.
  void set(const Impulses& base, const Impulses& change, Problem<D>& problem) const {
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      auto& impulse = problem.contacts[k].impulse;
      impulse = base[k];
      impulse += change[k];
    }
  }

  /// Lets the contacts of the problem have the impulses.
  void store(Problem<D>&) const {}

  /// Calls with each contact, its impulse and its part of a change.
  template <class Visit>
  void for_each(const Problem<D>& problem, const Impulses& changes, const Visit& visit) const {
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      visit(problem.contacts[k], problem.contacts[k].impulse, changes[k]);
    }
  }

  /// `shares` of the changes of friction are made, of each place; nullptr: all of them.
  void sweep_to_and_fro(Problem<D>& problem, const double* shares, Impulses& changes) const {
    const auto sweep = [&](const auto& among) {
      problem.rolling ? sweep_to_and_fro<true>(among, problem, shares, changes)
                      : sweep_to_and_fro<false>(among, problem, shares, changes);
    };
    problem.pistons ? sweep(problem.with_pistons()) : sweep(FreeBodies{});
  }

 private:
  template <bool Rolling, class Bodies>
  static void sweep_to_and_fro(const Bodies& among, Problem<D>& problem, const double* shares, Impulses& changes) {
    auto* bodies = problem.bodies.data();
    const auto count = problem.contacts.size();
    const auto share = [&](std::size_t k) { return shares ? shares[k] : 1.0; };
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
    }
  }
};

}  // namespace repose::contact_dynamics
