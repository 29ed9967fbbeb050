// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"
#include "repose/core/inline.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace repose {

/// The contact law of rigid grains: Signorini's condition and Coulomb's law with coefficients of restitution, rolling
/// friction, and of spheres twisting friction. Every coefficient of friction may be infinite.
/// Source: Bratberg (2003), 4.6-4.8 and paper one, Eq. 6, as corrected in docs/physics/contact_dynamics.md.
struct ImpulseLaw {
  double restitution = 0.0;             ///< normal velocity after divided by that before, 0 to 1
  double tangential_restitution = 0.0;  ///< tangential velocity after divided by that before, -1 to 1
  double friction = 0.0;                ///< largest ratio of tangential to normal impulse, >= 0
  double rolling_friction = 0.0;        ///< tan(theta_r): largest ratio of torque to normal impulse times roll radius
  double dynamic_friction = 0.0;        ///< friction at slip speeds above `weakening_velocity`, 0 to `friction`
  double weakening_velocity = 0.0;      ///< [L/T] slip speed at which weakening is complete; 0: no weakening
  /// Largest ratio of the torque about the normal to normal impulse times roll radius, >= 0; spheres only.
  double twisting_friction = 0.0;
};

/// The coefficient of friction at this slip speed [L/T] of the previous step: it decreases linearly up to
/// `weakening_velocity` and is constant beyond.
inline double friction_at(const ImpulseLaw& law, double slip_speed) {
  if (!(law.weakening_velocity > 0.0)) return law.friction;
  const double left = std::max(0.0, 1.0 - std::fabs(slip_speed) / law.weakening_velocity);
  return law.dynamic_friction + (law.friction - law.dynamic_friction) * left;
}

/// The rolling friction that holds a non-sliding grain on another up to this angle [deg] of their centre line from the
/// vertical.
inline double rolling_friction_of(double critical_angle) {
  if (critical_angle >= 90.0) return std::numeric_limits<double>::infinity();
  return reproducible::tan(critical_angle * std::numbers::pi / 180.0);
}

/// The largest frictional impulse under this normal impulse; 0 without a normal impulse, even if the coefficient is
/// infinite.
REPOSE_FN double friction_limit(double coefficient, double normal_impulse) {
  return normal_impulse > 0.0 ? coefficient * normal_impulse : 0.0;
}

/// The nearest impulse of at most `limit`.
REPOSE_FN double project(double impulse, double limit) { return std::min(std::max(impulse, -limit), limit); }
REPOSE_FN Vec<3> project(const Vec<3>& impulse, double limit) {
  const double size = magnitude(impulse);
  return size > limit ? impulse * (limit / size) : impulse;
}

/// The change, reduced so that the impulse after it is at most `limit`. If it stays within the limit, it is returned to
/// the bit.
REPOSE_FN double change_within(double impulse, double change, double limit) {
  return std::min(std::max(change, -limit - impulse), limit - impulse);
}
REPOSE_FN Vec<3> change_within(const Vec<3>& impulse, const Vec<3>& change, double limit) {
  const Vec<3> sum = impulse + change;
  const double size = magnitude(sum);
  return size > limit ? sum * (limit / size) - impulse : change;
}

/// The impulse law of every pair of materials.
class ImpulseLaws {
 public:
  explicit ImpulseLaws(const ImpulseLaw& only) : laws_{only} {}

  /// `laws` is a symmetric table of materials x materials.
  ImpulseLaws(std::vector<ImpulseLaw> laws, std::size_t materials) : materials_(materials), laws_(std::move(laws)) {
    REPOSE_ASSERT(laws_.size() == materials_ * materials_ && materials_ > 0);
  }

  const ImpulseLaw& of(std::size_t a, std::size_t b) const {
    return laws_.size() == 1 ? laws_.front() : laws_[a * materials_ + b];
  }

 private:
  std::size_t materials_ = 1;
  std::vector<ImpulseLaw> laws_;
};

}  // namespace repose
