// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/wedge_stress.hpp"

namespace repose::theory {

/// The closure sigma_xx = eta sigma_zz + mu sign(x) sigma_xz. Source: Bratberg (2003), eq. (42).
struct LinearClosure {
  double eta = 1.0;
  double mu = 0.0;
};

/// The eta for which a surface at the friction angle is at yield: (1 - mu t)/(1 + 2 t^2), t = tan(friction angle).
double eta_of_surface_yield(double mu, double tan_friction);

/// The closure of a fixed principal axis: eta = 1, mu = -2 t. The major axis leans by (pi - 2 phi)/4 from the vertical
/// everywhere.
LinearClosure fixed_principal_axis(double tan_friction);

/// The closure of Bouchaud, Cates and Claudin: mu = 0.
LinearClosure bouchaud_cates_claudin(double tan_friction);

/// The stress in a wedge with a linear closure and a stress-free surface, in closed form. It is linear in an inner and
/// an outer region; all stresses are continuous where they meet, on the characteristic x = lambda_plus z (the kink).
/// Source: Wittmer, Cates and Claudin (1997), for any slope; derived in docs/theory/osl.md.
/// Validated by tests/theory/osl_test.cpp.
struct LinearWedge {
  LinearClosure closure;
  double tan_slope = 0.0;
  double lambda_plus = 0.0;   ///< positive root of l^2 - mu l - eta = 0: characteristics are x = l z
  double lambda_minus = 0.0;  ///< negative root
  double s_inner = 0.0;       ///< S of the kink, lambda_plus tan(slope), in (0, 1)
  WedgeStress outer;          ///< stress divided by 1 - S in the outer region
  WedgeStress centre;         ///< stress on the axis
  double normal_fall = 0.0;   ///< decrease of sigma_zz with S in the inner region; negative: a dip
  double shear_rise = 0.0;    ///< increase of sigma_xz with S in the inner region
};

/// 1 - mu T - eta T^2, T the tangent of the slope. It is positive if the kink lies inside the wedge.
double kink_margin(const LinearClosure& closure, double tan_slope);

/// The wedge of a closure. Requires eta > 0 and kink_margin > 0.
LinearWedge linear_wedge(const LinearClosure& closure, double tan_slope);

WedgeStress stress_on(const LinearWedge& wedge, const Ray& ray);

/// The ranges of S where the Coulomb limit is exceeded: from the axis to `core_to` and from `flank_from` to the
/// surface. A bound is NaN if its range is empty. The ratio R/P has no maximum within the inner region (see the .cpp).
struct YieldViolation {
  double smallest_margin = 0.0;
  double core_to = 0.0;
  double flank_from = 0.0;
  double fraction = 0.0;  ///< fraction of the base
};
YieldViolation yield_violation(const LinearWedge& wedge, double sin_friction);

/// The yield margin of a ray. On the surface the stress vanishes, and the margin is that of the outer region.
double yield_margin(const LinearWedge& wedge, const Ray& ray, double sin_friction);

}  // namespace repose::theory
