// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// The stress at a point in 2D, and Coulomb's limit. x points to the right, z down; compression is positive. s_xz > 0
/// if the upper side of a horizontal plane pushes the lower side to the right. Source: Bratberg's thesis (2003), eqs
/// (11)-(15), with s_xz. Validated by tests/theory/mohr_test.cpp.
struct Mohr {
  double s_xx = 0.4;           ///< [stress] horizontal normal stress
  double s_zz = 1.0;           ///< [stress] vertical normal stress
  double s_xz = 0.1;           ///< [stress] shear stress
  double plane_deg = 30.0;     ///< dip of the chosen plane, downward to the right
  double friction_deg = 30.0;  ///< phi
  std::int64_t points = 181;   ///< number of planes

  static constexpr ModelText text{.name = "mohr",
                                  .about = "Mohr's circle of a stress, and how far it is from Coulomb's limit",
                                  .source = "Bratberg 2003 (thesis), eqs (11)-(15); (14) is the condition of slip"};
};

/// The stress on the lower side of a plane.
struct PlaneStress {
  double normal = 0.0;  ///< compression positive
  double shear = 0.0;   ///< positive down the plane, to the right
};
PlaneStress stress_on_plane(const Mohr& place, double plane_deg);

/// Mohr's circle.
struct MohrCircle {
  double centre = 0.0;               ///< P, mean of the principal stresses
  double radius = 0.0;               ///< R, half their difference
  double major = 0.0;                ///< larger principal stress
  double minor = 0.0;                ///< smaller principal stress
  double principal_angle_deg = 0.0;  ///< of the major stress, from the vertical, its lower end to the right; (-90, 90]
};
MohrCircle circle_of(const Mohr& place);

/// R/(P sin phi) of (15), which is 1 at the limit. Infinite if there is shear but friction cannot hold it (no mean
/// pressure, or no friction); 0 without any stress.
double coulomb_ratio(const Mohr& place);

void parameters(Mohr& place, Parameters& to);

/// A table with the columns plane_deg (-90 to 90), normal and shear.
Table evaluate(const Mohr& place);

}  // namespace repose::theory
