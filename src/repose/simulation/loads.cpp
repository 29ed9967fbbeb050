// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/loads.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace repose {

Loads::Loads(const Scene& scene, const TimeSteps& steps)
    : box_(make_box(scene)), steps_(steps), by_start_(scene.loads) {
  std::stable_sort(by_start_.begin(), by_start_.end(), [](const auto& a, const auto& b) { return a.start < b.start; });
}

double Loads::due() const {
  if (begun_ == by_start_.size()) return std::numeric_limits<double>::infinity();
  constexpr double rounding = 1e-9;  // steps by which a start that is meant to be the end of a step may miss it
  return steps_.at_or_after(by_start_[begun_].start, rounding);
}

bool Loads::begin_due(double time, const Grains<2>& grains) {
  const auto before = begun_;
  for (; due() <= time; ++begun_) {
    const auto& load = by_start_[begun_];
    const auto grain = load.grain >= 0 ? load.grain : nearest_grain({{load.position[0], load.position[1]}}, grains);
    if (grain >= 0) acting_.push_back({grain, {{load.force[0], load.force[1]}}});
  }
  return begun_ > before;
}

std::int64_t Loads::nearest_grain(const Vec<2>& place, const Grains<2>& grains) const {
  std::int64_t nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const auto k : by_id(grains)) {
    if (grains.line[k].fixed()) continue;
    const Vec<2> d = separation(box_.wrapped(grains.line[k].position), box_.wrapped(place), box_);
    if (dot(d, d) >= least) continue;
    least = dot(d, d);
    nearest = grains.id[k];
  }
  return nearest;
}

void check_loads_on(const Grains<2>& at_start, const Scene& scene) {
  std::vector<std::string> problems;
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const auto grain = scene.loads[k].grain;
    const auto why = grain < 0 ? "" : load_problem(scene, at_start, grain);
    if (!why.empty()) problems.push_back(fmt::format("load[{}].grain = {}: {}", k, grain, why));
  }
  if (!problems.empty()) throw InputError(problems);
}

void Loads::exchange(Archive& archive) {
  archive.value("run/loads_begun", begun_);
  archive.array("run/loads", acting_);
  archive.check("run/loads_begun", begun_ <= by_start_.size());
}

}  // namespace repose
