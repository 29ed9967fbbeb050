// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/comparison/base_comparison.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace repose {

namespace {

constexpr double threshold = 0.1;           // of the largest force: the loaded interval ends there, as in base_dip
constexpr double rounding = 1e-9;           // of the half-width: the outermost loaded discs lie on its ends
constexpr std::int64_t matched_normal = 3;  // weight, centre and width are those of the measured normal force

constexpr const char* columns[] = {"x_over_b", "normal", "shear"};

bool has_base_force(const theory::Table& table) {
  return std::ranges::all_of(columns, [&](const char* name) { return table.has_column(name); });
}

/// Straight lines through points of ascending x; zero outside them.
class Polyline {
 public:
  Polyline(const std::vector<double>& x, const std::vector<double>& y) : x_(x), y_(y), area_(x.size(), 0.0) {
    for (std::size_t k = 1; k < x.size(); ++k) {
      area_[k] = area_[k - 1] + 0.5 * (y[k - 1] + y[k]) * (x[k] - x[k - 1]);
    }
  }

  double integral() const { return area_.back(); }
  double integral(double from, double to) const { return area_up_to(to) - area_up_to(from); }

  /// The outermost places above a height that the line reaches.
  double first_above(double height) const {
    std::size_t k = 0;
    while (!(y_[k] > height)) ++k;
    return k == 0 ? x_[0] : crossing(k - 1, k, height);
  }
  double last_above(double height) const {
    auto k = y_.size() - 1;
    while (!(y_[k] > height)) --k;
    return k + 1 == y_.size() ? x_[k] : crossing(k + 1, k, height);
  }

 private:
  double crossing(std::size_t below, std::size_t above, double height) const {
    return x_[below] + (x_[above] - x_[below]) * (height - y_[below]) / (y_[above] - y_[below]);
  }

  double area_up_to(double x) const {
    if (!(x > x_.front())) return 0.0;
    if (x >= x_.back()) return area_.back();
    const auto next = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin());
    const double part = x - x_[next - 1];
    const double slope = (y_[next] - y_[next - 1]) / (x_[next] - x_[next - 1]);
    return area_[next - 1] + part * (y_[next - 1] + 0.5 * slope * part);
  }

  const std::vector<double>& x_;
  const std::vector<double>& y_;
  std::vector<double> area_;  // from the first point up to each
};

void check(const std::string& model, const theory::Table& table) {
  const auto& x = table.column("x_over_b").values;
  const auto finite = [&](const char* name) {
    return std::ranges::all_of(table.column(name).values, [](double value) { return std::isfinite(value); });
  };
  if (x.size() < 2 || !std::ranges::all_of(columns, finite) || !std::ranges::is_sorted(x)) {
    throw InputError(fmt::format("{}: has no base force to compare with a heap at these parameters", model));
  }
  const auto& normal = table.column("normal").values;
  if (!(*std::ranges::max_element(normal) > 0.0) || !(Polyline(x, normal).integral() > 0.0)) {
    throw InputError(fmt::format("{}: carries no weight at these parameters", model));
  }
}

/// The ends of the parts of the base that belong to the discs, one more than the discs.
std::vector<double> ends_of(const std::vector<double>& x) {
  std::vector<double> ends{1.5 * x[0] - 0.5 * x[1]};
  for (std::size_t k = 1; k < x.size(); ++k) ends.push_back(0.5 * (x[k - 1] + x[k]));
  ends.push_back(1.5 * x[x.size() - 1] - 0.5 * x[x.size() - 2]);
  return ends;
}

Agreement agreement(const std::vector<double>& residual, const std::vector<double>& error, double mean_normal,
                    std::int64_t matched) {
  Agreement result;
  double squares = 0.0;
  for (std::size_t k = 0; k < residual.size(); ++k) {
    squares += residual[k] * residual[k];
    if (!(error[k] > 0.0)) continue;
    result.chi_square += (residual[k] / error[k]) * (residual[k] / error[k]);
    ++result.bins;
  }
  result.degrees = std::max<std::int64_t>(0, result.bins - matched);
  result.rms = std::sqrt(squares / static_cast<double>(residual.size()));
  result.rms_over_mean = result.rms / mean_normal;
  return result;
}

theory::Model model_for(const TheoryChoice& choice, const MeasuredBase& base, std::vector<std::string>& from_run) {
  return theory::make_model(choice.model, settings_for(choice, base, from_run));
}

}  // namespace

bool MeasuredBase::loaded(double x) const { return std::fabs(x - centre) <= half_width * (1.0 + rounding); }

std::int64_t MeasuredBase::loaded_discs() const {
  return std::ranges::count_if(discs.x, [this](double x) { return loaded(x); });
}

double MeasuredBase::weight() const {
  double sum = 0.0;
  for (const double force : discs.normal) sum += force;
  return sum;
}

std::string TheoryComparison::label() const {
  const auto name = theory::text_of(model).name;
  const auto defaults = theory::default_parameters(name);
  std::string text{name};
  for (const auto& parameter : theory::parameters_of(model)) {
    const auto same = [&](const auto& other) { return other.name == parameter.name && other.value == parameter.value; };
    if (std::ranges::any_of(defaults, same)) continue;
    text += fmt::format("{} {} = {}", text.size() == name.size() ? ":" : ",", parameter.name, parameter.value);
  }
  return text;
}

std::vector<theory::Setting> settings_for(const TheoryChoice& choice, const MeasuredBase& base,
                                          std::vector<std::string>& from_run) {
  auto settings = choice.settings;
  const auto given = [&](const std::string& name) {
    return std::ranges::any_of(choice.settings, [&](const auto& setting) { return setting.first == name; });
  };
  const auto parameters = theory::default_parameters(choice.model);
  const auto wanted = [&](const std::string& name) {
    return !given(name) && std::ranges::any_of(parameters, [&](const auto& text) { return text.name == name; });
  };
  const auto take = [&](const std::string& name, const std::string& value) {
    settings.emplace_back(name, value);
    from_run.push_back(name);
  };
  // A model with an angle of friction has its pile at that angle unless it is given another slope.
  const std::string slope = wanted("angle_deg") ? "angle_deg" : "slope_deg";
  if (wanted(slope)) {
    if (!base.slope_deg) {
      throw InputError(fmt::format("{}: {} must be given: the heap has no angle of repose (angle_of_repose_deg.mean)",
                                   choice.model, slope));
    }
    take(slope, fmt::format("{}", *base.slope_deg));
  }
  if (wanted("base_count")) take("base_count", fmt::format("{}", base.loaded_discs()));
  return settings;
}

TheoryComparison compare(const TheoryChoice& choice, const MeasuredBase& base) {
  std::vector<std::string> from_run;
  const auto model = model_for(choice, base, from_run);
  const auto table = theory::predict(model);
  if (!has_base_force(table)) {
    throw InputError(
        fmt::format("{}: has no force on the base of a heap (x_over_b, normal, shear); models that have: {}",
                    choice.model, fmt::join(models_of_base_force(base), " | ")));
  }
  check(choice.model, table);
  auto result = compare_table(table, base);
  result.model = model;
  result.from_run = from_run;
  return result;
}

TheoryComparison compare_table(const theory::Table& table, const MeasuredBase& base) {
  TheoryComparison result;
  const auto& place = table.column("x_over_b").values;
  const Polyline normal(place, table.column("normal").values);
  const Polyline shear(place, table.column("shear").values);

  const double height = threshold * *std::ranges::max_element(table.column("normal").values);
  const double first = normal.first_above(height);
  const double last = normal.last_above(height);
  result.weight = base.weight();
  result.width = 2.0 * base.half_width / (last - first);
  result.left = base.centre - 0.5 * (first + last) * result.width;
  const auto& x = base.discs.x;
  result.spacing = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  result.scale = result.weight * result.spacing / (result.width * normal.integral());

  BaseProfile discs;
  discs.x = x;
  const auto ends = ends_of(x);
  const double over_integral = result.weight / normal.integral();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double from = (ends[k] - result.left) / result.width;
    const double to = (ends[k + 1] - result.left) / result.width;
    discs.normal.push_back(over_integral * normal.integral(from, to));
    discs.shear.push_back(over_integral * shear.integral(from, to));
  }
  const auto predicted = binned(discs, base.bins.bin_width);

  auto& residuals = result.residuals;
  residuals.bin_width = base.bins.bin_width;
  double sum = 0.0;
  for (std::size_t k = 0; k < predicted.x.size(); ++k) {
    if (!base.loaded(predicted.x[k])) continue;
    residuals.x.push_back(predicted.x[k]);
    residuals.count.push_back(predicted.count[k]);
    residuals.normal.push_back(base.bins.normal[k] - predicted.normal[k]);
    residuals.shear.push_back(base.bins.shear[k] - predicted.shear[k]);
    residuals.normal_error.push_back(base.bins.normal_error[k]);
    residuals.shear_error.push_back(base.bins.shear_error[k]);
    sum += base.bins.normal[k];
  }
  if (residuals.x.empty()) {
    throw InputError("the loaded interval of the base is too short: no bin (analysis.base_bin) has its centre there");
  }
  const double mean = sum / static_cast<double>(residuals.x.size());
  result.normal = agreement(residuals.normal, residuals.normal_error, mean, matched_normal);
  result.shear = agreement(residuals.shear, residuals.shear_error, mean, 0);
  return result;
}

std::vector<std::string> models_of_base_force(const MeasuredBase& base) {
  constexpr double any_slope = 30.0;  // of a heap without one
  auto heap = base;
  heap.slope_deg = base.slope_deg.value_or(any_slope);
  std::vector<std::string> names;
  for (const auto& model : theory::default_models()) {
    const TheoryChoice choice{std::string{theory::text_of(model).name}, {}};
    std::vector<std::string> from_run;
    try {
      if (has_base_force(theory::predict(model_for(choice, heap, from_run)))) names.push_back(choice.model);
    } catch (const InputError&) {
      continue;  // needs a parameter that a heap does not give
    }
  }
  return names;
}

}  // namespace repose
