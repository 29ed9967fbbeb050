// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// The interface of LineSweeps<2>, for problems without pistons: eight contacts at once, in an order of its own.
class PackSweeps {
 public:
  /// `pack_numbers` entries per pack.
  using Impulses = AlignedDoubles;

  /// Builds the packs, and adds to the bodies the one that unused lanes refer to.
  void begin(Problem<2>& problem) {
    packs_.build(problem);
    impulses_.resize(packs_.size() * pack_numbers);
    packs_.load(problem.contacts, impulses_.data());
    problem.bodies.push_back({});
  }

  std::size_t slots(const Problem<2>&) const { return packs_.size() * pack_lanes; }
  bool pressed(const Problem<2>&, std::size_t slot) const { return *normal(impulses_, slot) > 0.0; }

  const Impulses& impulses(const Problem<2>&) const { return impulses_; }

  void set(const Impulses& base, const Impulses& change, Problem<2>&) {
    for (std::size_t k = 0; k < impulses_.size(); ++k) impulses_[k] = base[k] + change[k];
  }

  void store(Problem<2>& problem) const { packs_.store(impulses_.data(), problem.contacts); }

  template <class Visit>
  void for_each(const Problem<2>& problem, const Impulses& changes, const Visit& visit) const {
    for (std::size_t slot = 0; slot < slots(problem); ++slot) {
      const auto contact = packs_.contact(slot / pack_lanes, slot % pack_lanes);
      if (contact == Packs::none) continue;
      visit(problem.contacts[contact], at(impulses_, slot), at(changes, slot));
    }
  }

  void sweep_both_ways(Problem<2>& problem, const double* fractions, Impulses& changes) {
    packs_.sweep_both_ways(impulses_.data(), problem.bodies.data(), changes.data(), fractions, problem.rolling);
  }

 private:
  static const double* normal(const Impulses& impulses, std::size_t slot) {
    return impulses.data() + slot / pack_lanes * pack_numbers + slot % pack_lanes;
  }
  static Impulse<2> at(const Impulses& impulses, std::size_t slot) {
    const double* p = normal(impulses, slot);
    return {p[0], p[pack_lanes], p[2 * pack_lanes]};
  }

  Packs packs_;
  Impulses impulses_;
};

}  // namespace repose::contact_dynamics
