// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/reproducible_math.hpp"
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace repose {

namespace {

double normal_fraction(double x) { return 0.5 * reproducible::erfc(-x / std::sqrt(2.0)); }

/// Part of a normal or log-normal distribution that the cuts leave.
double part_left(const Scene::Species::Sizes& sizes) {
  if (sizes.kind == "normal") {
    return normal_fraction((sizes.high - sizes.mean) / sizes.deviation) -
           normal_fraction((sizes.low - sizes.mean) / sizes.deviation);
  }
  const auto logs = log_moments(sizes.mean, sizes.deviation);
  return normal_fraction((reproducible::log(sizes.high) - logs.mean) / logs.deviation) -
         normal_fraction((reproducible::log(sizes.low) - logs.mean) / logs.deviation);
}

void check_range(const std::string& prefix, const Scene::Species::Sizes& sizes, Reader& reader) {
  if (!reader.sound(prefix + "low") || !reader.sound(prefix + "high")) return;
  const bool uniform = sizes.kind == "uniform";
  if (sizes.high < sizes.low || (!uniform && sizes.high == sizes.low)) {
    return reader.problem(prefix + "high",
                          fmt::format(" = {}: must be {} low = {} [L]", sizes.high, uniform ? ">=" : ">", sizes.low));
  }
  constexpr double least_part = 1e-3;
  if (uniform || !reader.sound(prefix + "mean") || !reader.sound(prefix + "deviation")) return;
  if (const double part = part_left(sizes); !(part >= least_part)) {
    reader.problem(prefix + "low", fmt::format(" = {}: low and high leave {:.2g} of the distribution; at least {:g}",
                                               sizes.low, part, least_part));
  }
}

/// A list of as many numbers as there are diameters, none below 0.
bool check_list(const std::string& key, const std::vector<double>& values, std::size_t count, Reader& reader) {
  if (!reader.sound(key)) return false;
  if (values.size() != count) {
    reader.problem(key, fmt::format(": has {} numbers; must have {}, one for each diameter", values.size(), count));
    return false;
  }
  if (std::any_of(values.begin(), values.end(), [](double value) { return value < 0.0; })) {
    reader.problem(key, ": must be numbers >= 0");
    return false;
  }
  return true;
}

void check_lists(const std::string& prefix, const Scene::Species::Sizes& sizes, Reader& reader) {
  const auto& diameters = sizes.diameters;
  if (!reader.sound(prefix + "diameters")) return;
  if (std::any_of(diameters.begin(), diameters.end(), [](double d) { return d <= 0.0; })) {
    return reader.problem(prefix + "diameters", ": must be numbers > 0 [L]");
  }
  if (sizes.kind == "table") {
    const auto& weights = sizes.weights;
    if (!check_list(prefix + "weights", weights, diameters.size(), reader)) return;
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(sum > 0.0) || !std::isfinite(sum)) reader.problem(prefix + "weights", ": must have a finite sum > 0");
    return;
  }
  if (diameters.size() < 2 ||
      std::adjacent_find(diameters.begin(), diameters.end(), std::greater_equal<>()) != diameters.end()) {
    return reader.problem(prefix + "diameters", ": must be at least two numbers, each larger than the one before [L]");
  }
  const auto& passing = sizes.passing;
  if (!check_list(prefix + "passing", passing, diameters.size(), reader)) return;
  if (!std::is_sorted(passing.begin(), passing.end()) || passing.front() != 0.0 || passing.back() != 1.0) {
    reader.problem(prefix + "passing", ": must rise from 0 to 1");
  }
}

}  // namespace

void check_species(const Scene& scene, Reader& reader) {
  constexpr std::size_t most = 64;
  if (scene.species.size() > most) reader.problem("species", fmt::format(": at most {} species", most));
  if (!scene.species.empty() && scene.grains.polydispersity > 0.0 && reader.sound("grains.polydispersity")) {
    reader.problem("grains.polydispersity",
                   fmt::format(" = {}: must be 0 where there are species, which have sizes of their own",
                               scene.grains.polydispersity));
  }
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.species.size(); ++k) {
    const auto& species = scene.species[k];
    const auto key = fmt::format("species[{}].name", k);
    if (!names.insert(species.name).second && reader.sound(key)) {
      reader.problem(key, fmt::format(" = \"{}\": is taken", species.name));
    }
    const auto prefix = fmt::format("species[{}].sizes.", k);
    const auto& sizes = species.sizes;
    if (sizes.kind == "table" || sizes.kind == "sieve") {
      check_lists(prefix, sizes, reader);
    } else if (sizes.kind != "fixed") {
      check_range(prefix, sizes, reader);
    }
  }
}

}  // namespace repose
