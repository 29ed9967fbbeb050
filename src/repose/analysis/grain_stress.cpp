// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/grain_stress.hpp"

#include <cstddef>
#include <numbers>

namespace repose {

std::vector<GrainStress> grain_stresses(const OrderedGrains<2>& grains, const Contacts<2>& contacts,
                                        const std::vector<VoronoiCell>& cells, const Box<2>& box) {
  std::vector<GrainStress> stresses;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    stresses.push_back({grains->id[k], std::numbers::pi * squared(grains->line[k].radius), false, {}});
  }
  for (const auto& cell : cells) {
    const auto k = grains.find(cell.id);
    if (!k || !cell.closed || !(cell.area > 0.0)) continue;
    stresses[*k].area = cell.area;
    stresses[*k].in_cell = true;
  }
  const auto add = [&](std::size_t k, const Vec<2>& force, const Vec<2>& branch) {
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) stresses[k].stress[static_cast<std::size_t>(2 * a + b)] += force[a] * branch[b];
    }
  };
  for (const auto& contact : contacts.list) {
    const auto first = grains.find(contact.first).value();
    const Vec<2> force = force_of(contact);
    const Vec<2> lever = contact.normal * contact.first_lever;
    add(first, force, lever);
    if (contact.second < 0) continue;
    const auto second = grains.find(contact.second).value();
    add(second, -force, lever - separation(grains->line[first].position, grains->line[second].position, box));
  }
  for (auto& grain : stresses) {
    for (auto& component : grain.stress) component /= grain.area;
  }
  return stresses;
}

}  // namespace repose
