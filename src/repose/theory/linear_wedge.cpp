// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/linear_wedge.hpp"

#include "repose/core/numbers.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <limits>

namespace repose::theory {

namespace {

// A surface at the friction angle is exactly at yield, so rounding must not count as a violation.
double margin_of_rounding(double sin_friction) { return std::max(1e-12, 1e-14 / sin_friction); }
constexpr double length_of_rounding = 1e-9;

bool is_outer(const LinearWedge& wedge, const Ray& ray) { return ray.from_axis >= wedge.s_inner; }

/// R^2 - P^2 sin(phi)^2 of the inner region as c2 S^2 + c1 S + c0.
struct Excess {
  double c2, c1, c0;
};

Excess excess_of(const LinearWedge& wedge, double sin_friction) {
  const double s2 = sin_friction * sin_friction;
  const double difference = wedge.centre.normal - wedge.centre.horizontal;
  const double sum = wedge.centre.normal + wedge.centre.horizontal;
  const double fall = wedge.normal_fall;
  return {wedge.shear_rise * wedge.shear_rise + 0.25 * fall * fall * (1.0 - s2), 0.5 * fall * (s2 * sum - difference),
          0.25 * (difference * difference - s2 * sum * sum)};
}

}  // namespace

double eta_of_surface_yield(double mu, double tan_friction) {
  return (1.0 - mu * tan_friction) / (1.0 + 2.0 * tan_friction * tan_friction);
}

LinearClosure fixed_principal_axis(double tan_friction) { return {.eta = 1.0, .mu = -2.0 * tan_friction}; }

LinearClosure bouchaud_cates_claudin(double tan_friction) {
  return {.eta = eta_of_surface_yield(0.0, tan_friction), .mu = 0.0};
}

double kink_margin(const LinearClosure& closure, double tan_slope) {
  return 1.0 - closure.mu * tan_slope - closure.eta * tan_slope * tan_slope;
}

LinearWedge linear_wedge(const LinearClosure& closure, double tan_slope) {
  const auto [eta, mu] = closure;
  const double root = std::hypot(mu, 2.0 * std::sqrt(eta));
  // The root without cancellation comes first; the product of the roots is -eta.
  const double larger = 0.5 * (std::abs(mu) + root);
  const double plus = mu >= 0.0 ? larger : eta / larger;
  const double minus = mu >= 0.0 ? -eta / larger : -larger;

  LinearWedge wedge;
  wedge.closure = closure;
  wedge.tan_slope = tan_slope;
  wedge.lambda_plus = plus;
  wedge.lambda_minus = minus;
  wedge.s_inner = plus * tan_slope;
  const double c = eta / kink_margin(closure, tan_slope);
  wedge.outer = {1.0 + c * tan_slope * tan_slope, c * tan_slope, c};
  // kink_margin is (1 - lambda_plus T)(1 - lambda_minus T), which leaves one factor in A = 1 - b.
  const double a = 1.0 / (1.0 - minus * tan_slope);
  wedge.centre = {a, 0.0, eta * a};
  wedge.normal_fall = mu * a / plus;
  wedge.shear_rise = -minus * a;
  return wedge;
}

WedgeStress stress_on(const LinearWedge& wedge, const Ray& ray) {
  if (is_outer(wedge, ray)) {
    const double d = ray.from_surface;
    return {wedge.outer.normal * d, wedge.outer.shear * d, wedge.outer.horizontal * d};
  }
  return {wedge.centre.normal - wedge.normal_fall * ray.from_axis, wedge.shear_rise * ray.from_axis,
          wedge.centre.horizontal};
}

double yield_margin(const LinearWedge& wedge, const Ray& ray, double sin_friction) {
  return yield_margin(is_outer(wedge, ray) ? wedge.outer : stress_on(wedge, ray), sin_friction);
}

// In the inner region R^2 - (P sin)^2 is a quadratic in S with a positive leading coefficient for every friction angle.
// So it is positive below one root or above the other, and R/P is largest at one end of the region.
YieldViolation yield_violation(const LinearWedge& wedge, double sin_friction) {
  const double core = yield_margin(wedge.centre, sin_friction);
  const double flank = yield_margin(wedge.outer, sin_friction);
  const double smallest = std::min(core, flank);
  const double rounding = margin_of_rounding(sin_friction);
  YieldViolation violation{std::abs(smallest) < rounding ? 0.0 : smallest, no_number, no_number, 0.0};
  const bool core_fails = core < -rounding;
  const bool flank_fails = flank < -rounding;
  if (!core_fails && !flank_fails) return violation;
  const auto excess = excess_of(wedge, sin_friction);
  auto [low, high] = boost::math::tools::quadratic_roots(excess.c2, excess.c1, excess.c0);
  // Without a root the limit is exceeded everywhere, unless rounding hides a single point where it is just met.
  const bool no_root = std::isnan(low);
  const bool everywhere = core_fails && flank_fails && (no_root || high < 0.0 || low > wedge.s_inner);
  if (no_root) low = high = -0.5 * excess.c1 / excess.c2;
  if (everywhere) return {smallest, 1.0, 0.0, 1.0};
  if (core_fails && low > length_of_rounding) {
    violation.core_to = std::min(low, wedge.s_inner);
    violation.fraction += violation.core_to;
  }
  if (flank_fails) {
    violation.flank_from = std::clamp(high, 0.0, wedge.s_inner);
    violation.fraction += 1.0 - violation.flank_from;
  }
  return violation;
}

}  // namespace repose::theory
