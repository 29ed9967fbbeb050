// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/incipient_failure.hpp"

#include "repose/core/numbers.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace repose::theory {
namespace {

using std::numbers::pi;

Ray ray_at(double s) { return {.from_axis = s, .from_surface = 1.0 - s}; }

// sigma_zz on the axis from another method: Chebyshev collocation of the two equations in pi and u with 60 and 80
// points and Newton's method, in numpy. Both numbers of points agree in the given digits.
TEST(IncipientFailure, AxisStressOfCollocation) {
  constexpr std::array<std::pair<double, double>, 9> reference{{{5.0, 0.944340177023},
                                                                {10.0, 0.899870143636},
                                                                {20.0, 0.834273973568},
                                                                {30.0, 0.789429929611},
                                                                {40.0, 0.758010860772},
                                                                {50.0, 0.735847255491},
                                                                {60.0, 0.720456495773},
                                                                {70.0, 0.710330660746},
                                                                {80.0, 0.704571884293}}};
  for (const auto& [degrees, normal] : reference) {
    const IncipientFailure wedge{radians(degrees)};
    EXPECT_NEAR(wedge.stress_on(ray_at(0.0)).normal, normal, 2e-12) << degrees;
    EXPECT_NEAR(wedge.peak_normal(), normal, 2e-12) << degrees;  // it is largest on the axis
  }
}

// Equilibrium of sigma = z P(xi) (1 + s cos 2psi), ... in xi = x/z, without the substitution that makes it regular at
// the surface: a11 P' + a12 P psi' = 1 - P (1 + s C), a21 P' + a22 P psi' = -P s S.
std::array<double, 2> change(double xi, const std::array<double, 2>& state, double s) {
  const auto [p, psi] = state;
  const double cosine = std::cos(2.0 * psi);
  const double sine = std::sin(2.0 * psi);
  const double a11 = -xi * (1.0 + s * cosine) + s * sine;
  const double a12 = 2.0 * s * (xi * sine + cosine) * p;
  const double a21 = -xi * s * sine + 1.0 - s * cosine;
  const double a22 = 2.0 * s * (sine - xi * cosine) * p;
  const double r1 = 1.0 - p * (1.0 + s * cosine);
  const double r2 = -p * s * sine;
  const double determinant = a11 * a22 - a12 * a21;
  return {(r1 * a22 - r2 * a12) / determinant, (a11 * r2 - a21 * r1) / determinant};
}

// Classical Runge-Kutta from the axis with 20 000 steps. The errors are those of rounding, which grow towards the
// surface as 1/(1 - S). With a wrong stress on the axis P does not vanish on the surface.
TEST(IncipientFailure, SolvesTheOriginalEquations) {
  for (const double degrees : {3.0, 10.0, 27.5, 45.0, 50.0, 79.0}) {
    const IncipientFailure wedge{radians(degrees)};
    const double s = std::sin(radians(degrees));
    const double foot = 1.0 / std::tan(radians(degrees));
    std::array<double, 2> state{wedge.stress_on(ray_at(0.0)).normal / (1.0 + s), 0.0};
    constexpr int steps = 20'000;
    const double step = foot / steps;
    const auto moved = [&](const std::array<double, 2>& by, double h) {
      return std::array<double, 2>{state[0] + h * by[0], state[1] + h * by[1]};
    };
    for (int i = 0; i < steps * 99 / 100; ++i) {
      const double xi = step * i;
      const auto k1 = change(xi, state, s);
      const auto k2 = change(xi + 0.5 * step, moved(k1, 0.5 * step), s);
      const auto k3 = change(xi + 0.5 * step, moved(k2, 0.5 * step), s);
      const auto k4 = change(xi + step, moved(k3, step), s);
      for (std::size_t j = 0; j < 2; ++j) state[j] += step / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
      if (i % 500 != 0) continue;
      const auto stress = wedge.stress_on(ray_at((i + 1.0) / steps));
      EXPECT_NEAR(stress.normal, state[0] * (1.0 + s * std::cos(2.0 * state[1])), 1e-10) << degrees << ' ' << i;
      EXPECT_NEAR(stress.shear, state[0] * s * std::sin(2.0 * state[1]), 1e-10) << degrees << ' ' << i;
      EXPECT_NEAR(stress.horizontal, state[0] * (1.0 - s * std::cos(2.0 * state[1])), 1e-10) << degrees << ' ' << i;
    }
  }
}

// The equilibrium of the whole pile, which the solution does not use.
TEST(IncipientFailure, BaseCarriesTheWeight) {
  for (const double degrees : {0.1, 0.2, 1.0, 2.0, 7.7, 15.0, 22.2, 30.0, 38.0, 45.0, 52.0, 66.0, 80.0, 88.0}) {
    const IncipientFailure wedge{radians(degrees)};
    const auto normal = [&](double s) { return wedge.stress_on(ray_at(s)).normal; };
    double weight = 0.0;
    for (int i = 0; i < 64; ++i) {
      weight +=
          boost::math::quadrature::gauss_kronrod<double, 15>::integrate(normal, i / 64.0, (i + 1) / 64.0, 4, 1e-13);
    }
    EXPECT_NEAR(weight, 0.5, 1e-10) << degrees;
  }
}

TEST(IncipientFailure, IsAtYieldEverywhere) {
  for (const double degrees : {1.0, 17.0, 30.0, 45.0, 80.0}) {
    const IncipientFailure wedge{radians(degrees)};
    for (int i = 0; i < 1000; ++i) {
      const auto stress = wedge.stress_on(ray_at(i / 1000.0));
      EXPECT_NEAR(yield_margin(stress, std::sin(radians(degrees))), 0.0, 1e-13) << degrees << ' ' << i;
    }
  }
}

// Near the surface the stress is that of the outer region of the linear closures, (1 + s^2, s c, c^2)(1 - S), with the
// corrections pi - 1 = -(4/3) s^2 (1 - S) and -(2/3) s c (1 - S) of psi.
TEST(IncipientFailure, TouchesTheSurfaceAsDerived) {
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const IncipientFailure wedge{radians(degrees)};
    const double s = std::sin(radians(degrees));
    const double c = std::cos(radians(degrees));
    for (const double d : {1e-6, 1e-4, 1.99e-3, 2.01e-3, 7.99e-3, 8.01e-3}) {
      const auto stress = wedge.stress_on({.from_axis = 1.0 - d, .from_surface = d});
      const double pressure = 0.5 * (stress.normal + stress.horizontal) / d;
      const double psi = 0.5 * std::atan2(2.0 * stress.shear, stress.normal - stress.horizontal);
      EXPECT_NEAR(pressure, 1.0 - 4.0 / 3.0 * s * s * d, 3.0 * d * d) << degrees << ' ' << d;
      EXPECT_NEAR(psi, 0.25 * pi - 0.5 * radians(degrees) - 2.0 / 3.0 * s * c * d, 3.0 * d * d + 1e-15) << degrees;
    }
    const auto surface = wedge.stress_on({.from_axis = 1.0, .from_surface = 0.0});
    EXPECT_EQ(surface.normal, 0.0);
    EXPECT_EQ(surface.shear, 0.0);
    const auto near = wedge.stress_on({.from_axis = 1.0 - 1e-9, .from_surface = 1e-9});
    EXPECT_NEAR(near.normal / 1e-9, 1.0 + s * s, 1e-8);
    EXPECT_NEAR(near.shear / 1e-9, s * c, 1e-8);
    EXPECT_NEAR(near.horizontal / 1e-9, c * c, 1e-8);
  }
}

}  // namespace
}  // namespace repose::theory
