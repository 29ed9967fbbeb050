// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/incipient_failure.hpp"

#include "repose/core/errors.hpp"

#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

namespace repose::theory {

namespace {

using State = std::vector<double>;  // (pi = P/d, u = psi - psi_surface)
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State>;

constexpr double tolerance = 1e-14;
constexpr double series_end = 2e-3;
constexpr std::size_t intervals = 4096;

/// The equations of equilibrium for d(pi, u)/dd. With x/z = (1 - d)/t and psi = psi_surface + u, the terms that vanish
/// at the surface cancel exactly; the rest is divided by d:
///   (s S + 2 t d w^2 sinc(u)^2) pi' + 2 (2 t w sinc(2u) + s C) pi u' = -2 t w^2 sinc(u)^2 pi
///   (1 - d (1 + s C) - t sin 2u) pi' - 2 (t cos 2u - s d S) pi u' = (1 - pi)/d + 2 t w sinc(2u) pi
/// where w = u/d, S = sin 2psi, C = cos 2psi, sinc(a) = sin(a)/a.
struct Equilibrium {
  double friction_angle;

  void operator()(const State& state, State& change, double d) const {
    const double pi = state[0];
    const double u = state[1];
    const double s = std::sin(friction_angle);
    const double t = std::tan(friction_angle);
    const double sin_two_psi = std::cos(friction_angle - 2.0 * u);
    const double cos_two_psi = std::sin(friction_angle - 2.0 * u);
    const double w = u / d;
    const double sinc = boost::math::sinc_pi(u);
    const double turn = t * w * boost::math::sinc_pi(2.0 * u);
    const double a = s * sin_two_psi + 2.0 * t * d * w * w * sinc * sinc;
    const double b = 2.0 * (2.0 * turn + s * cos_two_psi) * pi;
    const double e = -2.0 * t * w * w * sinc * sinc * pi;
    const double f = 1.0 - d * (1.0 + s * cos_two_psi) - t * std::sin(2.0 * u);
    const double g = -2.0 * (t * std::cos(2.0 * u) - s * d * sin_two_psi) * pi;
    const double h = (1.0 - pi) / d + 2.0 * turn * pi;
    const double determinant = a * g - b * f;
    change[0] = (e * g - b * h) / determinant;
    change[1] = (a * h - e * f) / determinant;
  }
};

/// The expansion of pi and u near the surface: pi = 1 + p0 d + p1 d^2 + p2 d^3 + c/d, u = d (w0 + w1 d + w2 d^2). c is
/// nonzero if P does not vanish on the surface; p0 and w0 are known.
struct NearSurface {
  std::array<double, 3> p;
  std::array<double, 3> w;
  double c;
};

/// The expansion from the states at d, 2d and 4d.
NearSurface fit_near_surface(double friction_angle, double d, const std::array<State, 3>& states) {
  const double s = std::sin(friction_angle);
  const double w0 = -2.0 / 3.0 * s * std::cos(friction_angle);
  const double p0 = -4.0 / 3.0 * s * s;
  // r = (pi - 1)/d - p0 = p1 d + p2 d^2 + c/d^2 at the three distances, in units of this d.
  std::array<double, 3> r{};
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double distance = d * static_cast<double>(std::size_t{1} << i);
    r[i] = (states[i][0] - 1.0) / distance - p0;
    v[i] = states[i][1] / distance - w0;
  }
  // Rows (1, 1, 1), (2, 4, 1/4), (4, 16, 1/16) of (p1, p2, c): eliminate p1, then p2.
  const double first = r[1] - 2.0 * r[0];   // 2 p2 - 7/4 c
  const double second = r[2] - 4.0 * r[0];  // 12 p2 - 63/16 c
  const double c = (second - 6.0 * first) / (10.5 - 63.0 / 16.0);
  const double p2 = 0.5 * (first + 1.75 * c);
  const double p1 = r[0] - p2 - c;
  const double w2 = 0.5 * (v[1] - 2.0 * v[0]);
  const double w1 = v[0] - w2;
  return {{p0, p1 / d, p2 / (d * d)}, {w0, w1 / d, w2 / (d * d)}, c * d * d};
}

/// The solution never meets either condition. With too little pressure on the axis, psi passes its surface value before
/// the surface is reached; with too much, P rises above d.
bool is_too_low(const State& state) { return state[1] > 0.0 || state[0] < 0.2; }
bool is_too_high(const State& state) { return state[0] > 1.0; }

/// Integrates from the axis outward. Calls observe(d, state) at each of the descending `distances` from the surface.
/// Returns false if give_up(state) is true after a step or a singular point stops the integration; `state` is then the
/// last state reached.
template <class Observe, class GiveUp>
bool integrate(double friction_angle, State& state, const std::vector<double>& distances, const Observe& observe,
               const GiveUp& give_up) {
  namespace odeint = boost::numeric::odeint;
  const Equilibrium equilibrium{friction_angle};
  auto stepper = odeint::make_controlled<Stepper>(tolerance, tolerance);
  double d = distances.front();
  double step = -1e-3 * std::min(1.0, friction_angle);
  observe(d, state);
  for (std::size_t i = 1; i < distances.size(); ++i) {
    while (d > distances[i]) {
      const bool cut = step < distances[i] - d;
      double trial = cut ? distances[i] - d : step;
      const bool done = stepper.try_step(equilibrium, state, d, trial) == odeint::success;
      if (done && cut) d = distances[i];
      step = done && cut ? std::min(step, trial) : trial;  // a cut step must not shorten the next one
      if (give_up(state) || std::abs(step) < 1e-13) return false;
    }
    observe(d, state);
  }
  return true;
}

State on_axis(double friction_angle, double pi) { return {pi, 0.5 * friction_angle - 0.25 * std::numbers::pi}; }

/// c of the solution with this pi on the axis; +-1 with the sign of c if the solution does not reach the surface.
double surface_mismatch(double friction_angle, double pi) {
  std::array<State, 3> states{};
  auto state = on_axis(friction_angle, pi);
  const std::vector<double> distances = {1.0, 4.0 * series_end, 2.0 * series_end, series_end};
  std::size_t left = distances.size();
  const auto observe = [&](double /*d*/, const State& at_d) {
    if (--left < states.size()) states[left] = at_d;
  };
  const auto give_up = [](const State& at_d) { return is_too_low(at_d) || is_too_high(at_d); };
  if (integrate(friction_angle, state, distances, observe, give_up)) {
    return fit_near_surface(friction_angle, series_end, states).c;
  }
  return is_too_low(state) ? -1.0 : 1.0;  // singular points stop only solutions that are too high
}

/// P on the axis, by shooting.
double shoot(double friction_angle) {
  const auto f = [&](double pi) { return surface_mismatch(friction_angle, pi); };
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, 0.3, 1.0, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// Descending d from the axis to the end of the series, dense within the angle phi of the axis, where the solution has
/// a layer for small phi.
std::vector<double> distances_of_profile(double friction_angle) {
  const double layer = std::tan(friction_angle);
  const double all = std::asinh((1.0 - 4.0 * series_end) / layer);
  std::vector<double> distances;
  for (std::size_t i = 0; i <= intervals; ++i) {
    distances.push_back(1.0 - layer * std::sinh(all * static_cast<double>(i) / static_cast<double>(intervals)));
  }
  distances.back() = 4.0 * series_end;
  distances.push_back(2.0 * series_end);
  distances.push_back(series_end);
  return distances;
}

double polynomial(const std::array<double, 3>& of, double d) { return of[0] + d * (of[1] + d * of[2]); }

}  // namespace

IncipientFailure::Profile IncipientFailure::solve(double friction_angle) {
  const Equilibrium equilibrium{friction_angle};
  Profile profile;
  auto state = on_axis(friction_angle, shoot(friction_angle));
  std::vector<State> states;
  const auto add = [&](double d, const State& at_d) {
    State change(2);
    equilibrium(at_d, change, d);
    profile.s.push_back(1.0 - d);
    profile.pi.push_back(at_d[0]);
    profile.pi_slope.push_back(-change[0]);
    profile.u.push_back(at_d[1]);
    profile.u_slope.push_back(-change[1]);
    states.push_back(at_d);
  };
  if (!integrate(friction_angle, state, distances_of_profile(friction_angle), add,
                 [](const State& /*at_d*/) { return false; })) {
    throw InputError("no solution at incipient failure was found for this friction angle");
  }
  const auto last = states.size() - 1;
  const auto fit = fit_near_surface(friction_angle, series_end, {states[last], states[last - 1], states[last - 2]});
  profile.pi_series = fit.p;
  profile.u_series = fit.w;
  return profile;
}

IncipientFailure::IncipientFailure(double friction_angle) : IncipientFailure(friction_angle, solve(friction_angle)) {}

IncipientFailure::IncipientFailure(double friction_angle, Profile profile)
    : sin_friction_(std::sin(friction_angle)),
      psi_surface_(0.25 * std::numbers::pi - 0.5 * friction_angle),
      pi_series_(profile.pi_series),
      u_series_(profile.u_series),
      s_(profile.s),
      pi_(std::vector(profile.s), std::move(profile.pi), std::move(profile.pi_slope)),
      u_(std::move(profile.s), std::move(profile.u), std::move(profile.u_slope)) {}

WedgeStress IncipientFailure::stress_on(const Ray& ray) const {
  const double d = ray.from_surface;
  const bool near_surface = d < 4.0 * series_end;
  const double pi = near_surface ? 1.0 + d * polynomial(pi_series_, d) : pi_(ray.from_axis);
  const double u = near_surface ? d * polynomial(u_series_, d) : u_(ray.from_axis);
  const double two_psi = ray.from_axis == 0.0 ? 0.0 : 2.0 * (psi_surface_ + u);
  const double p = d * pi;
  return {p * (1.0 + sin_friction_ * std::cos(two_psi)), p * sin_friction_ * std::sin(two_psi),
          p * (1.0 - sin_friction_ * std::cos(two_psi))};
}

double IncipientFailure::peak_normal() const {
  const auto normal = [&](double s) { return stress_on({.from_axis = s, .from_surface = 1.0 - s}).normal; };
  const auto highest = std::ranges::max_element(s_, {}, normal);
  const double low = highest == s_.begin() ? 0.0 : *std::prev(highest);
  const double high = std::next(highest) == s_.end() ? 1.0 : *std::next(highest);
  const auto [s, least] = boost::math::tools::brent_find_minima([&](double at) { return -normal(at); }, low, high, 40);
  return std::max({-least, normal(0.0), *highest == s ? 0.0 : normal(*highest)});
}

}  // namespace repose::theory
