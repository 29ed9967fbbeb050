// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/reproducible_math.hpp"
#include "repose/scene/key_groups.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

/// Deviations from the mean at which a normal or log-normal distribution is cut unless the scene says otherwise.
constexpr double usual_cut = 3.0;

void cut_keys(const std::string& prefix, Scene::Species::Sizes& sizes, double low, double high, Keys& keys) {
  keys.number(prefix + "low", sizes.low, low, positive, "L", "none is smaller: the distribution is cut here");
  keys.number(prefix + "high", sizes.high, high, positive, "L", "none is larger");
}

void size_keys(const std::string& prefix, Scene::Species::Sizes& sizes, double d, Keys& keys) {
  keys.choice(prefix + "kind", sizes.kind, "fixed", {"fixed", "uniform", "normal", "log-normal", "table", "sieve"},
              "distribution of the diameters");
  if (sizes.kind == "fixed") {
    keys.number(prefix + "diameter", sizes.diameter, d, positive, "L", "of all grains of the species");
  } else if (sizes.kind == "uniform") {
    keys.number(prefix + "low", sizes.low, required, positive, "L", "smallest diameter");
    keys.number(prefix + "high", sizes.high, required, positive, "L", "largest diameter");
  } else if (sizes.kind == "normal" || sizes.kind == "log-normal") {
    keys.number(prefix + "mean", sizes.mean, required, positive, "L", "mean diameter, before the distribution is cut");
    keys.number(prefix + "deviation", sizes.deviation, required, positive, "L",
                "standard deviation of the diameter, before the distribution is cut");
    if (sizes.kind == "normal") {
      const double cut = usual_cut * sizes.deviation;
      cut_keys(prefix, sizes, sizes.mean - cut, sizes.mean + cut, keys);
    } else {
      const auto logs = log_moments(sizes.mean, sizes.deviation);
      const double cut = usual_cut * logs.deviation;
      cut_keys(prefix, sizes, reproducible::exp(logs.mean - cut), reproducible::exp(logs.mean + cut), keys);
    }
  } else {
    keys.numbers(prefix + "diameters", sizes.diameters, "L",
                 sizes.kind == "table" ? "of the grains" : "openings of the sieves, rising");
    if (sizes.kind == "table") {
      keys.numbers(prefix + "weights", sizes.weights, "", "share by number of each diameter");
    } else {
      keys.numbers(prefix + "passing", sizes.passing, "", "fraction by mass finer than each, rising from 0 to 1");
    }
  }
}

}  // namespace

double Scene::Species::Sizes::smallest() const {
  if (kind == "fixed") return diameter;
  if (diameters.empty()) return low;
  return *std::min_element(diameters.begin(), diameters.end());
}

double Scene::Species::Sizes::largest() const {
  if (kind == "fixed") return diameter;
  if (diameters.empty()) return high;
  return *std::max_element(diameters.begin(), diameters.end());
}

SizeDistribution Scene::Species::Sizes::distribution() const {
  if (kind == "fixed") return SizeDistribution::fixed(diameter);
  if (kind == "uniform") return SizeDistribution::uniform(low, high);
  if (kind == "normal") return SizeDistribution::normal(mean, deviation, low, high);
  if (kind == "log-normal") return SizeDistribution::log_normal(mean, deviation, low, high);
  if (kind == "table") return SizeDistribution::table(diameters, weights);
  return SizeDistribution::sieve(diameters, passing);
}

void species_keys(Scene& scene, Keys& keys) {
  table_keys<Scene::Species>(keys, "species", scene.species, [&](const auto& prefix, auto& species, std::size_t k) {
    keys.text(prefix + "name", species.name, fmt::format("species {}", k), "of the species");
    keys.number(prefix + "share", species.share, 1.0, positive, "", "of the grains, over the sum of all shares");
    material_key(prefix + "material", species.material, scene, keys);
    size_keys(prefix + "sizes.", species.sizes, scene.grains.diameter, keys);
  });
}

}  // namespace repose
