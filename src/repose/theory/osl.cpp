// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/osl.hpp"

#include "repose/core/numbers.hpp"
#include "repose/theory/incipient_failure.hpp"
#include "repose/theory/linear_wedge.hpp"
#include "repose/theory/wedge_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace repose::theory {

namespace {

constexpr double flattest_at_failure = 0.1;  // deg; smallest angle for which the solver of incipient failure is tested
constexpr double dip_of_rounding = 1e-9;     // numerical error of the depth of a dip

double slope_of(const Osl& model) { return radians(model.slope_deg.value_or(model.angle_deg)); }

LinearClosure closure_of(const Osl& model) {
  const double tan_friction = std::tan(radians(model.angle_deg));
  if (model.model == "fpa") return fixed_principal_axis(tan_friction);
  if (model.model == "bcc") return bouchaud_cates_claudin(tan_friction);
  const double mu = model.mu.value_or(no_number);
  return {.eta = model.eta.value_or(eta_of_surface_yield(mu, tan_friction)), .mu = mu};
}

/// The stress per depth and the yield margin on a ray; the margin does not depend on the depth.
struct RayState {
  WedgeStress stress;
  double margin;
};

RayState state_on(const LinearWedge& wedge, const Ray& ray, double sin_friction) {
  return {stress_on(wedge, ray), yield_margin(wedge, ray, sin_friction)};
}

/// The margin is computed from the stress, so it shows the accuracy of the solution. On the surface the stress
/// vanishes, and the margin is zero.
RayState state_on(const IncipientFailure& wedge, const Ray& ray, double sin_friction) {
  const auto stress = stress_on(wedge, ray);
  return {stress, ray.from_surface > 0.0 ? yield_margin(stress, sin_friction) : 0.0};
}

class Columns {
 public:
  Columns(std::vector<Column> coordinates, std::size_t rows) : columns_(std::move(coordinates)) {
    const std::string unit = "rho g h";
    columns_.push_back({"normal", unit, "sigma_zz, downward on the ground", {}, {}});
    columns_.push_back({"shear", unit, "sigma_xz, positive if the pile pushes the ground to the right", {}, {}});
    columns_.push_back({"horizontal", unit, "sigma_xx", {}, {}});
    columns_.push_back(
        {"yield_margin", "1", "1 - R/(P sin phi) of Mohr's circle; negative beyond Coulomb's limit", {}, {}});
    for (auto& column : columns_) column.values.reserve(rows);
  }

  void add(std::initializer_list<double> coordinates, const RayState& ray, double depth, double side) {
    std::size_t i = 0;
    for (const double coordinate : coordinates) columns_[i++].values.push_back(coordinate);
    for (const double value : {ray.stress.normal * depth, side * ray.stress.shear * depth + 0.0,
                               ray.stress.horizontal * depth, ray.margin}) {
      columns_[i++].values.push_back(value);
    }
  }

  std::vector<Column> take() { return std::move(columns_); }

 private:
  std::vector<Column> columns_;
};

template <class Wedge>
std::vector<Column> base_of(const Osl& model, const Wedge& wedge) {
  const double sin_friction = std::sin(radians(model.angle_deg));
  Columns columns{{{"x_over_b", "1", "position along the base, from the left foot", {}, {}}},
                  static_cast<std::size_t>(model.points)};
  for (std::int64_t i = 0; i < model.points; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(model.points - 1);
    const Ray ray{.from_axis = std::abs(2.0 * x - 1.0), .from_surface = 2.0 * std::min(x, 1.0 - x)};
    columns.add({x}, state_on(wedge, ray, sin_friction), 1.0, x < 0.5 ? -1.0 : 1.0);
  }
  return columns.take();
}

template <class Wedge>
std::vector<Column> field_of(const Osl& model, const Wedge& wedge) {
  const double sin_friction = std::sin(radians(model.angle_deg));
  const double foot = 1.0 / std::tan(slope_of(model));
  const auto grid = static_cast<double>(model.grid);
  Columns columns{{{"x_over_h", "1", "distance from the axis over the height, positive to the right", {}, {}},
                   {"z_over_h", "1", "depth below the apex over the height", {}, {}}},
                  static_cast<std::size_t>(model.grid * (model.grid + 2))};
  for (std::int64_t i = 1; i <= model.grid; ++i) {
    for (std::int64_t k = -i; k <= i; ++k) {
      const auto depth = static_cast<double>(i);
      const Ray ray{.from_axis = static_cast<double>(std::abs(k)) / depth,
                    .from_surface = static_cast<double>(i - std::abs(k)) / depth};
      const double x = static_cast<double>(k) / grid * foot;
      columns.add({x, depth / grid}, state_on(wedge, ray, sin_friction), depth / grid, k < 0 ? -1.0 : 1.0);
    }
  }
  return columns.take();
}

template <class Wedge>
std::vector<Column> columns_of(const Osl& model, const Wedge& wedge) {
  return model.output == "field" ? field_of(model, wedge) : base_of(model, wedge);
}

/// The numbers that both kinds of wedge have.
struct Summary {
  double eta = no_number;
  double mu = no_number;
  double lambda_plus = no_number;
  double lambda_minus = no_number;
  double s_inner = no_number;
  double centre = no_number;
  double peak = no_number;
  bool dip = false;
  double dip_depth = 0.0;
  YieldViolation yield;
};

Summary summary_of(const LinearWedge& wedge, double sin_friction) {
  // At the kink sigma_zz is that at the centre times 1 - mu T: a dip for any mu < 0.
  const double rise = -wedge.closure.mu * wedge.tan_slope;
  const bool dip = rise > 0.0;
  return {.eta = wedge.closure.eta,
          .mu = wedge.closure.mu,
          .lambda_plus = wedge.lambda_plus,
          .lambda_minus = wedge.lambda_minus,
          .s_inner = wedge.s_inner,
          .centre = wedge.centre.normal,
          .peak = wedge.centre.normal * (dip ? 1.0 + rise : 1.0),
          .dip = dip,
          .dip_depth = dip ? rise / (1.0 + rise) : 0.0,
          .yield = yield_violation(wedge, sin_friction)};
}

Summary summary_of(const IncipientFailure& wedge, double /*sin_friction*/) {
  const double centre = wedge.stress_on({.from_axis = 0.0, .from_surface = 1.0}).normal;
  const double peak = wedge.peak_normal();
  const double depth = 1.0 - centre / peak;
  const bool dip = depth > dip_of_rounding;
  return {.centre = centre,
          .peak = dip ? peak : centre,
          .dip = dip,
          .dip_depth = dip ? depth : 0.0,
          .yield = {0.0, no_number, no_number, 0.0}};
}

std::vector<Number> numbers_of(const Osl& model, const Summary& summary) {
  const auto& yield = summary.yield;
  return {
      {"eta", summary.eta, "1", "eta in the closure sigma_xx = eta sigma_zz + mu sign(x) sigma_xz"},
      {"mu", summary.mu, "1", "mu in the closure"},
      {"lambda_plus", summary.lambda_plus, "1", "outward characteristic x = lambda_plus z"},
      {"lambda_minus", summary.lambda_minus, "1", "inward characteristic"},
      {"weight", 1.0 / std::tan(slope_of(model)), "rho g h^2", "weight of the pile per thickness"},
      {"s_inner", summary.s_inner, "1", "reduced position of the kink: |x| over the half width there"},
      {"centre_normal", summary.centre, "rho g h", "normal stress on the base at the centre"},
      {"peak_normal", summary.peak, "rho g h", "largest normal stress on the base"},
      {"dip", summary.dip ? 1.0 : 0.0, "1", "1 if the normal stress has a minimum at the centre, else 0"},
      {"dip_depth", summary.dip_depth, "1", "1 - centre_normal / peak_normal"},
      {"yield_margin_min", yield.smallest_margin, "1", "smallest yield margin; negative: Coulomb's limit is exceeded"},
      {"violated_share", yield.fraction, "1", "fraction of the base where Coulomb's limit is exceeded"},
      {"core_violated_to", yield.core_to, "1", "it is exceeded from the axis to this reduced position"},
      {"flank_violated_from", yield.flank_from, "1", "it is exceeded from this reduced position to the surface"},
  };
}

template <class Wedge>
Table table_of(const Osl& model, const Wedge& wedge) {
  const auto summary = summary_of(wedge, std::sin(radians(model.angle_deg)));
  return {columns_of(model, wedge), numbers_of(model, summary)};
}

}  // namespace

void parameters(Osl& model, Parameters& to) {
  to.choice("model", model.model, {"fpa", "bcc", "ife", "custom"},
            "closure: fixed principal axis, Bouchaud-Cates-Claudin, incipient failure everywhere, or given mu and eta");
  to.number("angle_deg", model.angle_deg, {.low = 0.0, .high = 90.0, .low_allowed = false, .high_allowed = false},
            "deg", "friction angle");
  to.optional_number("slope_deg", model.slope_deg, {"", "angle_deg"},
                     {.low = 0.0, .high = 90.0, .low_allowed = false, .high_allowed = false}, "deg",
                     "slope of the surface");
  to.optional_number("mu", model.mu, {"", "by model"}, {.low = -1e6, .high = 1e6}, "1", "mu of model = custom");
  to.optional_number("eta", model.eta, {"", "by yield of a surface at the friction angle"},
                     {.low = 0.0, .high = 1e6, .low_allowed = false}, "1", "eta of model = custom");
  to.choice("output", model.output, {"base", "field"}, "stresses on the base, or in the whole pile");
  to.integer("points", model.points, {.low = 2, .high = 1'000'000}, "positions along the base, both feet included");
  to.integer("grid", model.grid, {.low = 2, .high = 2'000}, "depths of the field, which has grid (grid + 2) points");
}

std::vector<std::string> relations(const Osl& model) {
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
  // If both mu and eta are given, the friction angle does not enter the closure; it only sets the yield margin.
  const bool made_by_angle = !(custom && model.mu && model.eta);
  if (slope_deg > model.angle_deg && made_by_angle) {
    problems.push_back(fmt::format(
        "slope_deg = {}: must be <= angle_deg = {}, which sets the closure: no surface of cohesionless grains "
        "is steeper than the friction angle",
        slope_deg, model.angle_deg));
  } else if (model.model == "ife" && slope_deg < model.angle_deg) {
    problems.push_back(
        fmt::format("slope_deg = {}: must be angle_deg = {} with model = ife, whose surface is also at failure",
                    slope_deg, model.angle_deg));
  }
  if (model.model == "ife" && model.angle_deg < flattest_at_failure) {
    problems.push_back(
        fmt::format("angle_deg = {}: must be >= {} with model = ife, which has a layer this thin at the axis",
                    model.angle_deg, flattest_at_failure));
  }
  if (!custom || !problems.empty()) return problems;
  const auto closure = closure_of(model);
  const double tan_slope = std::tan(radians(slope_deg));
  if (!(closure.eta > 0.0)) {
    problems.push_back(
        fmt::format("mu = {}: must be < 1/tan(angle_deg) = {:.6g} if eta is not given: yield of a surface at "
                    "the friction angle gives eta = {:.6g}, which must be > 0",
                    closure.mu, 1.0 / std::tan(radians(model.angle_deg)), closure.eta));
  } else if (!(kink_margin(closure, tan_slope) > 0.0)) {
    problems.push_back(
        fmt::format("mu = {}, eta = {:.6g}: 1 - mu T - eta T^2 = {:.6g} must be > 0 with T = tan(slope): "
                    "the characteristic from the apex leaves the pile",
                    closure.mu, closure.eta, kink_margin(closure, tan_slope)));
  }
  return problems;
}

Table evaluate(const Osl& model) {
  if (model.model == "ife") return table_of(model, IncipientFailure{radians(model.angle_deg)});
  return table_of(model, linear_wedge(closure_of(model), std::tan(slope_of(model))));
}

}  // namespace repose::theory
