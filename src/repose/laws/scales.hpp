// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// What the defaults of laws are made from.
struct LawScales {
  double gravity = 1.0;   ///< [L/T^2]
  double weight = 1.0;    ///< [M L/T^2] of a grain; 1 without gravity
  double diameter = 1.0;  ///< [L] of a grain
  double friction = 0.5;  ///< Coulomb coefficient of the pair
};

}  // namespace repose
