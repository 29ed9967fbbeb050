// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"
#include "repose/scene/start_places.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <algorithm>

namespace repose {

template <int D>
void add_start(const Scene& scene, Grains<D>& grains, std::int64_t& id) {
  if (scene.start.from.empty()) return;
  const auto& names = scene.material_names();
  const auto state = state_at_start<D>(scene);
  const bool of_run = !state.scene.empty();
  for (const auto& row : state.grains) {
    auto grain = make_grain<D>(scene, 2.0 * row.radius, names.at(row.material));
    if (row.mass) grain.mass = *row.mass;
    grain.inverse_mass = row.fixed ? 0.0 : 1.0 / grain.mass;
    grain.position = row.position;
    if (!row.fixed && !scene.start.at_rest) {
      grain.velocity = row.velocity;
      grain.rim_velocity = row.spin * grain.radius;
    }
    const auto own = of_run ? *row.id : id;
    grains.add(grain, own, row.base, row.material);
    id = own + 1;
  }
}

template <int D>
Contacts<D> contacts_at_start(const Scene& scene) {
  Contacts<D> kept;
  if (!scene.start.histories) return kept;
  const auto state = state_at_start<D>(scene);
  const auto names = wall_names(scene);
  for (auto contact : state.contacts.list) {
    if (contact.second < 0) {
      const auto number = static_cast<std::size_t>(-1 - contact.second);
      if (number >= state.walls.size()) continue;
      const auto found = std::find(names.begin(), names.end(), state.walls[number]);
      if (found == names.end()) continue;
      contact.second = wall_partner(found - names.begin());
    }
    kept.list.push_back(contact);
  }
  kept.sort();
  return kept;
}

template void add_start(const Scene&, Grains<2>&, std::int64_t&);
template void add_start(const Scene&, Grains<3>&, std::int64_t&);
template Contacts<2> contacts_at_start(const Scene&);
template Contacts<3> contacts_at_start(const Scene&);

}  // namespace repose
