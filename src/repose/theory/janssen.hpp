// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose::theory {

/// Janssen's column: the horizontal stress is stress_ratio times the vertical stress, and wall friction is fully
/// mobilised. Any consistent units of mass M, length L and time T; in 2D all quantities are per length along the third
/// direction. Source: Bratberg's thesis (2003), eqs (18)-(29), without g in the masses (26) and (29); Janssen (1895).
/// Validated by tests/theory/janssen_test.cpp.
struct Janssen {
  std::int64_t dimension = 3;      ///< 2 (slit) or 3 (round pipe)
  double width = 1.0;              ///< [L] distance between the walls (2D), or diameter (3D)
  double stress_ratio = 0.5;       ///< K, horizontal over vertical stress
  double friction = 0.5;           ///< mu, of grains against the wall
  double solid_fraction = 0.6;     ///< c
  double density = 1.0;            ///< [M/L^3] rho, density of the material of a grain
  double gravity = 1.0;            ///< [L/T^2]
  double height = 5.0;             ///< [L] height of the column
  std::string direction = "rest";  ///< rest | pushed-up
  double overload = 0.0;           ///< [M/(L T^2)] vertical stress on the top
  std::int64_t points = 201;       ///< number of depths, top and bottom included

  static constexpr ModelText text{.name = "janssen",
                                  .about = "Vertical stress and apparent mass in a column between rough walls",
                                  .source = "Janssen 1895; Bratberg 2003 (thesis), eqs (18)-(29), corrected"};
};

/// The screening length [L], over which the walls take over the weight: width/(4 K mu) in 3D (27), width/(2 K mu) in 2D
/// (28); infinite without friction.
double screening_length(const Janssen& column);

/// The weight of the grains per volume, rho c g [M/(L^2 T^2)]. Times the depth it is the stress without walls.
double weight_per_volume(const Janssen& column);

/// The area of the cross-section [L^2]; in 2D the width [L].
double area(const Janssen& column);

/// The vertical stress [M/(L T^2)] at a depth [L] below the top; compression is positive.
double vertical_stress(const Janssen& column, double depth);

void parameters(Janssen& column, Parameters& to);
std::vector<std::string> relations(const Janssen& column);

/// Columns depth, stress, apparent_mass (stress * area / g).
Table evaluate(const Janssen& column);

}  // namespace repose::theory
