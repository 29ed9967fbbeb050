// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/trouble.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace repose {

std::string describe_trouble(const Simulation& simulation) {
  if (!simulation.scene().method->traits().follows_time) {
    return fmt::format("disc {} finds no place to rest", simulation.released());
  }
  const auto& grains = simulation.grains();
  std::vector<std::string> found;
  if (const auto known = simulation.trouble_of_method(); !known.empty()) found.push_back(known);
  for (const auto k : by_id(grains)) {
    const auto& grain = grains.line[k];
    const double speed = magnitude(grain.velocity);
    const bool finite = std::isfinite(speed) && std::isfinite(grain.position[0]) && std::isfinite(grain.position[1]);
    if (!finite) {
      found.push_back(fmt::format("grain {} is not a number", grains.id[k]));
    } else if (speed * simulation.time_step() >= grain.radius) {
      found.push_back(fmt::format("grain {} moves at {:.3g}, more than its radius in a step", grains.id[k], speed));
    }
  }
  for (const auto& contact : simulation.contacts().list) {
    if (contact.relative_overlap <= largest_overlap) continue;
    found.push_back(fmt::format("grain {} and {} overlap by {:.2g} diameters", contact.first,
                                partner_name(simulation.scene(), contact.second), contact.relative_overlap));
  }
  constexpr std::size_t most = 8;
  std::string text = fmt::format("the grains cannot be followed beyond time {:.6g} (step {}): ", simulation.time(),
                                 simulation.steps());
  for (std::size_t k = 0; k < std::min(most, found.size()); ++k) text += (k > 0 ? "; " : "") + found[k];
  if (found.size() > most) text += fmt::format("; and {} more", found.size() - most);
  return text + ". A smaller method.time_step, a stiffer contact or a lower fall may help";
}

}  // namespace repose
