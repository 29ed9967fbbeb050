// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/drop.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/simulation/sources/pour.hpp"
#include "repose/simulation/sources/room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

template <int D>
Drop<D>::Drop(const Scene& scene, const DropSource& source, const TimeSteps& steps, std::int64_t first_id)
    : scene_(scene),
      source_(source),
      steps_(steps),
      first_id_(first_id),
      draw_(scene, Purpose::grain_species, Purpose::grain_size),
      walls_(make_walls<D>(scene)),
      reach_(scene.contact_reach()) {}

template <int D>
double Drop<D>::due() const {
  if (done()) return std::numeric_limits<double>::infinity();
  return moment(std::max(steps_.at_or_after(planned()), retry_));
}

template <int D>
double Drop<D>::waiting(double time) const {
  return std::max(0.0, time - std::max(planned(), last_));
}

template <int D>
std::string Drop<D>::buried() const {
  return fmt::format("the source is buried: grain {} of {} finds no room at height {}{}", released_ + 1, count(),
                     source_.height, source_.above_apex() ? " above the apex" : "");
}

template <int D>
void Drop<D>::exchange(Archive& archive) {
  archive.value("source/released", released_);
  archive.value("source/retry_time", retry_);
  archive.value("source/last_time", last_);
  archive.value("source/tries", tries_);
}

template <int D>
bool Drop<D>::release(Grains<D>& grains, double time, const SourceView& view) {
  const auto seed = static_cast<std::uint64_t>(scene_.seed);
  const double height = source_.height + (source_.above_apex() ? view.apex() : 0.0);
  const auto box = make_box<D>(scene_);
  Room<D> room(grains, box, height, 0.5 * scene_.largest_drawn(), reach_);
  const auto walls = walls_at(walls_, view.walls, time);
  constexpr std::uint32_t tries_at_once = 64;
  const auto before = released_;
  while (due() <= time) {
    const auto index = static_cast<std::uint64_t>(released_);
    auto [grain, material] = draw_(index);
    grain.velocity = vec<D>(source_.velocity);
    // The velocity of the scene is that of the place; the method's own may be that of a little earlier.
    if (const double lag = steps_.velocity_lag(time); lag > 0.0) {
      grain.velocity -= scene_.gravity_vector<D>() * lag;
    }
    bool found = false;
    for (std::uint32_t n = 0; n < tries_at_once && !found; ++n) {
      const auto random = [&] { return uniform(seed, Purpose::release_position, index, tries_++); };
      const double first = random();
      const double second = D == 3 ? random() : 0.0;
      grain.position = source_.place<D>(first, second);
      grain.position[up<D>] = height;
      found = room.is_free(grain) && !overlapping_wall(walls_, walls, box, grain.position, grain.radius, reach_);
    }
    if (!found) {
      const double wait = 0.02 * std::sqrt(scene_.grains.diameter / scene_.gravity);
      retry_ = steps_.later(time, steps_.cut(wait));
      break;
    }
    grains.add(grain, first_id_ + released_, false, material);
    room.add(grain);
    ++released_;
    last_ = time;
    tries_ = 0;
    retry_ = 0.0;
  }
  return released_ > before;
}

std::unique_ptr<Source<2>> PourSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                             Dimension<2>) const {
  return std::make_unique<Pour<2>>(scene, *this, steps, first_id);
}
std::unique_ptr<Source<3>> PourSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                             Dimension<3>) const {
  return std::make_unique<Pour<3>>(scene, *this, steps, first_id);
}

template class Drop<2>;
template class Drop<3>;

}  // namespace repose
