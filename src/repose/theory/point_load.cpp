// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/point_load.hpp"

#include <boost/math/special_functions/sinc.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace repose::theory {

namespace {

using std::numbers::pi;

/// Flamant's stress, or its average over a strip: Johnson (1985), eqs (2.23), (2.30). The difference of the angles to
/// the two ends of the strip is computed as one angle, which does not cancel for a narrow strip.
double half_plane(double x, double width) {
  if (width == 0.0) return 2.0 / (pi * (1.0 + x * x) * (1.0 + x * x));
  const double left = x + 0.5 * width;
  const double right = x - 0.5 * width;
  const double angle = std::atan2(width, 1.0 + left * right);
  const double rest = width * (1.0 - left * right) / ((1.0 + left * left) * (1.0 + right * right));
  return (angle + rest) / (pi * width);
}

/// The Fourier integral (1/pi) int_0^inf sinc(m a/2) T(m) cos(m x) dm as a sum over m = 2 pi k/L. By Poisson's formula
/// the sum is the stress of loads a distance L apart; the stress in a layer decays as exp(-1.5 |x|) or faster, so the
/// other loads do not matter.
double layer(const PointLoad& model, double x) {
  constexpr double nothing_beyond = 60.0;  // T < 1e-23
  const double apart = 2.0 * (std::abs(x) + model.load_width) + 60.0;
  const double step = 2.0 * pi / apart;
  double sum = 0.5;
  for (double k = 1.0; k * step < nothing_beyond; k += 1.0) {
    const double m = k * step;
    sum += boost::math::sinc_pi(0.5 * m * model.load_width) * floor_transfer(model, m) * std::cos(m * x);
  }
  return 2.0 * sum / apart;
}

}  // namespace

double floor_transfer(const PointLoad& model, double m) {
  // Hyperbolic functions divided by exp(m), which do not overflow.
  const double e = std::exp(-2.0 * m);
  const double c = 0.5 * (1.0 + e);
  const double s = 0.5 * (1.0 - e);
  const double decay = std::exp(-m);
  if (model.floor == "smooth-rigid") return m == 0.0 ? 1.0 : decay * (s + m * c) / (s * c + m * e);
  const double n = 2.0 * (1.0 - model.poisson);
  return decay * n * (n * c + m * s) / ((m * m + n * n) * e + (2.0 * n - 1.0) * s * s);
}

double elastic_stress(const PointLoad& model, double x_over_h) {
  return model.floor == "none" ? half_plane(x_over_h, model.load_width) : layer(model, x_over_h);
}

Rays rays(const PointLoad& model) {
  // The root without cancellation comes first; the product of the roots is -eta.
  const double larger = 0.5 * (std::abs(model.mu) + std::sqrt(model.mu * model.mu + 4.0 * model.eta));
  const double smaller = model.eta / larger;
  Rays both;
  both.right = model.mu >= 0.0 ? larger : smaller;
  both.left = model.mu >= 0.0 ? -smaller : -larger;
  both.weight_right = -both.left / (both.right - both.left);
  both.weight_left = both.right / (both.right - both.left);
  return both;
}

double osl_stress(const PointLoad& model, double x_over_h) {
  const auto box = [&](double from_middle) {
    const double beyond = std::abs(from_middle) - 0.5 * model.load_width;
    return beyond < 0.0 ? 1.0 / model.load_width : beyond == 0.0 ? 0.5 / model.load_width : 0.0;
  };
  const auto both = rays(model);
  return both.weight_left * box(x_over_h - both.left) + both.weight_right * box(x_over_h - both.right);
}

double diffusive_stress(const PointLoad& model, double x_over_h) {
  const double variance = model.diffusion / model.depth;
  if (model.load_width == 0.0) {
    return std::exp(-0.5 * x_over_h * x_over_h / variance) / std::sqrt(2.0 * pi * variance);
  }
  const double x = std::abs(x_over_h);  // so that erfc does not cancel in the tail
  const double scale = 1.0 / std::sqrt(2.0 * variance);
  const double near = std::erfc((x - 0.5 * model.load_width) * scale);
  const double far = std::erfc((x + 0.5 * model.load_width) * scale);
  return 0.5 * (near - far) / model.load_width;
}

void parameters(PointLoad& model, Parameters& to) {
  to.number("load_width", model.load_width, {.low = 0.0, .high = 100.0}, "h",
            "width of the strip that carries the force; 0: a point");
  to.choice("floor", model.floor, {"none", "smooth-rigid", "rough-rigid"},
            "floor of the elastic medium at depth h: none (half plane), or rigid and smooth or rough");
  to.number("poisson", model.poisson, {.low = 0.0, .high = 0.5}, "1",
            "Poisson's ratio in plane strain; only a rough floor depends on it");
  to.number("eta", model.eta, {.low = 0.0, .low_allowed = false}, "1", "eta of OSL, sxx = eta szz + mu sxz");
  to.number("mu", model.mu, {}, "1", "mu of OSL");
  to.number("depth", model.depth, {.low = 0.0, .low_allowed = false}, "d",
            "h in grain diameters, for the diffusive response");
  to.number("diffusion", model.diffusion, {.low = 0.0, .low_allowed = false}, "d",
            "variance of the diffusive response per depth; d/(2 sqrt 3) for two neighbours in a triangular lattice");
  to.number("half_range", model.half_range, {.low = 0.0, .high = 100.0, .low_allowed = false}, "h",
            "x goes from -half_range to half_range");
  to.integer("points", model.points, {.low = 2, .high = 1'000'000}, "positions along x");
}

Table evaluate(const PointLoad& model) {
  Column x{"x_over_h", "1", "horizontal distance from the load", {}, {}};
  Column elastic{"elastic", "F/h", "vertical stress of an isotropic elastic medium", {}, {}};
  Column osl{"osl", "F/h", "vertical stress of the closure sxx = eta szz + mu sxz: two rays", {}, {}};
  Column diffusive{"diffusive", "F/h", "vertical stress by diffusion, the mean of the q-model", {}, {}};
  for (std::int64_t i = 0; i < model.points; ++i) {
    const double fraction = static_cast<double>(2 * i - (model.points - 1)) / static_cast<double>(model.points - 1);
    const double at = fraction * model.half_range;
    x.values.push_back(at);
    elastic.values.push_back(elastic_stress(model, at));
    if (model.load_width > 0.0) osl.values.push_back(osl_stress(model, at));
    diffusive.values.push_back(diffusive_stress(model, at));
  }
  const auto both = rays(model);
  Table table{{std::move(x), std::move(elastic)},
              {{"ray_left", both.left, "h", "position of the left ray of OSL"},
               {"ray_right", both.right, "h", "position of the right ray"},
               {"weight_left", both.weight_left, "F", "force that the left ray carries"},
               {"weight_right", both.weight_right, "F", "force that the right ray carries"},
               {"elastic_peak", elastic_stress(model, 0.0), "F/h", "elastic stress directly below the load"},
               {"diffusive_deviation", std::sqrt(model.diffusion / model.depth), "h",
                "standard deviation of the diffusive response to a point load"}}};
  if (model.load_width > 0.0) table.columns.push_back(std::move(osl));
  table.columns.push_back(std::move(diffusive));
  return table;
}

}  // namespace repose::theory
