// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/cone_stress.hpp"

#include "repose/core/errors.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace repose::theory {

namespace {

using ConeState = std::vector<double>;  // sigma_zz and sigma_rz over rho g z
using ConeStepper = boost::numeric::odeint::runge_kutta_fehlberg78<ConeState>;

constexpr double step_tolerance = 1e-13;
constexpr double axis_start = 1e-6;  // S over s_inner; the first two terms of the series leave an error of 1e-12
constexpr double spacing = 0.99;     // of distances from the characteristic: each is this fraction of the one before
constexpr double shooting = 0.8;     // the same where only the end of a solution counts
constexpr double last_distance = 1e-9;

/// The equations of equilibrium, with y' = dy/dS:
///   T rr' - S rz' = -rz - T (rr - phiphi)/S
///   T rz' - S zz' = 1 - zz - T rz/S
/// Their determinant (S_plus - S)(S - S_minus) vanishes on the characteristic S_plus. The distance from it is the
/// variable of integration, so that it is exact where it is small.
struct ConeEquilibrium {
  ConeClosure closure;
  double tan_slope;
  double s_plus, s_minus;
  double side;  ///< -1: between the axis and the characteristic, 1: between it and the surface

  double position(double distance) const { return s_plus + side * distance; }

  ConeState slope(const ConeState& y, double distance) const {
    const double t = tan_slope;
    const double s = position(distance);
    const auto [eta, mu] = closure.radial;
    const double across = -y[1] - t * hoop_difference(closure, y[0], y[1]) / s;
    const double down = 1.0 - y[0] - t * y[1] / s;
    const double determinant = -side * distance * (s - s_minus);
    return {(t * across - (t * mu - s) * down) / determinant, (s * across + t * eta * down) / determinant};
  }

  void operator()(const ConeState& y, ConeState& change, double distance) const {
    change = slope(y, distance);
    for (double& value : change) value *= side;
  }
};

/// The stress near the axis: regular solutions have the shear h1 S and the normal stress n0 + n1 S.
ConeState near_axis(const ConeEquilibrium& equations, double n0, double s) {
  const auto [eta, mu] = equations.closure.radial;
  const double h1 = 0.5 * (1.0 - n0) / equations.tan_slope;
  // If eta is 1, the axis is isotropic and the difference grows with the shear; else it is of second order.
  const double difference = eta == 1.0 ? hoop_difference(equations.closure, 0.0, h1) : 0.0;
  return {n0 - (mu * h1 + difference) / eta * s, h1 * s};
}

/// Integrates towards the characteristic, over distances that shrink by the factor `shrink`. Calls observe(distance,
/// state) at each. Returns the state on the characteristic.
template <class Observe>
ConeState integrate_to_characteristic(const ConeEquilibrium& equations, ConeState state, double from, double shrink,
                                      const Observe& observe) {
  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_controlled<ConeStepper>(step_tolerance, step_tolerance);
  double distance = from;
  observe(distance, state);
  while (distance > last_distance) {
    const double next = distance * shrink;
    // The first step from the axis is short: the equations have terms in 1/S.
    const double step = std::min(0.5 * equations.position(distance), distance - next);
    odeint::integrate_adaptive(stepper, equations, state, distance, next, -step);
    distance = next;
    observe(distance, state);
  }
  const auto slope = equations.slope(state, distance);
  for (std::size_t i = 0; i < state.size(); ++i) state[i] -= equations.side * distance * slope[i];
  return state;
}

/// The exponent a of the singular solution, |S - s_inner|^a, for this stress on the characteristic. Derived in
/// docs/theory/osl-cone.md.
double singular_exponent(const ConeClosure& closure, double lambda, const ConeState& y) {
  const double step = 1e-6 * y[0];
  const double rise = (hoop_difference(closure, y[0] + step, y[1] + lambda * step) -
                       hoop_difference(closure, y[0] - step, y[1] - lambda * step)) /
                      (2.0 * step);
  const double eta = closure.radial.eta;
  return 1.0 + (eta + rise) / (lambda * lambda + eta);
}

}  // namespace

double hoop_difference(const ConeClosure& closure, double normal, double shear) {
  if (closure.hoop == Hoop::radial) return 0.0;
  const double radial = closure.radial.eta * normal + closure.radial.mu * shear;
  const double half = 0.5 * (normal - radial);
  if (closure.hoop == Hoop::mean) return -half;
  const double radius = std::hypot(half, shear);
  if (radius == 0.0) return 0.0;
  return half > 0.0 ? shear * (shear / (half + radius)) : radius - half;  // without cancellation
}

bool is_regular_on_axis(const ConeClosure& closure) {
  const double eta = closure.radial.eta;
  return closure.hoop == Hoop::radial || eta == 1.0 || (closure.hoop == Hoop::minor && eta < 1.0);
}

ConeStress::Solution ConeStress::solve(const ConeClosure& closure, double tan_slope, const LinearWedge& wedge) {
  const double s_plus = wedge.s_inner;
  ConeEquilibrium inside{closure, tan_slope, s_plus, wedge.lambda_minus * tan_slope, -1.0};
  ConeEquilibrium outside = inside;
  outside.side = 1.0;

  const auto recorder = [](Profile& profile, const ConeEquilibrium& equations) {
    return [&profile, &equations](double distance, const ConeState& y) {
      const auto slope = equations.slope(y, distance);
      profile.s.push_back(equations.position(distance));
      profile.normal.push_back(y[0]);
      profile.normal_slope.push_back(slope[0]);
      profile.shear.push_back(y[1]);
      profile.shear_slope.push_back(slope[1]);
    };
  };
  const auto close = [s_plus](Profile& profile, const ConeState& y) {
    profile.s.push_back(s_plus);
    profile.normal.push_back(y[0]);
    profile.normal_slope.push_back(profile.normal_slope.back());
    profile.shear.push_back(y[1]);
    profile.shear_slope.push_back(profile.shear_slope.back());
  };

  Solution solution;
  const auto met =
      integrate_to_characteristic(outside, {0.0, 0.0}, 1.0 - s_plus, spacing, recorder(solution.outer, outside));
  close(solution.outer, met);
  for (auto* values : {&solution.outer.s, &solution.outer.normal, &solution.outer.normal_slope, &solution.outer.shear,
                       &solution.outer.shear_slope}) {
    std::ranges::reverse(*values);
  }
  if (!(singular_exponent(closure, wedge.lambda_plus, met) > 1.0)) {
    throw InputError("the stress has no finite slope on the characteristic from the apex, which the solver requires");
  }

  const double start = axis_start * s_plus;
  // With too low a pressure on the axis the inner stress may diverge.
  const auto mismatch = [&](double n0) {
    const auto ignore = [](double /*distance*/, const ConeState& /*y*/) {};
    const double off =
        integrate_to_characteristic(inside, near_axis(inside, n0, start), s_plus - start, shooting, ignore)[0] - met[0];
    return off > -1.0 ? off : -1.0;
  };
  const double low = mismatch(0.0);
  const double high = mismatch(1.0);
  if (!(low * high < 0.0)) throw InputError("with this closure no cone has a positive stress on the axis");
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(mismatch, 0.0, 1.0, low, high,
                                                         boost::math::tools::eps_tolerance<double>(46), iterations);
  const double n0 = 0.5 * (bracket.first + bracket.second);
  auto& inner = solution.inner;
  const auto first = near_axis(inside, n0, start);
  inner.s.push_back(0.0);
  inner.normal.push_back(n0);
  inner.normal_slope.push_back((first[0] - n0) / start);
  inner.shear.push_back(0.0);
  inner.shear_slope.push_back(first[1] / start);
  close(inner, integrate_to_characteristic(inside, first, s_plus - start, spacing, recorder(inner, inside)));
  return solution;
}

ConeStress::Curves::Curves(Profile profile)
    : normal(std::vector(profile.s), std::move(profile.normal), std::move(profile.normal_slope)),
      shear(std::move(profile.s), std::move(profile.shear), std::move(profile.shear_slope)) {}

ConeStress::ConeStress(const ConeClosure& closure, double tan_slope)
    : ConeStress(closure, tan_slope, linear_wedge(closure.radial, tan_slope),
                 solve(closure, tan_slope, linear_wedge(closure.radial, tan_slope))) {}

ConeStress::ConeStress(const ConeClosure& closure, double tan_slope, const LinearWedge& wedge, Solution solution)
    : closure_(closure),
      tan_slope_(tan_slope),
      wedge_(wedge),
      s_(solution.inner.s),
      near_surface_{-solution.outer.normal_slope.back(), -solution.outer.shear_slope.back(), 0.0},
      shear_jump_(solution.outer.shear.front() - solution.inner.shear.back()),
      inner_(std::move(solution.inner)),
      outer_(Profile(solution.outer)) {
  near_surface_.horizontal = closure.radial.eta * near_surface_.normal + closure.radial.mu * near_surface_.shear;
  s_.insert(s_.end(), std::next(solution.outer.s.begin()), solution.outer.s.end());
}

WedgeStress ConeStress::stress_on(const Ray& ray) const {
  if (ray.from_surface <= 0.0) return {};
  const auto& curves = ray.from_axis < wedge_.s_inner ? inner_ : outer_;
  const double normal = curves.normal(ray.from_axis);
  const double shear = curves.shear(ray.from_axis);
  return {normal, shear, closure_.radial.eta * normal + closure_.radial.mu * shear};
}

double ConeStress::hoop_on(const Ray& ray) const {
  const auto stress = stress_on(ray);
  return stress.horizontal - hoop_difference(closure_, stress.normal, stress.shear);
}

double ConeStress::margin_on(const Ray& ray, double sin_friction) const {
  return yield_margin(ray.from_surface > 0.0 ? stress_on(ray) : near_surface_, sin_friction);
}

ConeStress::Peak ConeStress::peak() const {
  const auto normal = [&](double s) { return stress_on({.from_axis = s, .from_surface = 1.0 - s}).normal; };
  const auto highest = std::ranges::max_element(s_, {}, normal);
  if (highest == s_.begin()) return {normal(0.0), 0.0};
  const double high = std::next(highest) == s_.end() ? 1.0 : *std::next(highest);
  const auto [s, least] =
      boost::math::tools::brent_find_minima([&](double at) { return -normal(at); }, *std::prev(highest), high, 40);
  return {-least, s};
}

double ConeStress::smallest_margin(double sin_friction) const {
  double smallest = margin_on({.from_axis = 1.0, .from_surface = 0.0}, sin_friction);
  for (const double s : s_) {
    if (s < 1.0) smallest = std::min(smallest, margin_on({.from_axis = s, .from_surface = 1.0 - s}, sin_friction));
  }
  return smallest;
}

template <class F>
double ConeStress::integral(const F& f) const {
  const auto at = [&](double s) { return f(Ray{.from_axis = s, .from_surface = 1.0 - s}); };
  double sum = 0.0;  // by Simpson's rule, which is exact for cubics
  for (std::size_t i = 1; i < s_.size(); ++i) {
    const double low = s_[i - 1];
    const double high = s_[i];
    sum += (at(low) + 4.0 * at(0.5 * (low + high)) + at(high)) * (high - low) / 6.0;
  }
  return sum;
}

double ConeStress::normal_force() const {
  return integral([&](const Ray& ray) { return stress_on(ray).normal * ray.from_axis; });
}

double ConeStress::half_cone_ratio() const {
  const double hoop = integral([&](const Ray& ray) { return hoop_on(ray); });
  const double shear = integral([&](const Ray& ray) { return stress_on(ray).shear * ray.from_axis; });
  return tan_slope_ * hoop / (3.0 * shear);
}

}  // namespace repose::theory
