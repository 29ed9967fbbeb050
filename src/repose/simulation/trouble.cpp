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

template <int D>
std::string describe_trouble(const Simulation<D>& simulation) {
  if (!simulation.scene().method->traits().follows_time) {
    return fmt::format("{} {} finds no place to rest", D == 2 ? "disc" : "sphere", simulation.released());
  }
  const auto& grains = simulation.grains();
  std::vector<std::string> found;
  if (const auto known = simulation.trouble_of_method(); !known.empty()) found.push_back(known);
  for (const auto k : by_id(grains)) {
    const auto& grain = grains.line[k];
    const double speed = magnitude(grain.velocity);
    const bool finite = std::isfinite(speed) && std::isfinite(magnitude(grain.position));
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

template std::string describe_trouble(const Simulation<2>&);
template std::string describe_trouble(const Simulation<3>&);

}  // namespace repose
