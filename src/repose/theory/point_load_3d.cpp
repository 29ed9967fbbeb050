// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/point_load_3d.hpp"

#include "repose/theory/point_load.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace repose::theory {

namespace {

using std::numbers::pi;

bool is_closed(const PointLoad3d& model) { return model.floor == "none" && model.load_radius == 0.0; }

PointLoad in_plane_strain(const PointLoad3d& model) {
  return {.load_width = 2.0 * model.load_radius, .floor = model.floor, .poisson = model.poisson};
}

/// The amplitude at depth h of a pressure cos(m x) on the surface. A half space lets (1 + m) exp(-m) through.
double transfer(const PointLoad3d& model, double m) {
  return model.floor == "none" ? (1.0 + m) * std::exp(-m) : floor_transfer(in_plane_strain(model), m);
}

/// (1/2 pi) int_0^inf T(m) J0(m r) (2 J1(m a)/(m a)) m dm, on intervals no longer than a period of the integrand.
double hankel_integral(const PointLoad3d& model, double r) {
  constexpr double nothing_beyond = 60.0;  // m T(m) < 1e-20
  const double longest = std::min(2.0, 2.0 * pi / (r + model.load_radius + 1.0));
  const auto intervals = static_cast<std::int64_t>(std::ceil(nothing_beyond / longest));
  const double width = nothing_beyond / static_cast<double>(intervals);
  const auto integrand = [&](double m) {
    const double ma = m * model.load_radius;
    const double disc = ma < 1e-6 ? 1.0 : 2.0 * boost::math::cyl_bessel_j(1, ma) / ma;
    return transfer(model, m) * boost::math::cyl_bessel_j(0, m * r) * disc * m;
  };
  double sum = 0.0;
  for (std::int64_t i = 0; i < intervals; ++i) {
    const double from = static_cast<double>(i) * width;
    sum += boost::math::quadrature::gauss<double, 20>::integrate(integrand, from, from + width);
  }
  return sum / (2.0 * pi);
}

/// The distance at which a stress that falls with the distance is half of that below the load.
double half_width(const std::function<double(double)>& stress) {
  const double half = 0.5 * stress(0.0);
  double beyond = 1.0;
  while (stress(beyond) > half) beyond *= 2.0;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve([&](double r) { return stress(r) - half; }, 0.0, beyond,
                                                         boost::math::tools::eps_tolerance<double>(40), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

PlaneStresses boussinesq(double poisson, double r) {
  const double distance = std::hypot(1.0, r);
  const double fifth = std::pow(distance, 5.0);
  const double elastic = (1.0 - 2.0 * poisson) / (2.0 * pi);
  const double spread = 1.0 / (distance * (distance + 1.0));  // (1 - 1/distance)/r^2 without cancellation
  const double central = 1.5 / (pi * fifth);
  return {.vertical = central,
          .shear = central * r,
          .radial = central * r * r - elastic * spread,
          .hoop = elastic * (spread - 1.0 / (distance * distance * distance))};
}

double boussinesq_carried(double r) { return -std::expm1(-1.5 * std::log1p(r * r)); }

double vertical_stress(const PointLoad3d& model, double r) {
  return is_closed(model) ? boussinesq(model.poisson, r).vertical : hankel_integral(model, r);
}

void parameters(PointLoad3d& model, Parameters& to) {
  to.number("load_radius", model.load_radius, {.low = 0.0, .high = 100.0}, "h",
            "radius of the disc that carries the force evenly; 0: a point");
  to.choice("floor", model.floor, {"none", "smooth-rigid", "rough-rigid"},
            "floor of the elastic medium at depth h: none (half space), or rigid and smooth or rough");
  to.number("poisson", model.poisson, {.low = 0.0, .high = 0.5}, "1",
            "Poisson's ratio; the vertical stress depends on it only on a rough floor");
  to.number("range", model.range, {.low = 0.0, .high = 100.0, .low_allowed = false}, "h", "r goes from 0 to range");
  to.integer("points", model.points, {.low = 2, .high = 100'000}, "positions along r");
}

Table evaluate(const PointLoad3d& model) {
  Column r{"r_over_h", "1", "horizontal distance from the load", {}, {}};
  Column vertical{"vertical", "F/h^2", "sigma_zz at depth h", {}, {}};
  Column plane{"plane", "F/h", "sigma_zz at depth h of a line load, F per length (plane strain)", {}, {}};
  Column shear{"shear", "F/h^2", "sigma_rz, positive outward", {}, {}};
  Column radial{"radial", "F/h^2", "sigma_rr", {}, {}};
  Column hoop{"hoop", "F/h^2", "sigma_phiphi", {}, {}};
  Column carried{"carried", "1", "fraction of F carried within r", {}, {}};
  const auto line = in_plane_strain(model);
  for (std::int64_t i = 0; i < model.points; ++i) {
    const double at = model.range * static_cast<double>(i) / static_cast<double>(model.points - 1);
    r.values.push_back(at);
    vertical.values.push_back(vertical_stress(model, at));
    plane.values.push_back(elastic_stress(line, at));
    if (!is_closed(model)) continue;
    const auto stresses = boussinesq(model.poisson, at);
    shear.values.push_back(stresses.shear);
    radial.values.push_back(stresses.radial);
    hoop.values.push_back(stresses.hoop);
    carried.values.push_back(boussinesq_carried(at));
  }
  Table table{{std::move(r), std::move(vertical), std::move(plane)},
              {{"peak", vertical_stress(model, 0.0), "F/h^2", "vertical stress directly below the load"},
               {"half_width", half_width([&](double at) { return vertical_stress(model, at); }), "h",
                "distance at which the vertical stress is half the peak"},
               {"plane_peak", elastic_stress(line, 0.0), "F/h", "vertical stress below a line load"},
               {"plane_half_width", half_width([&](double at) { return elastic_stress(line, at); }), "h",
                "distance at which it is half of that"}}};
  if (is_closed(model)) {
    for (auto* column : {&shear, &radial, &hoop, &carried}) table.columns.push_back(std::move(*column));
  }
  return table;
}

}  // namespace repose::theory
