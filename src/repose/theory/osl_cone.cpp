// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/osl_cone.hpp"

#include "repose/core/numbers.hpp"
#include "repose/theory/cone_stress.hpp"
#include "repose/theory/linear_wedge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace repose::theory {

namespace {

constexpr double error_of_solver = 1e-8;  // of a margin or the depth of a dip

double tan_slope_of(const OslCone& model) { return std::tan(radians(model.slope_deg.value_or(model.angle_deg))); }

ConeClosure closure_of(const OslCone& model) {
  const double tan_friction = std::tan(radians(model.angle_deg));
  ConeClosure closure;
  if (model.hoop == "minor") closure.hoop = Hoop::minor;
  if (model.hoop == "mean") closure.hoop = Hoop::mean;
  if (model.model == "fpa") {
    closure.radial = fixed_principal_axis(tan_friction);
  } else if (model.model == "bcc") {
    closure.radial = bouchaud_cates_claudin(tan_friction);
  } else {
    const double mu = model.mu.value_or(no_number);
    closure.radial = {.eta = model.eta.value_or(eta_of_surface_yield(mu, tan_friction)), .mu = mu};
  }
  return closure;
}

double without_rounding(double value) { return std::abs(value) < error_of_solver ? 0.0 : value; }

std::vector<Column> columns_of(const OslCone& model, const ConeStress& cone) {
  const double sin_friction = std::sin(radians(model.angle_deg));
  const std::string unit = "rho g h";
  std::vector<Column> columns = {
      {"r_over_R", "1", "distance from the axis over the radius of the base", {}, {}},
      {"normal", unit, "sigma_zz, downward on the ground", {}, {}},
      {"shear", unit, "sigma_rz, positive if the pile pushes the ground outward", {}, {}},
      {"radial", unit, "sigma_rr", {}, {}},
      {"hoop", unit, "sigma_phiphi", {}, {}},
      {"yield_margin",
       "1",
       "1 - R/(P sin phi) of Mohr's circle in the r-z plane; negative beyond Coulomb's limit",
       {},
       {}}};
  const auto last = static_cast<double>(model.points - 1);
  for (std::int64_t i = 0; i < model.points; ++i) {
    const Ray ray{.from_axis = static_cast<double>(i) / last,
                  .from_surface = static_cast<double>(model.points - 1 - i) / last};
    const auto stress = cone.stress_on(ray);
    const double margin = without_rounding(cone.margin_on(ray, sin_friction));
    std::size_t column = 0;
    for (const double value :
         {ray.from_axis, stress.normal, stress.shear, stress.horizontal, cone.hoop_on(ray), margin}) {
      columns[column++].values.push_back(value);
    }
  }
  return columns;
}

std::vector<Number> numbers_of(const OslCone& model, const ConeStress& cone) {
  const double tan_slope = tan_slope_of(model);
  const auto closure = closure_of(model);
  const auto& wedge = cone.wedge();
  const auto peak = cone.peak();
  const double centre = cone.stress_on({.from_axis = 0.0, .from_surface = 1.0}).normal;
  const double depth = without_rounding(1.0 - centre / peak.normal);
  const double margin = without_rounding(cone.smallest_margin(std::sin(radians(model.angle_deg))));
  return {
      {"eta", closure.radial.eta, "1", "eta in the closure sigma_rr = eta sigma_zz + mu sigma_rz"},
      {"mu", closure.radial.mu, "1", "mu in the closure"},
      {"lambda_plus", wedge.lambda_plus, "1", "outward characteristic r = lambda_plus z"},
      {"lambda_minus", wedge.lambda_minus, "1", "inward characteristic"},
      {"weight", std::numbers::pi / (3.0 * tan_slope * tan_slope), "rho g h^3", "weight of the pile"},
      {"s_inner", wedge.s_inner, "1", "r/R of the characteristic from the apex"},
      {"centre_normal", centre, "rho g h", "normal stress on the base at the centre"},
      {"peak_normal", peak.normal, "rho g h", "largest normal stress on the base"},
      {"peak_at", depth > 0.0 ? peak.s : 0.0, "1", "r/R of the largest normal stress"},
      {"dip", depth > 0.0 ? 1.0 : 0.0, "1", "1 if the largest normal stress is not at the centre, else 0"},
      {"dip_depth", depth, "1", "1 - centre_normal / peak_normal"},
      {"yield_margin_min", margin, "1", "smallest yield margin; negative: Coulomb's limit is exceeded"},
      {"weight_error", 6.0 * cone.normal_force() - 1.0, "1", "force on the base over the weight, minus 1"},
      {"half_cone_error", cone.half_cone_ratio() - 1.0, "1",
       "hoop force on a plane through the axis over the shear force on half the base, minus 1"},
  };
}

}  // namespace

void parameters(OslCone& model, Parameters& to) {
  to.choice("model", model.model, {"fpa", "bcc", "custom"},
            "closure: fixed principal axis, Bouchaud-Cates-Claudin, or given mu and eta");
  to.choice("hoop", model.hoop, {"radial", "minor", "mean"},
            "hoop stress: the radial stress, or the minor or the mean principal stress in the r-z plane");
  to.number("angle_deg", model.angle_deg, {.low = 1.0, .high = 80.0}, "deg", "friction angle");
  to.optional_number("slope_deg", model.slope_deg, {"", "angle_deg"}, {.low = 1.0, .high = 80.0}, "deg",
                     "slope of the surface");
  to.optional_number("mu", model.mu, {"", "by model"}, {.low = -1e3, .high = 1e3}, "1", "mu of model = custom");
  to.optional_number("eta", model.eta, {"", "by yield of a surface at the friction angle"},
                     {.low = 0.0, .high = 1e3, .low_allowed = false}, "1", "eta of model = custom");
  to.integer("points", model.points, {.low = 2, .high = 1'000'000},
             "positions from the centre of the base to its foot");
}

std::vector<std::string> relations(const OslCone& model) {
  std::vector<std::string> problems;
  const bool custom = model.model == "custom";
  for (const auto& [name, value] : {std::pair{"mu", model.mu}, std::pair{"eta", model.eta}}) {
    if (value && !custom) {
      problems.push_back(
          fmt::format("{} = {}: only for model = custom; model = {} has its own", name, *value, model.model));
    }
  }
  if (custom && !model.mu) problems.emplace_back("mu: must be given with model = custom");
  const double slope_deg = model.slope_deg.value_or(model.angle_deg);
  if (slope_deg > model.angle_deg && !(model.mu && model.eta)) {
    problems.push_back(fmt::format(
        "slope_deg = {}: must be <= angle_deg = {}, which sets the closure: no surface of cohesionless grains "
        "is steeper than the friction angle",
        slope_deg, model.angle_deg));
  }
  if (!problems.empty()) return problems;
  const auto closure = closure_of(model);
  const auto [eta, mu] = closure.radial;
  if (!(eta > 0.0)) {
    problems.push_back(
        fmt::format("mu = {}: must be < 1/tan(angle_deg) = {:.6g} if eta is not given: yield of a surface at "
                    "the friction angle gives eta = {:.6g}, which must be > 0",
                    mu, 1.0 / std::tan(radians(model.angle_deg)), eta));
  } else if (!(kink_margin(closure.radial, tan_slope_of(model)) > 0.0)) {
    problems.push_back(
        fmt::format("mu = {}, eta = {:.6g}: 1 - mu T - eta T^2 = {:.6g} must be > 0 with T = tan(slope): "
                    "the characteristic from the apex leaves the pile",
                    mu, eta, kink_margin(closure.radial, tan_slope_of(model))));
  }
  if (!is_regular_on_axis(closure)) {
    problems.push_back(fmt::format(
        "hoop = {}: with eta = {:.6g} it differs from the radial stress on the axis, where the two must be equal; "
        "hoop = {}",
        model.hoop, eta, model.hoop == "mean" ? "mean needs eta = 1, as of model = fpa" : "minor needs eta <= 1"));
  }
  return problems;
}

Table evaluate(const OslCone& model) {
  const ConeStress cone{closure_of(model), tan_slope_of(model)};
  return {columns_of(model, cone), numbers_of(model, cone)};
}

}  // namespace repose::theory
