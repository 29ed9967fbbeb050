// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// The scales of a scene, from which laws set their defaults.
struct LawScales {
  double gravity = 1.0;   ///< [L/T^2]
  double weight = 1.0;    ///< [M L/T^2] weight of a grain; 1 without gravity
  double diameter = 1.0;  ///< [L] diameter of a grain
  double friction = 0.5;  ///< Coulomb coefficient of the pair
  double ratio = 0.82;    ///< tangential over normal stiffness of elastic bodies, by Poisson's ratio; 0.82 for 0.3
};

}  // namespace repose
