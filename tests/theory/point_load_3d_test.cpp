// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/point_load_3d.hpp"

#include "repose/theory/point_load.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace repose::theory {
namespace {

double integral_between(const std::function<double(double)>& f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 4, 1e-10);
}

const char* const rigid_floors[] = {"smooth-rigid", "rough-rigid"};

// A central difference with a step of 1e-3 has an error of 1e-12 of the fifth derivative.
double slope_at(const std::function<double(double)>& f, double x) {
  const double h = 1e-3;
  return (8.0 * (f(x + h) - f(x - h)) - f(x + 2.0 * h) + f(x - 2.0 * h)) / (12.0 * h);
}

// Stresses at the depth z are f(r/z)/z^2, so that d/dz at z = 1 is -2 f - r f'.
TEST(PointLoad3d, HalfSpaceIsInEquilibrium) {
  for (const double poisson : {0.0, 0.2, 0.5}) {
    const auto vertical = [&](double at) { return boussinesq(poisson, at).vertical; };
    const auto shear = [&](double at) { return boussinesq(poisson, at).shear; };
    const auto radial = [&](double at) { return boussinesq(poisson, at).radial; };
    for (const double r : {0.05, 0.4, 1.0, 3.0}) {
      const auto here = boussinesq(poisson, r);
      const double across =
          slope_at(radial, r) - 2.0 * here.shear - r * slope_at(shear, r) + (here.radial - here.hoop) / r;
      const double down = slope_at(shear, r) + here.shear / r - 2.0 * here.vertical - r * slope_at(vertical, r);
      EXPECT_NEAR(across, 0.0, 1e-9) << poisson << ' ' << r;
      EXPECT_NEAR(down, 0.0, 1e-9) << poisson << ' ' << r;
    }
    EXPECT_NEAR(boussinesq(poisson, 0.0).radial, boussinesq(poisson, 0.0).hoop, 1e-16);
    EXPECT_NEAR(boussinesq(poisson, 0.0).hoop, -(1.0 - 2.0 * poisson) / (4.0 * std::numbers::pi), 1e-16);
  }
}

// The sum of stresses is harmonic and equals 2 (1 + nu) cos(theta)/(2 pi R^2): Johnson (1985), from eq. (3.20).
TEST(PointLoad3d, SumOfStresses) {
  for (const double poisson : {0.0, 0.3, 0.5}) {
    for (const double r : {0.0, 0.7, 2.5}) {
      const auto here = boussinesq(poisson, r);
      EXPECT_NEAR(here.vertical + here.radial + here.hoop,
                  (1.0 + poisson) / (std::numbers::pi * std::pow(1.0 + r * r, 1.5)), 1e-15);
    }
  }
}

// An incompressible half space carries the load along straight lines: no other stress acts.
TEST(PointLoad3d, IncompressibleStressIsCentral) {
  for (const double r : {0.1, 1.0, 4.0}) {
    const auto here = boussinesq(0.5, r);
    EXPECT_NEAR(here.shear * here.shear, here.vertical * here.radial, 1e-15 * here.shear);
    EXPECT_EQ(here.hoop, 0.0);
  }
}

TEST(PointLoad3d, CarriesTheForce) {
  const auto ring = [](const PointLoad3d& model) {
    return [&model](double r) { return 2.0 * std::numbers::pi * r * vertical_stress(model, r); };
  };
  const PointLoad3d point{};
  for (const double r : {1e-3, 0.5, 2.0, 40.0}) {
    EXPECT_NEAR(integral_between(ring(point), 0.0, r), boussinesq_carried(r), 1e-9) << r;
  }
  EXPECT_NEAR(boussinesq_carried(1e-6), 1.5e-12, 1e-23);
  EXPECT_NEAR(boussinesq_carried(1e6), 1.0, 1e-15);
  // Stress in a layer falls as exp(-r) or faster: a fraction of 1e-9 is beyond r = 24.
  for (const char* floor : rigid_floors) {
    for (const double radius : {0.0, 0.4}) {
      const PointLoad3d layer{.load_radius = radius, .floor = floor};
      EXPECT_NEAR(integral_between(ring(layer), 0.0, 3.0) + integral_between(ring(layer), 3.0, 24.0), 1.0, 1e-7)
          << floor << radius;
    }
  }
}

TEST(PointLoad3d, PeakAndHalfWidth) {
  const auto table = evaluate(PointLoad3d{});
  EXPECT_NEAR(table.number("peak"), 1.5 / std::numbers::pi, 1e-15);
  EXPECT_NEAR(table.number("half_width"), std::sqrt(std::pow(2.0, 0.4) - 1.0), 1e-11);
  EXPECT_NEAR(table.number("plane_peak"), 2.0 / std::numbers::pi, 1e-15);
  EXPECT_NEAR(table.number("plane_half_width"), std::sqrt(std::numbers::sqrt2 - 1.0), 1e-11);
}

// A line of point loads is a line load: Flamant's stress in a half space, and the Fourier integral in a layer.
TEST(PointLoad3d, ALineOfPointsIsPlaneStrain) {
  for (const char* floor : {"none", "smooth-rigid", "rough-rigid"}) {
    const PointLoad3d point{.floor = floor, .poisson = 0.3};
    const PointLoad line{.load_width = 0.0, .floor = floor, .poisson = 0.3};
    for (const double x : {0.0, 0.6, 1.5}) {
      const auto stress = [&](double y) { return 2.0 * vertical_stress(point, std::hypot(x, y)); };
      double sum = integral_between(stress, 0.0, 3.0) + integral_between(stress, 3.0, 12.0);
      // Beyond y = 12 a half space has 3/(pi y^5), with corrections of order (1 + x^2)/y^2.
      if (point.floor == "none") sum += 3.0 / (4.0 * std::numbers::pi * std::pow(12.0, 4.0));
      EXPECT_NEAR(sum, elastic_stress(line, x), 2e-6) << floor << x;
    }
  }
}

// An evenly loaded disc: closed form on the axis (Johnson 1985, section 3.4), elsewhere a sum of point loads.
TEST(PointLoad3d, ADiscIsASumOfPoints) {
  for (const double a : {0.05, 0.5, 3.0}) {
    const PointLoad3d disc{.load_radius = a};
    EXPECT_NEAR(vertical_stress(disc, 0.0), (1.0 - std::pow(1.0 + a * a, -1.5)) / (std::numbers::pi * a * a), 1e-10)
        << a;
  }
  const double a = 0.7;
  const double r = 0.9;
  const auto ring = [&](double b) {
    const auto part = [&](double angle) {
      return boussinesq(0.25, std::hypot(r - b * std::cos(angle), b * std::sin(angle))).vertical;
    };
    return 2.0 * b * integral_between(part, 0.0, std::numbers::pi) / (std::numbers::pi * a * a);
  };
  EXPECT_NEAR(vertical_stress({.load_radius = a}, r), integral_between(ring, 0.0, a), 1e-10);
  // A disc of radius 1e-5 is a point, to the square of its radius: the integral and the closed form agree.
  EXPECT_NEAR(vertical_stress({.load_radius = 1e-5}, 1.3), boussinesq(0.25, 1.3).vertical, 1e-9);
}

TEST(PointLoad3d, ColumnsOfTheTable) {
  const auto table = evaluate(PointLoad3d{.points = 5});
  EXPECT_EQ(table.column("r_over_h").values.back(), 2.0);
  for (std::size_t i = 0; i < 5; ++i) {
    const double r = table.column("r_over_h").values[i];
    EXPECT_EQ(table.column("shear").values[i], boussinesq(0.25, r).shear);
    EXPECT_EQ(table.column("carried").values[i], boussinesq_carried(r));
  }
  EXPECT_FALSE(evaluate(PointLoad3d{.floor = "rough-rigid", .points = 2}).has_column("shear"));
}

}  // namespace
}  // namespace repose::theory
