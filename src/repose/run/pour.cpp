// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/pour.hpp"

#include "repose/core/random.hpp"
#include "repose/laws/any_law.hpp"
#include "repose/run/setup.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

Pour::Pour(const Scene& scene, double time_step, std::int64_t first_id)
    : scene_(scene), time_step_(time_step), first_id_(first_id) {
  if (scene.source.kind == "pour") count_ = scene.source.count;
}

long Pour::next_step() const {
  const double due = static_cast<double>(released_) / scene_.source.rate;
  return std::max(static_cast<long>(std::ceil(std::min(due / time_step_, 1e15))), retry_);
}

double Pour::waiting(long step) const {
  const double due = static_cast<double>(released_) / scene_.source.rate;
  return std::max(0.0, static_cast<double>(step) * time_step_ - due);
}

bool Pour::release(Grains<2>& grains, long step) {
  const auto seed = static_cast<std::uint64_t>(scene_.seed);
  const auto index = static_cast<std::uint64_t>(released_);
  const double p = scene_.grains.polydispersity;
  const double diameter = scene_.grains.diameter * (1.0 - p * uniform(seed, Purpose::grain_size, index));
  auto grain = make_grain(scene_, diameter);
  // From rest now; the velocity belongs to half a step ago, except at the start of time, where the first kick is half.
  if (step > 0) grain.velocity[1] = 0.5 * scene_.gravity * time_step_;
  grain.position[1] = scene_.source.height;

  double reach = 1.0;
  for (const auto& laws : scene_.material_laws().table) reach = std::max(reach, repose::reach(AnyNormal{laws.normal}));
  const auto taken = [&] {
    return std::any_of(grains.line.begin(), grains.line.end(), [&](const Grain<2>& other) {
      const Vec<2> d = grain.position - other.position;
      const double near = reach * (grain.radius + other.radius);
      return dot(d, d) < near * near;
    });
  };
  constexpr std::uint32_t tries_at_once = 64;
  for (std::uint32_t n = 0; n < tries_at_once; ++n) {
    const double place = 2.0 * uniform(seed, Purpose::release_position, index, tries_++) - 1.0;
    grain.position[0] = scene_.source.x + scene_.source.half_width * place;
    if (taken()) continue;
    grains.add(grain, first_id_ + released_);
    ++released_;
    tries_ = 0;
    retry_ = 0;
    return true;
  }
  const double wait = 0.02 * std::sqrt(scene_.grains.diameter / scene_.gravity);
  retry_ = step + std::max(1L, static_cast<long>(wait / time_step_));
  return false;
}

}  // namespace repose
