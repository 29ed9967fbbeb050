// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

/// Where friction is infinite, sweeps can end in a cycle: a contact opens, its friction is gone, it is pressed together
/// again. So the friction of a contact goes only part of the way, less at every such turn.
class Yielding {
 public:
  /// All friction goes wholly where it should, from contacts of which `pressed(place)` is told.
  template <class Pressed>
  void begin(std::size_t places, const Pressed& pressed) {
    shares_.assign(places, 1.0);
    pressed_.resize(places);
    for (std::size_t k = 0; k < places; ++k) pressed_[k] = pressed(k);
  }

  /// After a sweep.
  template <class Pressed>
  void follow(const Pressed& pressed) {
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      const bool now = pressed(k);
      shares_[k] = now == static_cast<bool>(pressed_[k]) ? std::min(1.0, shares_[k] * share_at_no_turn)
                                                         : shares_[k] * share_at_turn;
      pressed_[k] = now;
    }
  }

  const double* shares() const { return shares_.data(); }

 private:
  static constexpr double share_at_turn = 0.8;
  static constexpr double share_at_no_turn = 1.005;

  AlignedDoubles shares_;      // of the way that friction goes in a sweep
  std::vector<char> pressed_;  // after the last sweep
};

}  // namespace repose::contact_dynamics
