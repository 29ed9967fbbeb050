// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/point_load.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace repose::theory {
namespace {

using std::numbers::pi;

double integral(const std::function<double(double)>& f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, from, to, 3, 1e-12);
}

const char* const floors[] = {"none", "smooth-rigid", "rough-rigid"};

// The stress under a strip carries the whole force and is symmetric about the load.
TEST(PointLoad, CarriesTheForce) {
  for (const char* floor : floors) {
    for (const double width : {0.0, 0.1, 1.5}) {
      const PointLoad model{.load_width = width, .floor = floor};
      const auto stress = [&](double x) { return elastic_stress(model, x); };
      // Beyond x = 12 a half plane carries 2/(3 pi 12^3), with corrections of order 1/x^2; a layer carries 1e-7 of
      // that.
      const double tail = model.floor == "none" ? 2.0 / (3.0 * pi * 1728.0) : 0.0;
      EXPECT_NEAR(integral(stress, 0.0, 0.5 * width) + integral(stress, 0.5 * width, 3.0) + integral(stress, 3.0, 12.0),
                  0.5 - tail, 3e-6)
          << floor << width;
      EXPECT_EQ(elastic_stress(model, 0.7), elastic_stress(model, -0.7)) << floor;
    }
  }
}

// A strip is a sum of point loads.
TEST(PointLoad, StripIsASumOfPoints) {
  for (const char* floor : floors) {
    const PointLoad point{.load_width = 0.0, .floor = floor};
    const PointLoad strip{.load_width = 0.8, .floor = floor};
    for (const double x : {0.0, 0.3, 0.4, 1.7}) {
      const auto stress = [&](double at) { return elastic_stress(point, x - at); };
      EXPECT_NEAR(elastic_stress(strip, x), integral(stress, -0.4, 0.4) / 0.8, 1e-12) << floor << x;
      const auto gauss = [&](double at) { return diffusive_stress(point, x - at); };
      EXPECT_NEAR(diffusive_stress(strip, x), integral(gauss, -0.4, 0.4) / 0.8, 1e-12) << x;
    }
  }
}

using Matrix = std::array<std::array<double, 4>, 4>;

Matrix identity() {
  Matrix one{};
  for (std::size_t i = 0; i < 4; ++i) one[i][i] = 1.0;
  return one;
}

Matrix product(const Matrix& a, const Matrix& b, double factor) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += factor * a[i][k] * b[k][j];
    }
  }
  return c;
}

/// The stress on the floor of a layer per stress on its surface, from displacements: G, lambda of plane strain,
/// u = U(y) sin mx, v = V(y) cos mx. Their equations are a linear system of first order in y, whose matrix exponential
/// leads from the floor to the surface. The solution is independent of the stress function of the code.
double transfer_by_displacements(double m, double poisson, bool rough) {
  const double shear = 1.0;
  const double lambda = 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
  const double along = lambda + 2.0 * shear;
  // State (U, V, T, S): sxy = T sin mx, syy = S cos mx.
  // U' = T/G + m V; V' = (S - lambda m U)/(lambda + 2G); sxx = (lambda + 2G) m U + lambda V';
  // equilibrium: d sxx/dx + d sxy/dy = 0, d sxy/dx + d syy/dy = 0.
  Matrix a{};
  a[0][2] = 1.0 / shear;
  a[0][1] = m;
  a[1][3] = 1.0 / along;
  a[1][0] = -lambda * m / along;
  a[2][0] = m * m * (along - lambda * lambda / along);
  a[2][3] = m * lambda / along;
  a[3][2] = -m;
  const int doublings = 12;  // Taylor to order 8 over m/4096: exact to rounding
  Matrix all = identity();
  Matrix term = identity();
  for (int k = 1; k <= 8; ++k) {
    term = product(term, a, 1.0 / (static_cast<double>(k) * 4096.0));
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) all[i][j] += term[i][j];
    }
  }
  for (int k = 0; k < doublings; ++k) all = product(all, all, 1.0);
  // Unknown at a rough floor: T, S; at a smooth floor: U, S. At the surface T = 0, S = 1.
  const std::size_t free = rough ? 2 : 0;
  return all[2][free] / (all[2][free] * all[3][3] - all[2][3] * all[3][free]);
}

TEST(PointLoad, LayerEqualsTheEquationsOfDisplacement) {
  for (const double m : {0.05, 0.6, 1.7, 4.0, 9.0}) {
    for (const double poisson : {0.0, 0.125, 0.3, 0.49}) {
      EXPECT_NEAR(floor_transfer({.floor = "rough-rigid", .poisson = poisson}, m),
                  transfer_by_displacements(m, poisson, true), 1e-9)
          << m << ' ' << poisson;
      EXPECT_NEAR(floor_transfer({.floor = "smooth-rigid", .poisson = poisson}, m),
                  transfer_by_displacements(m, poisson, false), 1e-9)
          << m << ' ' << poisson;
    }
  }
}

// The sum over waves against quadrature of the Fourier integral, and Flamant's closed form against the transfer
// function (1 + m) e^-m.
TEST(PointLoad, LayerEqualsItsFourierIntegral) {
  for (const char* floor : {"smooth-rigid", "rough-rigid"}) {
    const PointLoad model{.load_width = 0.2, .floor = floor};
    for (const double x : {0.0, 0.5, 3.0}) {
      const auto wave = [&](double m) {
        const double strip = m == 0.0 ? 1.0 : std::sin(0.1 * m) / (0.1 * m);
        return strip * floor_transfer(model, m) * std::cos(m * x) / pi;
      };
      EXPECT_NEAR(elastic_stress(model, x), integral(wave, 0.0, 10.0) + integral(wave, 10.0, 45.0), 1e-12) << floor;
    }
  }
  const PointLoad flamant{.load_width = 0.0};
  for (const double x : {0.0, 0.5, 3.0}) {
    const auto wave = [&](double m) { return (1.0 + m) * std::exp(-m) * std::cos(m * x) / pi; };
    EXPECT_NEAR(elastic_stress(flamant, x), integral(wave, 0.0, 10.0) + integral(wave, 10.0, 45.0), 1e-12) << x;
  }
}

// A rigid floor increases the peak above the 2/pi of the half plane; a rough floor, which carries shear, increases it
// less. A wide load has the same stress on the floor as on the surface.
TEST(PointLoad, Limits) {
  EXPECT_NEAR(elastic_stress({.load_width = 0.0}, 0.0), 2.0 / pi, 1e-15);
  EXPECT_NEAR(elastic_stress({.load_width = 1e-7}, 0.3), elastic_stress({.load_width = 0.0}, 0.3), 1e-14);
  const double smooth = elastic_stress({.load_width = 0.0, .floor = "smooth-rigid"}, 0.0);
  const double rough = elastic_stress({.load_width = 0.0, .floor = "rough-rigid"}, 0.0);
  EXPECT_GT(rough, 1.2 * 2.0 / pi);
  EXPECT_GT(smooth, 1.1 * rough);
  EXPECT_LT(smooth, 1.0);
  for (const char* floor : floors) {
    EXPECT_NEAR(50.0 * elastic_stress({.load_width = 50.0, .floor = floor}, 0.0), 1.0, 1e-4) << floor;
  }
}

// The two rays carry the force F, no moment and no horizontal force, and there is no stress elsewhere. They solve the
// wave equation (d_z - c+ d_x)(d_z - c- d_x) with c+ + c- = mu, c+ c- = -eta.
TEST(PointLoad, RaysBalanceTheForce) {
  for (const double mu : {-1.3, 0.0, 0.4, 1e4}) {
    for (const double eta : {0.05, 1.0 / 3.0, 2.0}) {
      const PointLoad model{.load_width = 0.01, .eta = eta, .mu = mu};
      const auto r = rays(model);
      EXPECT_LT(r.left, 0.0);
      EXPECT_GT(r.right, 0.0);
      EXPECT_NEAR(r.weight_left + r.weight_right, 1.0, 1e-15);
      EXPECT_NEAR(r.weight_left * r.left + r.weight_right * r.right, 0.0, 1e-15);
      EXPECT_NEAR(r.left + r.right, mu, 1e-12 * std::abs(mu) + 1e-15);
      EXPECT_NEAR(r.left * r.right, -eta, 1e-14 * eta);
      EXPECT_NEAR(osl_stress(model, r.right + 0.004), 100.0 * r.weight_right, 1e-10 * r.weight_right);
      EXPECT_NEAR(osl_stress(model, r.left - 0.004), 100.0 * r.weight_left, 1e-10);
      EXPECT_EQ(osl_stress(model, r.right + 0.006), 0.0);
      EXPECT_EQ(osl_stress(model, 0.5 * (r.left + r.right)), 0.0);
    }
  }
}

// The rays of the triangular lattice are at 30 degrees from the vertical.
TEST(PointLoad, RaysOfTheLattice) {
  const auto r = rays({.eta = 1.0 / 3.0});
  EXPECT_NEAR(r.right, std::tan(pi / 6.0), 1e-15);
  EXPECT_NEAR(r.weight_left, 0.5, 1e-15);
}

// Two equal probabilities in each of D rows of a triangular lattice, sqrt(3)/2 apart: a binomial with variance D/4.
TEST(PointLoad, DiffusionIsTheBinomialOfTheQModel) {
  const double rows = 4000.0;
  const double depth = rows * std::numbers::sqrt3 / 2.0;
  const PointLoad model{.load_width = 0.0, .depth = depth};
  for (const double k : {0.0, 20.0, 60.0}) {  // steps more to the right than to the left: x = k/2
    const double log_chance = std::lgamma(rows + 1.0) - std::lgamma(0.5 * (rows + k) + 1.0) -
                              std::lgamma(0.5 * (rows - k) + 1.0) - rows * std::numbers::ln2;
    EXPECT_NEAR(diffusive_stress(model, 0.5 * k / depth), depth * std::exp(log_chance),
                1e-3 * depth * std::exp(log_chance));
  }
}

}  // namespace
}  // namespace repose::theory
