// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// Stress at a place in 2D, and Coulomb's limit. x to the right, z down, compression positive: s_xz > 0 if what lies
/// above a horizontal plane pushes what lies below to the right.
/// Source: Bratberg's thesis (2003), eqs (11)-(15), with s_xz. Validated by tests/theory/mohr_test.cpp.
struct Mohr {
  double s_xx = 0.4;           ///< [stress] horizontal
  double s_zz = 1.0;           ///< [stress] vertical
  double s_xz = 0.1;           ///< [stress] shear
  double plane_deg = 30.0;     ///< dip of the plane that is looked at, downward to the right
  double friction_deg = 30.0;  ///< phi
  std::int64_t points = 181;   ///< planes of the circle

  static constexpr ModelText text{.name = "mohr",
                                  .about = "Mohr's circle of a stress, and how far it is from Coulomb's limit",
                                  .source = "Bratberg 2003 (thesis), eqs (11)-(15); (14) is the condition of slip"};
};

/// What acts across a plane, on what lies below it.
struct PlaneStress {
  double normal = 0.0;  ///< compression positive
  double shear = 0.0;   ///< positive down the plane, to the right
};
PlaneStress stress_on_plane(const Mohr& place, double plane_deg);

/// The circle: mean of the principal stresses, half their difference, and where the larger one points.
struct MohrCircle {
  double centre = 0.0;
  double radius = 0.0;
  double major = 0.0;
  double minor = 0.0;
  double principal_angle_deg = 0.0;  ///< of the major stress, from the vertical, its lower end to the right; (-90, 90]
};
MohrCircle circle_of(const Mohr& place);

/// R/(P sin phi) of (15), 1 at the limit; infinite where friction cannot hold anything (no mean pressure, or no
/// friction) but there is shear, 0 for no stress at all.
double coulomb_ratio(const Mohr& place);

void parameters(Mohr& place, Parameters& to);

/// Columns plane_deg (-90 to 90), normal, shear.
Table evaluate(const Mohr& place);

}  // namespace repose::theory
