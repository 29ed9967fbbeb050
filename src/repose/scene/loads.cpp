// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/loads.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

/// The grains of a scene that starts from nothing else; of placed ones only whether they are fixed.
template <int D>
Grains<D> grains_at_start(const Scene& scene) {
  Grains<D> grains;
  std::int64_t id = 0;
  scene.base->add_grains(scene, grains, id);
  scene.source->add_grains(scene, grains, id);
  for (const auto& placed : scene.placed) {
    Grain<D> grain;
    grain.inverse_mass = placed.fixed ? 0.0 : 1.0;
    grains.add(grain, id++, false, 0);
  }
  return grains;
}

}  // namespace

template <int D>
std::string load_problem(const Scene& scene, const Grains<D>& at_start, std::int64_t id) {
  const auto found = std::lower_bound(at_start.id.begin(), at_start.id.end(), id);
  if (found != at_start.id.end() && *found == id) {
    const auto& grain = at_start.line[static_cast<std::size_t>(found - at_start.id.begin())];
    return grain.fixed() ? "this grain is fixed and feels no load" : "";
  }
  const std::int64_t first = at_start.id.empty() ? 0 : at_start.id.back() + 1;
  const std::int64_t end = first + scene.source->released();
  if (id >= first && id < end) return "";
  return end == 0 ? "there is no grain with an id" : fmt::format("no such grain; ids go from 0 to {}", end - 1);
}

template std::string load_problem(const Scene&, const Grains<2>&, std::int64_t);
template std::string load_problem(const Scene&, const Grains<3>&, std::int64_t);

void check_loads(const Scene& scene, Problems& problems) {
  const auto names_grain = [](const SceneLoad& load) { return load.grain >= 0; };
  const bool any = std::any_of(scene.loads.begin(), scene.loads.end(), names_grain);
  if (!any || !problems.none() || !scene.start.from.empty()) return;
  with_dimension(scene.dimension, [&](auto dimension) {
    const auto grains = grains_at_start<dimension>(scene);
    for (std::size_t k = 0; k < scene.loads.size(); ++k) {
      if (!names_grain(scene.loads[k])) continue;
      const auto why = load_problem(scene, grains, scene.loads[k].grain);
      if (why.empty()) continue;
      problems.problem(fmt::format("load[{}].grain", k), fmt::format(" = {}: {}", scene.loads[k].grain, why));
    }
  });
}

}  // namespace repose
