// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/height_fit.hpp"

#include "repose/core/errors.hpp"
#include "repose/results/registry.hpp"
#include "repose/sweep/csv_cells.hpp"
#include "repose/sweep/table.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

constexpr double no_number = Inference::none;

/// A measure of a point over its finished members.
EnsembleEstimate entry(const SweepTable& table, std::size_t point, const std::string& measure) {
  const auto found = std::find(table.measures.begin(), table.measures.end(), measure);
  if (found == table.measures.end()) return {};
  return table.entries[point][static_cast<std::size_t>(found - table.measures.begin())];
}

double chance_of(const theory::ScreeningFit& fit) {
  if (fit.degrees_of_freedom < 1) return no_number;
  return boost::math::gamma_q(0.5 * static_cast<double>(fit.degrees_of_freedom), 0.5 * fit.chi_square);
}

/// Gravity, where the measure is a force.
double per_mass(const std::string& measure, const Scene& scene) {
  const auto* known = find_measure(measure);
  return known != nullptr && known->unit == "M L/T^2" ? scene.gravity : 1.0;
}

void gather(const SweepPlan& plan, const SweepTable& table, const HeightPlan& wanted, HeightFit& fit) {
  std::vector<double> ratios, frictions, widths;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    const auto& name = plan.points[p].name;
    if (std::find(wanted.points.begin(), wanted.points.end(), name) == wanted.points.end()) continue;
    const auto height = entry(table, p, "column.height");
    const auto load = entry(table, p, wanted.measure);
    if (load.count < 2 || height.count < 2 || !(load.error > 0.0)) {
      fit.problem = fmt::format("point {} has fewer than two members with a load that scatters", name);
      return;
    }
    const double unit = per_mass(wanted.measure, plan.points[p].scene);
    fit.points.push_back(name);
    fit.data.height.push_back(height.mean);
    fit.data.mass.push_back(load.mean / unit);
    fit.data.error.push_back(load.error / unit);
    fit.mass_height.push_back(entry(table, p, "column.mass").mean / height.mean);
    fit.members += static_cast<double>(load.count);
    ratios.push_back(entry(table, p, "column.stress_ratio.mean").mean);
    frictions.push_back(std::fabs(entry(table, p, "column.friction").mean));
    // The radius of a cylinder has the place of the width in Janssen's law.
    const auto* const width = plan.points[p].scene.dimension == 2 ? "column.width" : "column.radius";
    widths.push_back(entry(table, p, width).mean);
  }
  fit.stress_ratio = mean_by_t(ratios);
  fit.friction = mean_of(frictions).mean;
  fit.width = mean_of(widths).mean;
  fit.mass_per_height = mean_of(fit.mass_height).mean;
}

double scale_of(const theory::ScreeningFit& fit) {
  const auto freedom = static_cast<double>(fit.degrees_of_freedom);
  return freedom >= 1.0 ? std::sqrt(std::max(1.0, fit.chi_square / freedom)) : 1.0;
}

double ratio_error(const theory::ScreeningFit& fit) {
  const double first = fit.lambda_1_error / fit.lambda_1;
  const double second = fit.lambda_2_error / fit.lambda_2;
  const double square = first * first + second * second - 2.0 * fit.correlation * first * second;
  return fit.lambda_1 / fit.lambda_2 * std::sqrt(std::max(0.0, square));
}

nlohmann::ordered_json number(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

}  // namespace

const std::vector<std::string>& height_fit_measures() {
  static const std::vector<std::string> names{
      "lambda",     "lambda_1",  "lambda_2", "ratio", "stress_ratio", "stress_ratio_direct", "stress_ratio_excess",
      "chance_one", "chance_two"};
  return names;
}

Inference infer(const HeightFit& fit, const std::string& measure) {
  if (!fit.problem.empty()) return {};
  const double freedom = fit.members - static_cast<double>(fit.points.size());
  const auto by_t = [&](double value, double error) {
    auto inference = value_by_t(value, error, freedom);
    inference.test = "fit";
    inference.count = fit.points.size();
    return inference;
  };
  const auto& one = fit.one;
  const auto& two = fit.two;
  if (measure == "lambda") return by_t(one.lambda_1, one.lambda_1_error * scale_of(one));
  if (measure == "lambda_1") return by_t(two.lambda_1, two.lambda_1_error * scale_of(two));
  if (measure == "lambda_2") return by_t(two.lambda_2, two.lambda_2_error * scale_of(two));
  if (measure == "ratio") return by_t(two.lambda_1 / two.lambda_2, ratio_error(two) * scale_of(two));
  if (measure == "stress_ratio") {
    const double ratio = fit.width / (2.0 * fit.friction * one.lambda_1);
    return by_t(ratio, ratio * one.lambda_1_error / one.lambda_1 * scale_of(one));
  }
  if (measure == "stress_ratio_direct") return fit.stress_ratio;
  if (measure == "stress_ratio_excess") {
    const auto fitted = infer(fit, "stress_ratio");
    return by_t(fitted.value - fit.stress_ratio.value, std::hypot(fitted.error, fit.stress_ratio.error));
  }
  // A chance is no estimate: it lies above or below a bound as it is.
  return by_t(measure == "chance_one" ? fit.chance_one : fit.chance_two, 0.0);
}

std::vector<HeightFit> fit_heights(const SweepPlan& plan, const SweepTable& table) {
  std::vector<HeightFit> fits;
  for (const auto& wanted : plan.fits) {
    HeightFit fit;
    fit.name = wanted.name;
    fit.sense = wanted.pushed_up ? -1.0 : 1.0;
    gather(plan, table, wanted, fit);
    if (fit.problem.empty()) {
      theory::ScreeningLaw law{.mass_per_height = fit.mass_per_height, .sense = fit.sense, .parameters = 1};
      try {
        fit.one = theory::fit_screening(law, fit.data);
        law.parameters = 2;
        fit.two = theory::fit_screening(law, fit.data);
        fit.chance_one = chance_of(fit.one);
        fit.chance_two = chance_of(fit.two);
      } catch (const InputError& error) {
        fit.problem = error.what();
      }
    }
    fits.push_back(std::move(fit));
  }
  return fits;
}

std::string heights_csv(const std::vector<HeightFit>& fits) {
  std::string text = "fit,point,height,mass,mass_error,column_mass,fitted_one,fitted_two\n";
  for (const auto& fit : fits) {
    for (std::size_t k = 0; k < fit.points.size(); ++k) {
      const auto fitted = [&](const theory::ScreeningFit& law) {
        return fit.problem.empty() ? csv_number(law.fitted[k]) : "";
      };
      text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_text(fit.name), csv_text(fit.points[k]),
                          csv_number(fit.data.height[k]), csv_number(fit.data.mass[k]), csv_number(fit.data.error[k]),
                          csv_number(fit.mass_height[k] * fit.data.height[k]), fitted(fit.one), fitted(fit.two));
    }
  }
  return text;
}

std::string heights_json(const std::vector<HeightFit>& fits) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& fit : fits) {
    nlohmann::ordered_json one{{"fit", fit.name}, {"problem", fit.problem}};
    one["direction"] = fit.sense > 0.0 ? "rest" : "pushed-up";
    one["points"] = fit.points;
    one["members"] = fit.members;
    one["mass_per_height"] = number(fit.mass_per_height);
    one["width"] = number(fit.width);
    one["friction"] = number(fit.friction);
    for (const auto& name : height_fit_measures()) {
      const auto inference = infer(fit, name);
      const bool chance = name.starts_with("chance");
      if (chance) {
        one[name] = number(inference.value);
        continue;
      }
      one[name] = {{"mean", number(inference.value)},
                   {"error", number(inference.error)},
                   {"low", number(inference.low)},
                   {"high", number(inference.high)}};
    }
    const auto add_law = [&](const char* name, const theory::ScreeningFit& law) {
      one[name] = {{"chi_square", number(law.chi_square)},
                   {"degrees_of_freedom", law.degrees_of_freedom},
                   {"rms_residual", number(law.rms_residual)},
                   {"correlation", number(law.correlation)}};
    };
    add_law("one_length", fit.one);
    add_law("two_lengths", fit.two);
    all.push_back(std::move(one));
  }
  return all.dump(2) + "\n";
}

}  // namespace repose
