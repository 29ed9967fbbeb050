// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/wedge_stress.hpp"

namespace repose::theory {

/// sigma_xx = eta sigma_zz + mu sign(x) sigma_xz. Source: Bratberg (2003), eq. (42).
struct LinearClosure {
  double eta = 1.0;
  double mu = 0.0;
};

/// eta with which a surface at the friction angle is at yield: (1 - mu t)/(1 + 2 t^2), t = tan(friction angle).
double eta_of_surface_yield(double mu, double tan_friction);

/// Fixed principal axis: eta = 1, mu = -2 t. The major axis leans by (pi - 2 phi)/4 from the vertical everywhere.
LinearClosure fixed_principal_axis(double tan_friction);

/// Bouchaud, Cates and Claudin: mu = 0.
LinearClosure bouchaud_cates_claudin(double tan_friction);

/// Stress of a wedge with a linear closure and a surface free of stress, in closed form: two regions, each linear,
/// that meet with all stresses continuous on the characteristic x = lambda_plus z.
/// Source: Wittmer, Cates and Claudin (1997), for any slope; derived in docs/theory/osl.md.
/// Validated by tests/theory/osl_test.cpp.
struct LinearWedge {
  LinearClosure closure;
  double tan_slope = 0.0;
  double lambda_plus = 0.0;   ///< roots of l^2 - mu l - eta = 0: characteristics x = l z
  double lambda_minus = 0.0;  ///< negative
  double s_inner = 0.0;       ///< S of the kink, lambda_plus tan(slope), in (0, 1)
  WedgeStress outer;          ///< stress over 1 - S in the outer region
  WedgeStress centre;         ///< stress on the axis
  double normal_fall = 0.0;   ///< of sigma_zz over S in the inner region; negative: a dip
  double shear_rise = 0.0;    ///< of sigma_xz over S in the inner region
};

/// 1 - mu T - eta T^2, T the tangent of the slope: positive where the kink lies inside the wedge.
double room_for_kink(const LinearClosure& closure, double tan_slope);

/// Needs eta > 0 and room_for_kink > 0.
LinearWedge linear_wedge(const LinearClosure& closure, double tan_slope);

WedgeStress stress_on(const LinearWedge& wedge, const Ray& ray);

/// Where the Coulomb limit is exceeded, as S: from the axis out to `core_to` and from `flank_from` out to the surface;
/// not-a-number where there is none. The ratio R/P has no maximum within the inner region (see the .cpp).
struct YieldViolation {
  double smallest_margin = 0.0;
  double core_to = 0.0;
  double flank_from = 0.0;
  double share = 0.0;  ///< of the base
};
YieldViolation yield_violation(const LinearWedge& wedge, double sin_friction);

/// Margin of a ray, also on the surface, where the stress vanishes and the margin is that of the outer region.
double yield_margin(const LinearWedge& wedge, const Ray& ray, double sin_friction);

}  // namespace repose::theory
