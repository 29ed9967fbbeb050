// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/aligned.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace repose::contact_dynamics {

/// Prevents cycles of sweeps with infinite friction, in which a contact opens, loses its friction and is pressed
/// together again. Only a fraction of the change of friction is applied, and each opening or closing of the contact
/// reduces it.
class Yielding {
 public:
  /// Starts with the whole change for all contacts. `pressed(slot)` is whether a contact carries a normal impulse.
  template <class Pressed>
  void begin(std::size_t slots, const Pressed& pressed) {
    fractions_.assign(slots, 1.0);
    pressed_.resize(slots);
    for (std::size_t k = 0; k < slots; ++k) pressed_[k] = pressed(k);
  }

  /// Call this after each sweep.
  template <class Pressed>
  void follow(const Pressed& pressed) {
    for (std::size_t k = 0; k < fractions_.size(); ++k) {
      const bool now = pressed(k);
      fractions_[k] = now == static_cast<bool>(pressed_[k]) ? std::min(1.0, fractions_[k] * factor_without_change)
                                                            : fractions_[k] * factor_at_change;
      pressed_[k] = now;
    }
  }

  const double* fractions() const { return fractions_.data(); }

 private:
  static constexpr double factor_at_change = 0.8;
  static constexpr double factor_without_change = 1.005;

  AlignedDoubles fractions_;   // fraction of the change of friction that is applied
  std::vector<char> pressed_;  // whether each contact was pressed after the last sweep
};

}  // namespace repose::contact_dynamics
