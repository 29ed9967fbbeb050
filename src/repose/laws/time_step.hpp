// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

namespace repose {

/// What a time step is judged by: the stiffest contact that a fall from the source can bring about.
struct StiffestContact {
  double frequency = 0.0;  ///< [1/T] w = sqrt(k / m), k at the overlap reached from the fall, m of the moving grain
};

/// A size of grains.
struct GrainSize {
  double diameter = 1.0;  ///< [L]
  double mass = 1.0;      ///< [M]
};

/// The stiffest contact of grains of these sizes, of which the first moves; `fall` [L] is the height of the highest
/// fall.
StiffestContact stiffest_contact(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner,
                                 double gravity, double fall);

/// The step is refused beyond w dt = 1; "auto" takes half of that.
inline constexpr double largest_phase = 1.0;
inline constexpr double auto_phase = 0.5;

}  // namespace repose
