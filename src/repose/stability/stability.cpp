// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/stability/stability.hpp"

#include "repose/analysis/force_network.hpp"
#include "repose/simulation/loads.hpp"
#include "repose/simulation/methods.hpp"
#include "repose/stability/record_springs.hpp"
#include "repose/stability/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// A grain with a larger net force is not at rest [grain weights].
constexpr double most_net_force = 0.05;

/// Eigenvalues nearer to 0 are neutral [mean stiffness].
constexpr double neutral_within = 1e-9;

/// The net force on each grain, loads included, along the directions in which it can move.
double largest_net_force(const Record<2>& record, const StiffnessMatrix& stiffness) {
  auto net = net_forces(*record.grains, record.contacts, Vec<2>{{0.0, -record.scene.gravity}});
  Loads<2> loads(record.scene, make_method(record.scene)->time_steps());
  loads.begin_due(record.facts.time, *record.grains);
  for (const auto& load : loads.acting()) {
    if (const auto place = record.grains.find(load.grain)) net[*place] += load.force;
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < net.size(); ++k) {
    double square = 0.0;
    for (const auto& direction : stiffness.freedom[k].directions) square += squared(dot(net[k], direction));
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

double mean_stiffness(const std::vector<ContactSpring>& springs) {
  double sum = 0.0;
  for (const auto& spring : springs) sum += spring.stiffness;
  return sum / static_cast<double>(springs.size());
}

/// The displacements of the grains in a mode, over the largest, and how many take part in it.
void take_mode(const Record<2>& record, const StiffnessMatrix& stiffness, const std::vector<double>& vector,
               Stability& found) {
  double largest = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  for (std::size_t k = 0; k < stiffness.freedom.size(); ++k) {
    const auto& freedom = stiffness.freedom[k];
    if (freedom.directions.empty()) continue;
    GrainMode mode{record.grains->id[k], {}};
    for (std::size_t i = 0; i < freedom.directions.size(); ++i) {
      mode.displacement += freedom.directions[i] * vector[freedom.first + i];
    }
    const double square = dot(mode.displacement, mode.displacement);
    largest = std::max(largest, std::sqrt(square));
    squares += square;
    fourths += square * square;
    found.mode.push_back(mode);
  }
  for (auto& mode : found.mode) mode.displacement *= 1.0 / largest;
  found.participation = squares * squares / fourths;
}

}  // namespace

Stability stability(const Record<2>& record) {
  Stability found;
  found.problem = reason_without_springs(record);
  if (!found.problem.empty()) return found;
  const auto springs = springs_of(record);
  const auto stiffness = stiffness_matrix(record.grains.size(), springs);
  if (stiffness.matrix.size == 0) {
    found.problem = "no contact carries a force on a grain that can move";
    return found;
  }
  const double force_unit = record.scene.base_force_unit();
  found.unbalanced = largest_net_force(record, stiffness) / force_unit;
  if (!(found.unbalanced <= most_net_force)) {
    found.problem = fmt::format("the grains are not at rest: the net force on one of them is {:.3g} grain weights",
                                found.unbalanced);
    return found;
  }
  const double mean = mean_stiffness(springs);
  // A length of 1 without gravity, where forces have no unit of their own.
  const double unit = record.scene.gravity > 0.0 ? force_unit / record.scene.usual_diameter() : 1.0;
  Spectrum spectrum(stiffness.matrix);
  const auto smallest = spectrum.smallest();
  found.contacts = std::ssize(springs);
  found.directions = static_cast<std::int64_t>(stiffness.matrix.size);
  found.stiffness = mean / unit;
  found.smallest = smallest.value / unit;
  found.relative = smallest.value / mean;
  found.residual = smallest.residual / mean;
  found.negative = static_cast<std::int64_t>(spectrum.below(-neutral_within * mean));
  found.neutral = static_cast<std::int64_t>(spectrum.below(neutral_within * mean)) - found.negative;
  take_mode(record, stiffness, smallest.vector, found);
  found.grains = std::ssize(found.mode);
  return found;
}

}  // namespace repose
