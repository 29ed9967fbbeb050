// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/drop.hpp"

#include "repose/laws/any_law.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/sources/pour.hpp"
#include "repose/simulation/sources/room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

Drop::Drop(const Scene& scene, const DropSource& source, double time_step, std::int64_t first_id)
    : scene_(scene),
      source_(source),
      time_step_(time_step),
      first_id_(first_id),
      draw_(scene, Purpose::grain_species, Purpose::grain_size) {
  if (!scene_.method->traits().force_laws) return;
  for (const auto& laws : scene_.material_laws().table) reach_ = std::max(reach_, reach(AnyNormal{laws.normal}));
}

long Drop::next_step() const {
  const auto step = std::max(static_cast<long>(std::ceil(std::min(due() / time_step_, 1e15))), retry_);
  return (step + every() - 1) / every() * every();
}

double Drop::waiting(long step) const {
  return std::max(0.0,
                  static_cast<double>(step) * time_step_ - std::max(due(), static_cast<double>(last_) * time_step_));
}

std::string Drop::buried() const {
  return fmt::format("the source is buried: grain {} of {} finds no room at height {}{}", released_ + 1, count(),
                     source_.height, source_.above_apex() ? " above the apex" : "");
}

void Drop::exchange(Archive& archive) {
  archive.value("source/released", released_);
  archive.value("source/retry", retry_);
  archive.value("source/last", last_);
  archive.value("source/tries", tries_);
}

bool Drop::release(Grains<2>& grains, long step, const std::function<double()>& apex) {
  const auto seed = static_cast<std::uint64_t>(scene_.seed);
  const double height = source_.height + (source_.above_apex() ? apex() : 0.0);
  const auto box = make_box(scene_);
  Room room(grains, box, height, 0.5 * scene_.largest_drawn(), reach_);
  constexpr std::uint32_t tries_at_once = 64;
  const auto before = released_;
  while (!done() && next_step() <= step) {
    const auto index = static_cast<std::uint64_t>(released_);
    auto [grain, material] = draw_(index);
    grain.velocity = {{source_.velocity[0], source_.velocity[1]}};
    // Now; the velocity belongs to half a step ago, except at the start of time, where the first kick is half.
    if (step > 0) grain.velocity[1] += 0.5 * scene_.gravity * time_step_;
    grain.position[1] = height;
    bool found = false;
    for (std::uint32_t n = 0; n < tries_at_once && !found; ++n) {
      const double place = 2.0 * uniform(seed, Purpose::release_position, index, tries_++) - 1.0;
      grain.position[0] = source_.x + source_.half_width * place;
      found = room.is_free(grain);
    }
    if (!found) {
      const double wait = 0.02 * std::sqrt(scene_.grains.diameter / scene_.gravity);
      retry_ = step + std::max(1L, static_cast<long>(wait / time_step_));
      break;
    }
    grains.add(grain, first_id_ + released_, false, material);
    room.add(grain);
    ++released_;
    last_ = step;
    tries_ = 0;
    retry_ = 0;
  }
  return released_ > before;
}

std::unique_ptr<Source> PourSource::start(const Scene& scene, double time_step, std::int64_t first_id) const {
  return std::make_unique<Pour>(scene, *this, time_step, first_id);
}

}  // namespace repose
