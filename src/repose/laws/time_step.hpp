// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

namespace repose {

/// What a time step is judged by: the stiffest contact that a fall from the source can bring about.
struct StiffestContact {
  double frequency = 0.0;  ///< [1/T] w = sqrt(k / m), k at the overlap reached from the fall, m of the moving grain
};

/// Sizes and fall of a scene, for the stiffest contact.
struct ContactConditions {
  double smallest_diameter = 1.0;  ///< [L]
  double largest_diameter = 1.0;   ///< [L]
  double diameter = 1.0;           ///< [L] of a grain of mass `mass`; masses go with the square of the diameter
  double mass = 1.0;               ///< [M]
  double gravity = 1.0;            ///< [L/T^2]
  double fall = 1.0;               ///< [L] height of the highest fall
};

StiffestContact stiffest_contact(const NormalLaw& normal, const TangentialLaw& tangential,
                                 const ContactConditions& conditions);

/// The step is refused beyond w dt = 1; "auto" takes half of that.
inline constexpr double largest_phase = 1.0;
inline constexpr double auto_phase = 0.5;

}  // namespace repose
