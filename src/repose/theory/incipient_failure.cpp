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

/// Equilibrium as d(pi, u)/dd. With x/z = (1 - d)/t and psi = psi_surface + u, both equations are identities in which
/// the terms that vanish at the surface cancel exactly; what is left was divided by d:
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

/// What pi and u do near the surface: pi = 1 + p0 d + p1 d^2 + p2 d^3 + c/d, u = d (w0 + w1 d + w2 d^2). c is nonzero
/// where P does not vanish on the surface; p0 and w0 are known.
struct NearSurface {
  std::array<double, 3> p;
  std::array<double, 3> w;
  double c;
};

/// From the states at d, 2d and 4d.
NearSurface fit_near_surface(double friction_angle, double d, const std::array<State, 3>& states) {
  const double s = std::sin(friction_angle);
  const double w0 = -2.0 / 3.0 * s * std::cos(friction_angle);
  const double p0 = -4.0 / 3.0 * s * s;
  // r = (pi - 1)/d - p0 = p1 d + p2 d^2 + c/d^2 at three places, in units of this d.
  std::array<double, 3> r{};
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double there = d * static_cast<double>(std::size_t{1} << i);
    r[i] = (states[i][0] - 1.0) / there - p0;
    v[i] = states[i][1] / there - w0;
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

/// The solution is between these in all of the wedge: with too little pressure on the axis psi passes its value on the
/// surface on the way there, with too much P rises above d.
bool is_too_low(const State& state) { return state[1] > 0.0 || state[0] < 0.2; }
bool is_too_high(const State& state) { return state[0] > 1.0; }

/// Integrates from the axis outward; `see` gets each of the falling `places` with the state there, `give_up` the state
/// after every step. False where that gave up, or where a singular point stops it; `state` then is the last one.
template <class See, class GiveUp>
bool integrate(double friction_angle, State& state, const std::vector<double>& places, const See& see,
               const GiveUp& give_up) {
  namespace odeint = boost::numeric::odeint;
  const Equilibrium equilibrium{friction_angle};
  auto stepper = odeint::make_controlled<Stepper>(tolerance, tolerance);
  double d = places.front();
  double step = -1e-3 * std::min(1.0, friction_angle);
  see(d, state);
  for (std::size_t i = 1; i < places.size(); ++i) {
    while (d > places[i]) {
      const bool cut = step < places[i] - d;
      double trial = cut ? places[i] - d : step;
      const bool done = stepper.try_step(equilibrium, state, d, trial) == odeint::success;
      if (done && cut) d = places[i];
      step = done && cut ? std::min(step, trial) : trial;  // what a cut step can do is no reason to shorten the next
      if (give_up(state) || std::abs(step) < 1e-13) return false;
    }
    see(d, state);
  }
  return true;
}

State on_axis(double friction_angle, double pi) { return {pi, 0.5 * friction_angle - 0.25 * std::numbers::pi}; }

/// c of the solution with this pi on the axis; a large value of its sign where it does not come near the surface.
double misses_by(double friction_angle, double pi) {
  std::array<State, 3> states{};
  auto state = on_axis(friction_angle, pi);
  const std::vector<double> places = {1.0, 4.0 * series_end, 2.0 * series_end, series_end};
  std::size_t to_see = places.size();
  const auto see = [&](double /*d*/, const State& there) {
    if (--to_see < states.size()) states[to_see] = there;
  };
  const auto give_up = [](const State& there) { return is_too_low(there) || is_too_high(there); };
  if (integrate(friction_angle, state, places, see, give_up)) {
    return fit_near_surface(friction_angle, series_end, states).c;
  }
  return is_too_low(state) ? -1.0 : 1.0;  // singular points stop only what is too high
}

/// P on the axis.
double shoot(double friction_angle) {
  const auto f = [&](double pi) { return misses_by(friction_angle, pi); };
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, 0.3, 1.0, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// Falling d from the axis to the end of the series, dense within the angle phi of the axis, where small phi have a
/// layer.
std::vector<double> places_of_profile(double friction_angle) {
  const double layer = std::tan(friction_angle);
  const double all = std::asinh((1.0 - 4.0 * series_end) / layer);
  std::vector<double> places;
  for (std::size_t i = 0; i <= intervals; ++i) {
    places.push_back(1.0 - layer * std::sinh(all * static_cast<double>(i) / static_cast<double>(intervals)));
  }
  places.back() = 4.0 * series_end;
  places.push_back(2.0 * series_end);
  places.push_back(series_end);
  return places;
}

double polynomial(const std::array<double, 3>& of, double d) { return of[0] + d * (of[1] + d * of[2]); }

}  // namespace

IncipientFailure::Profile IncipientFailure::solve(double friction_angle) {
  const Equilibrium equilibrium{friction_angle};
  Profile profile;
  auto state = on_axis(friction_angle, shoot(friction_angle));
  std::vector<State> states;
  const auto add = [&](double d, const State& there) {
    State change(2);
    equilibrium(there, change, d);
    profile.s.push_back(1.0 - d);
    profile.pi.push_back(there[0]);
    profile.pi_slope.push_back(-change[0]);
    profile.u.push_back(there[1]);
    profile.u_slope.push_back(-change[1]);
    states.push_back(there);
  };
  if (!integrate(friction_angle, state, places_of_profile(friction_angle), add,
                 [](const State& /*there*/) { return false; })) {
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
  const auto [place, fall] = boost::math::tools::brent_find_minima([&](double s) { return -normal(s); }, low, high, 40);
  return std::max({-fall, normal(0.0), *highest == place ? 0.0 : normal(*highest)});
}

}  // namespace repose::theory
