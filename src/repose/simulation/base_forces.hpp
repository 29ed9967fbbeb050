// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <deque>
#include <vector>

namespace repose {

/// The forces on wall `wall` of the grains that it carries, in a unit [M L/T^2], at this time [T].
template <int D>
BaseProfile floor_profile(const Grains<D>& grains, const Contacts<D>& contacts, std::int64_t wall, double time,
                          double unit);

/// Forces on the fixed grains, as means over the last `window` of time [T] before the last row of the series.
template <int D>
class BaseForces {
 public:
  /// `tolerance` [T] by which the start of the window may miss that of an interval.
  BaseForces(const Grains<D>& grains, double window, double tolerance);

  /// Takes the reactions that the fixed grains have gathered since the last call.
  void record(Grains<D>& grains, double time);

  /// The forces on the base, in a unit [M L/T^2].
  BaseProfile profile(const Grains<D>& grains, double unit) const;

  /// Downward force [M L/T^2] on fixed grains, mean over the window, and on walls by these contacts.
  double force_on_supports(const Contacts<D>& contacts) const;

  void exchange(Archive& archive);

 private:
  /// Impulse on the fixed grains between two rows of the series.
  struct Interval {
    double start = 0.0;           // [T]
    double end = 0.0;             // [T]
    std::vector<Vec<D>> impulse;  // [M L/T] per fixed grain, by id order
  };

  std::size_t place_of(std::int64_t id) const;

  double window_;
  double tolerance_;
  std::vector<std::int64_t> ids_;  // of the fixed grains, ascending
  std::deque<Interval> intervals_;
};

}  // namespace repose
