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

template <int D>
Loads<D>::Loads(const Scene& scene, const TimeSteps& steps)
    : box_(make_box<D>(scene)), steps_(steps), by_start_(scene.loads) {
  std::stable_sort(by_start_.begin(), by_start_.end(), [](const auto& a, const auto& b) { return a.start < b.start; });
}

template <int D>
double Loads<D>::due() const {
  if (begun_ == by_start_.size()) return std::numeric_limits<double>::infinity();
  constexpr double rounding = 1e-9;  // steps by which a start that is meant to be the end of a step may miss it
  return steps_.at_or_after(by_start_[begun_].start, rounding);
}

template <int D>
bool Loads<D>::begin_due(double time, const Grains<D>& grains) {
  const auto before = begun_;
  for (; due() <= time; ++begun_) {
    const auto& load = by_start_[begun_];
    const auto grain = load.grain >= 0 ? load.grain : nearest_grain(vec<D>(load.position), grains);
    if (grain >= 0) acting_.push_back({grain, vec<D>(load.force)});
  }
  return begun_ > before;
}

template <int D>
std::int64_t Loads<D>::nearest_grain(const Vec<D>& place, const Grains<D>& grains) const {
  std::int64_t nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const auto k : by_id(grains)) {
    if (grains.line[k].fixed()) continue;
    const Vec<D> d = separation(box_.wrapped(grains.line[k].position), box_.wrapped(place), box_);
    if (dot(d, d) >= least) continue;
    least = dot(d, d);
    nearest = grains.id[k];
  }
  return nearest;
}

template <int D>
void check_loads_on(const Grains<D>& at_start, const Scene& scene) {
  std::vector<std::string> problems;
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const auto grain = scene.loads[k].grain;
    const auto why = grain < 0 ? "" : load_problem(scene, at_start, grain);
    if (!why.empty()) problems.push_back(fmt::format("load[{}].grain = {}: {}", k, grain, why));
  }
  if (!problems.empty()) throw InputError(problems);
}

template <int D>
void Loads<D>::exchange(Archive& archive) {
  archive.value("run/loads_begun", begun_);
  archive.array("run/loads", acting_);
  archive.check("run/loads_begun", begun_ <= by_start_.size());
}

template class Loads<2>;
template class Loads<3>;
template void check_loads_on(const Grains<2>&, const Scene&);
template void check_loads_on(const Grains<3>&, const Scene&);

}  // namespace repose
