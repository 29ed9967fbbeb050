// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/pack_groups.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// The interface of LineSweeps<2>, for problems without pistons: eight contacts at once, in an order of its own. The
/// numbers of the impulses are those of the packs.
class PackSweeps {
 public:
  /// Builds the packs, and adds to the bodies those that they need.
  void begin(Problem<2>& problem) {
    packs_.build(problem, parts(problem));
    impulses_.resize(packs_.size() * packs_.numbers());
    packs_.load(problem.contacts, impulses_.data());
    packs_.add_bodies(problem.bodies);
  }

  /// The number of parts of the problem that threads may share.
  std::size_t parts(const Problem<2>& problem) const { return parts_of(problem.contacts.size()); }

  std::size_t slots(const Problem<2>&) const { return packs_.size() * pack_lanes; }
  bool pressed(const Problem<2>&, std::size_t slot) const { return *normal(impulses_, slot) > 0.0; }

  const AlignedDoubles& impulses(const Problem<2>&) const { return impulses_; }

  void store(Problem<2>& problem) const { packs_.store(impulses_.data(), problem.contacts); }

  template <class Visit>
  void for_each(const Problem<2>& problem, const AlignedDoubles& changes, const Visit& visit) const {
    for (std::size_t slot = 0; slot < slots(problem); ++slot) {
      const auto contact = packs_.contact(slot / pack_lanes, slot % pack_lanes);
      if (contact == Packs::none) continue;
      visit(problem.contacts[contact], at(impulses_, slot), at(changes, slot));
    }
  }

  double separate_energy(const Problem<2>&, const AlignedDoubles& changes, const Kernels& kernels) const {
    return packs_.separate_energy(changes.data(), kernels);
  }

  void set(Problem<2>&, const Start& start, const History& history, const Kernels& kernels) {
    kernels.start_impulses(start, history, impulses_.data(), impulses_.size());
  }

  void sweep_both_ways(Problem<2>& problem, const double* fractions, const Start& start, const History& history,
                       const Kernels& kernels, Team& team) {
    PackSweep sweep;
    sweep.impulses = impulses_.data();
    sweep.bodies = problem.bodies.data();
    sweep.fractions = fractions;
    sweep.start = start;
    sweep.history = history;
    packs_.sweep_both_ways(sweep, kernels, team);
  }

 private:
  const double* normal(const AlignedDoubles& impulses, std::size_t slot) const {
    return impulses.data() + slot / pack_lanes * packs_.numbers() + slot % pack_lanes;
  }
  Impulse<2> at(const AlignedDoubles& impulses, std::size_t slot) const {
    const double* p = normal(impulses, slot);
    return {p[0], p[pack_lanes], packs_.numbers() > 2 * pack_lanes ? p[2 * pack_lanes] : 0.0};
  }

  Packs packs_;
  AlignedDoubles impulses_;
};

}  // namespace repose::contact_dynamics
