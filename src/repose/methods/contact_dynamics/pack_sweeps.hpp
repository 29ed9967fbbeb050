// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// The same as LineSweeps<2> for problems without pistons, eight contacts at once, in an order of its own.
class PackSweeps {
 public:
  /// `pack_numbers` per pack.
  using Impulses = AlignedDoubles;

  /// Adds to the bodies the one that empty lanes touch.
  void begin(Problem<2>& problem) {
    packs_.build(problem);
    impulses_.resize(packs_.size() * pack_numbers);
    packs_.load(problem.contacts, impulses_.data());
    problem.bodies.push_back({});
  }

  std::size_t places(const Problem<2>&) const { return packs_.size() * pack_lanes; }
  bool pressed(const Problem<2>&, std::size_t place) const { return *normal(impulses_, place) > 0.0; }

  const Impulses& impulses(const Problem<2>&) const { return impulses_; }

  void set(const Impulses& base, const Impulses& change, Problem<2>&) {
    for (std::size_t k = 0; k < impulses_.size(); ++k) impulses_[k] = base[k] + change[k];
  }

  void store(Problem<2>& problem) const { packs_.store(impulses_.data(), problem.contacts); }

  template <class Visit>
  void for_each(const Problem<2>& problem, const Impulses& changes, const Visit& visit) const {
    for (std::size_t place = 0; place < places(problem); ++place) {
      const auto contact = packs_.contact(place / pack_lanes, place % pack_lanes);
      if (contact == Packs::none) continue;
      visit(problem.contacts[contact], at(impulses_, place), at(changes, place));
    }
  }

  void sweep_to_and_fro(Problem<2>& problem, const double* shares, Impulses& changes) {
    packs_.sweep_to_and_fro(impulses_.data(), problem.bodies.data(), changes.data(), shares, problem.rolling);
  }

 private:
  static const double* normal(const Impulses& impulses, std::size_t place) {
    return impulses.data() + place / pack_lanes * pack_numbers + place % pack_lanes;
  }
  static Impulse<2> at(const Impulses& impulses, std::size_t place) {
    const double* p = normal(impulses, place);
    return {p[0], p[pack_lanes], p[2 * pack_lanes]};
  }

  Packs packs_;
  Impulses impulses_;
};

}  // namespace repose::contact_dynamics
