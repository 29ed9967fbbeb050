// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"
#include "repose/sweep/plan_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace repose {

/// Names of points; one that ends with * stands for all that begin so.
std::vector<std::string> SweepReader::points_named(const toml::table& table, const std::string& prefix,
                                                   const std::string& key, const SweepPlan& plan) {
  std::vector<std::string> found;
  for (const auto& name : names(table, prefix, key, 1)) {
    const bool many = name.ends_with("*");
    const auto start = many ? name.substr(0, name.size() - 1) : name;
    const auto before = found.size();
    for (const auto& point : plan.points) {
      if (many ? point.name.starts_with(start) : point.name == name) found.push_back(point.name);
    }
    if (found.size() > before) continue;
    std::vector<std::string> known;
    for (const auto& point : plan.points) known.push_back(point.name);
    problem(table, fmt::format("{}{}: no point \"{}\"; there are {}", prefix, key, name, fmt::join(known, ", ")));
  }
  return found;
}

void SweepReader::read_fits(SweepPlan& plan) {
  const auto* list = list_of_tables("fit");
  if (list == nullptr) return;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto& table = *list->get(k)->as_table();
    const auto prefix = fmt::format("fit[{}].", k);
    check_keys(table, prefix, {"name", "points", "measure", "direction"});
    HeightPlan fit;
    fit.name = text(table, prefix, "name", true);
    const auto measure = text(table, prefix, "measure", false);
    if (!measure.empty()) fit.measure = measure;
    const auto* known = find_measure(fit.measure);
    if (known == nullptr || (known->unit != "M" && known->unit != "M L/T^2")) {
      problem(table, fmt::format("{}measure = \"{}\": must be a mass or a force (`repose reference summary`)", prefix,
                                 fit.measure));
    }
    const auto direction = text(table, prefix, "direction", false);
    fit.pushed_up = direction == "pushed-up";
    if (!direction.empty() && !fit.pushed_up && direction != "rest") {
      problem(table, fmt::format("{}direction = \"{}\": must be \"rest\" or \"pushed-up\"", prefix, direction));
    }
    fit.points = points_named(table, prefix, "points", plan);
    if (fit.points.size() < 3) {
      problem(table, fmt::format("{}points: {} points; two lengths need three heights", prefix, fit.points.size()));
    }
    const auto same = [&](const HeightPlan& other) { return other.name == fit.name; };
    if (std::any_of(plan.fits.begin(), plan.fits.end(), same)) {
      problem(table, fmt::format("{}name = \"{}\": is used twice", prefix, fit.name));
    }
    plan.fits.push_back(std::move(fit));
  }
}

}  // namespace repose
