// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sizes.hpp"

#include "repose/core/reproducible_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace repose {

namespace {

/// Deviations from the mean at which a bell is cut unless the scene says otherwise.
constexpr double usual_deviations = 3.0;

double normal_fraction(double x) { return 0.5 * reproducible::erfc(-x / std::sqrt(2.0)); }

void check_range(const std::string& prefix, double low, double high, bool may_be_equal, Problems& problems) {
  if (!problems.sound(prefix + "low") || !problems.sound(prefix + "high")) return;
  if (high > low || (may_be_equal && high == low)) return;
  problems.problem(prefix + "high",
                   fmt::format(" = {}: must be {} low = {} [L]", high, may_be_equal ? ">=" : ">", low));
}

bool check_diameters(const std::string& prefix, const std::vector<double>& diameters, Problems& problems) {
  if (!problems.sound(prefix + "diameters")) return false;
  if (std::all_of(diameters.begin(), diameters.end(), [](double d) { return d > 0.0; })) return true;
  problems.problem(prefix + "diameters", ": must be numbers > 0 [L]");
  return false;
}

/// A list of as many numbers as there are diameters, none below 0.
bool check_list(const std::string& key, const std::vector<double>& values, std::size_t count, Problems& problems) {
  if (!problems.sound(key)) return false;
  if (values.size() != count) {
    problems.problem(key, fmt::format(": has {} numbers; must have {}, one for each diameter", values.size(), count));
    return false;
  }
  if (std::any_of(values.begin(), values.end(), [](double value) { return value < 0.0; })) {
    problems.problem(key, ": must be numbers >= 0");
    return false;
  }
  return true;
}

}  // namespace

void UniformSizes::check(const std::string& prefix, Problems& problems) const {
  check_range(prefix, low, high, true, problems);
}

void BellSizes::keys(double, Parameters& keys) {
  keys.number("mean", mean, required, positive, "L", "mean diameter, before the distribution is cut");
  keys.number("deviation", deviation, required, positive, "L",
              "standard deviation of the diameter, before the distribution is cut");
  const auto cut = usual_cut();
  keys.number("low", low, {cut.low, cut.low_rule}, positive, "L", "none is smaller: the distribution is cut here");
  keys.number("high", high, {cut.high, cut.high_rule}, positive, "L", "none is larger");
}

void BellSizes::check(const std::string& prefix, Problems& problems) const {
  check_range(prefix, low, high, false, problems);
  for (const auto* key : {"mean", "deviation", "low", "high"}) {
    if (!problems.sound(prefix + key)) return;
  }
  constexpr double least_part = 1e-3;
  if (const double part = part_left(); !(part >= least_part)) {
    problems.problem(prefix + "low", fmt::format(" = {}: low and high leave {:.2g} of the distribution; at least {:g}",
                                                 low, part, least_part));
  }
}

std::string BellSizes::describe() const {
  return fmt::format("{}, mean {:g}, deviation {:g}", name(), mean, deviation);
}

BellSizes::Cut NormalSizes::usual_cut() const {
  const double cut = usual_deviations * deviation;
  return {mean - cut, mean + cut, "mean - 3 deviations", "mean + 3 deviations"};
}

double NormalSizes::part_left() const {
  return normal_fraction((high - mean) / deviation) - normal_fraction((low - mean) / deviation);
}

BellSizes::Cut LogNormalSizes::usual_cut() const {
  const auto logs = log_moments(mean, deviation);
  const double cut = usual_deviations * logs.deviation;
  return {reproducible::exp(logs.mean - cut), reproducible::exp(logs.mean + cut),
          "mean - 3 deviations of the logarithm", "mean + 3 deviations of the logarithm"};
}

double LogNormalSizes::part_left() const {
  const auto logs = log_moments(mean, deviation);
  return normal_fraction((reproducible::log(high) - logs.mean) / logs.deviation) -
         normal_fraction((reproducible::log(low) - logs.mean) / logs.deviation);
}

double ListedSizes::smallest() const {
  return diameters.empty() ? 0.0 : *std::min_element(diameters.begin(), diameters.end());
}

double ListedSizes::largest() const {
  return diameters.empty() ? 0.0 : *std::max_element(diameters.begin(), diameters.end());
}

void TableSizes::check(const std::string& prefix, Problems& problems) const {
  if (!check_diameters(prefix, diameters, problems)) return;
  if (!check_list(prefix + "weights", weights, diameters.size(), problems)) return;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(sum > 0.0) || !std::isfinite(sum)) problems.problem(prefix + "weights", ": must have a finite sum > 0");
}

void SieveSizes::check(const std::string& prefix, Problems& problems) const {
  if (!check_diameters(prefix, diameters, problems)) return;
  const auto falls = std::adjacent_find(diameters.begin(), diameters.end(), std::greater_equal<>());
  if (diameters.size() < 2 || falls != diameters.end()) {
    return problems.problem(prefix + "diameters",
                            ": must be at least two numbers, each larger than the one before [L]");
  }
  if (!check_list(prefix + "passing", passing, diameters.size(), problems)) return;
  if (!std::is_sorted(passing.begin(), passing.end()) || passing.front() != 0.0 || passing.back() != 1.0) {
    problems.problem(prefix + "passing", ": must rise from 0 to 1");
  }
}

Kinds<SizesKind>& sizes_kinds() {
  static Kinds<SizesKind> kinds{
      {FixedSizes{}, UniformSizes{}, NormalSizes{}, LogNormalSizes{}, TableSizes{}, SieveSizes{}}};
  return kinds;
}

}  // namespace repose
