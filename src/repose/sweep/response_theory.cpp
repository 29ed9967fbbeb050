// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/response_theory.hpp"

#include "repose/core/numbers.hpp"
#include "repose/theory/point_load.hpp"

#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace repose {

namespace {

/// k_t/k_n of the contacts: 0 without friction; that of linear springs; otherwise, also for rigid grains, 0.5.
double stiffness_ratio(const Scene& scene) {
  const auto& laws = scene.contact;
  const bool rigid = scene.method->traits().impulse_laws;
  if ((rigid ? laws.impulse.friction : laws.friction) == 0.0) return 0.0;
  const auto* linear = std::get_if<Linear>(&laws.tangential);
  const auto* hooke = std::get_if<Hooke>(&laws.normal);
  return !rigid && linear != nullptr && hooke != nullptr ? linear->stiffness / hooke->stiffness : 0.5;
}

/// Mean of a stress [F/h] over each bin.
template <class Stress>
std::vector<double> bin_means(const PointResponse& response, const Stress& stress) {
  constexpr int parts = 16;
  std::vector<double> means;
  for (const double middle : response.x) {
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) sum += stress(middle + response.bin * ((k + 0.5) / parts - 0.5));
    means.push_back(sum / parts);
  }
  return means;
}

/// Mean of the OSL stress over each bin: its boxes end within bins.
std::vector<double> osl_means(const PointResponse& response, const theory::PointLoad& model) {
  const auto rays = theory::rays(model);
  const double half = 0.5 * model.load_width;
  std::vector<double> means;
  for (const double middle : response.x) {
    const auto force = [&](double place, double weight) {
      return weight *
             shared_length(place - half, place + half, middle - 0.5 * response.bin, middle + 0.5 * response.bin);
    };
    means.push_back((force(rays.left, rays.weight_left) + force(rays.right, rays.weight_right)) /
                    (model.load_width * response.bin));
  }
  return means;
}

double chi_square(const PointResponse& response, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double off = (response.bins[k].mean - values[k]) / response.bins[k].error;
    sum += off * off;
  }
  return std::isfinite(sum) ? sum : no_number;
}

}  // namespace

void compare_with_theory(PointResponse& response, const Scene& scene, double pitch) {
  const double d = scene.grains.diameter;
  theory::PointLoad model;
  model.load_width = pitch / response.depth.mean;
  model.floor = "rough-rigid";
  model.poisson = response.poisson = 0.25 * (1.0 - std::min(1.0, stiffness_ratio(scene)));
  const double rise = std::sqrt(std::max(d * d - 0.25 * pitch * pitch, 0.01 * d * d));
  model.eta = response.eta = 0.25 * pitch * pitch / (rise * rise);
  model.depth = response.depth.mean / d;
  model.diffusion = 0.25 * pitch * pitch / (rise * d);
  const auto elastic = [&](double poisson) {
    auto other = model;
    other.poisson = poisson;
    return bin_means(response, [&](double x) { return elastic_stress(other, x); });
  };
  const auto add = [&](const char* name, std::vector<double> values) {
    const double square = chi_square(response, values);
    response.curves.push_back({name, std::move(values), square});
  };
  add("elastic", elastic(model.poisson));
  add("osl", osl_means(response, model));
  add("diffusive", bin_means(response, [&](double x) { return diffusive_stress(model, x); }));
  response.fitted_poisson = no_number;
  if (std::isnan(response.curves.front().chi_square)) return;
  const double poisson = boost::math::tools::brent_find_minima(
                             [&](double value) { return chi_square(response, elastic(value)); }, 0.0, 0.5, 16)
                             .first;
  response.fitted_poisson = poisson;
  add("elastic_fitted", elastic(poisson));
}

}  // namespace repose
