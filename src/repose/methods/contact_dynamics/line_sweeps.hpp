// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/relax.hpp"
#include "repose/methods/contact_dynamics/self_stress.hpp"

#include <cstddef>
#include <cstring>

namespace repose::contact_dynamics {

/// Sweeps over contacts one by one, in their order. The contacts of the problem hold the impulses. For any dimension,
/// with or without pistons.
template <int D>
class LineSweeps {
 public:
  /// Call this when the velocities of the bodies agree with the impulses of the contacts.
  void begin(Problem<D>& problem) { starts_.assign(padded(problem), 0.0); }

  /// One thread does all: each contact depends on the one before it.
  std::size_t parts(const Problem<D>&) const { return 1; }

  /// The number of contacts.
  std::size_t slots(const Problem<D>& problem) const { return problem.contacts.size(); }
  bool pressed(const Problem<D>& problem, std::size_t slot) const {
    return problem.contacts[slot].impulse.normal > 0.0;
  }

  /// The numbers of the impulses, contact by contact, padded with zeros to whole cache lines.
  AlignedDoubles impulses(const Problem<D>& problem) const {
    AlignedDoubles all(padded(problem), 0.0);
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) put(problem.contacts[k].impulse, k, all.data());
    return all;
  }

  /// Copies the impulses to the contacts of the problem, which hold them already.
  void store(Problem<D>&) const {}

  /// Calls visit(contact, impulse, change) for each contact.
  template <class Visit>
  void for_each(const Problem<D>& problem, const AlignedDoubles& changes, const Visit& visit) const {
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      visit(problem.contacts[k], problem.contacts[k].impulse, at(k, changes.data()));
    }
  }

  /// The sum of the separate energies of changes.
  double separate_energy(const Problem<D>& problem, const AlignedDoubles& changes, const Kernels&) const {
    double sum = 0.0;
    for_each(problem, changes, [&](const auto& c, const auto&, const auto& change) {
      sum += contact_dynamics::separate_energy(c, change);
    });
    return sum;
  }

  /// Sets the impulses to `start`.
  void set(Problem<D>& problem, const Start& start, const History& history, const Kernels& kernels) {
    if (start.kind == Start::Kind::here) return;
    kernels.start_impulses(start, history, starts_.data(), starts_.size());
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) problem.contacts[k].impulse = at(k, starts_.data());
  }

  /// Sets the impulses to `start` and relaxes all contacts, first to last and back. The change in `history` gets the
  /// sum of the changes of both directions; nullptr: they are not recorded. `fractions` has the fraction of the change
  /// of friction that is applied, for each contact; nullptr: the whole change.
  void sweep_both_ways(Problem<D>& problem, const double* fractions, const Start& start, const History& history,
                       const Kernels& kernels, Team&) {
    set(problem, start, history, kernels);
    const auto sweep = [&](const auto& among) {
      problem.rolling ? sweep_both_ways<true>(among, problem, fractions, history.change)
                      : sweep_both_ways<false>(among, problem, fractions, history.change);
    };
    problem.pistons ? sweep(problem.with_pistons()) : sweep(FreeBodies{});
  }

 private:
  static constexpr std::size_t numbers = sizeof(Impulse<D>) / sizeof(double);  // of an impulse

  static std::size_t padded(const Problem<D>& problem) { return (problem.contacts.size() * numbers + 7) / 8 * 8; }
  static Impulse<D> at(std::size_t contact, const double* all) {
    Impulse<D> impulse;
    std::memcpy(static_cast<void*>(&impulse), all + contact * numbers, sizeof impulse);
    return impulse;
  }
  static void put(const Impulse<D>& impulse, std::size_t contact, double* all) {
    std::memcpy(all + contact * numbers, &impulse, sizeof impulse);
  }

  template <bool Rolling, class Bodies>
  static void sweep_both_ways(const Bodies& among, Problem<D>& problem, const double* fractions, double* changes) {
    auto* bodies = problem.bodies.data();
    const auto count = problem.contacts.size();
    const auto fraction = [&](std::size_t k) { return fractions ? fractions[k] : 1.0; };
    for (std::size_t k = 0; k < count; ++k) {
      auto& c = problem.contacts[k];
      Impulse<D> change;
      relax_translation(among, fraction(k), c, bodies[c.first], bodies[c.second], change);
      if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], change);
      if (changes) put(change, k, changes);
    }
    for (std::size_t k = count; k-- > 0;) {
      auto& c = problem.contacts[k];
      auto change = changes ? at(k, changes) : Impulse<D>{};
      if constexpr (Rolling) relax_roll(among, c, bodies[c.first], bodies[c.second], change);
      relax_translation(among, fraction(k), c, bodies[c.first], bodies[c.second], change);
      if (changes) put(change, k, changes);
    }
  }

  AlignedDoubles starts_;  // impulses at the start of a sweep
};

}  // namespace repose::contact_dynamics
