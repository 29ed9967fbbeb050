// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/sequential.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace repose {

namespace {

constexpr double touching = 1e-9;  // of the radius: a grain that rests on a wall does not overlap it

/// Height above the point of a wall at which a disc that comes down at `across` [L] beside that point touches it.
std::optional<double> height_on(const Wall<2>& wall, double across, double radius) {
  const double distance = (wall.smooth ? 2.0 : 1.0) * radius;
  const Vec<2> normal = wall.finite() && wall.normal[1] < 0.0 ? -wall.normal : wall.normal;
  std::optional<double> height;
  if (normal[1] > 1e-6) {
    // A wall that slopes lies lower under the centre than beside it.
    const double rise = (distance - across * normal[0]) / normal[1];
    const double along = across * normal[1] - rise * normal[0];
    if (!wall.finite() || std::fabs(along) <= wall.half_length) height = rise;
  }
  for (const double end : {-wall.half_length, wall.half_length}) {
    if (!wall.finite()) break;
    const double beside = across - end * normal[1];
    if (std::fabs(beside) >= distance) continue;
    const double over_end = -end * normal[0] + std::sqrt(distance * distance - beside * beside);
    height = std::max(over_end, height.value_or(over_end));
  }
  return height;
}

}  // namespace

Sequential::Sequential(const Scene& scene, const SequentialSource& source, const TimeSteps& steps,
                       std::int64_t first_id)
    : scene_(scene),
      source_(source),
      steps_(steps),
      first_id_(first_id),
      draw_(scene, Purpose::grain_species, Purpose::grain_size),
      walls_(make_walls(scene)) {
  REPOSE_ASSERT(steps.equal());
}

bool Sequential::at_rest(const Grains<2>& grains) const {
  const double slow = source_.rest * scene_.gravity * steps_.length;
  return std::all_of(grains.line.begin(), grains.line.end(), [&](const auto& grain) {
    return grain.fixed() || (magnitude(grain.velocity) < slow && std::fabs(grain.rim_velocity) < slow);
  });
}

/// Height at which a disc that comes down at x touches something first; 0 where there is nothing.
double Sequential::first_touch(const Grains<2>& grains, const std::vector<WallNow<2>>& walls, double x,
                               double radius) const {
  const auto box = make_box(scene_);
  double height = 0.0;
  for (const auto& grain : grains.line) {
    const double reach = grain.radius + radius;
    const double across = separation(Vec<2>{{x, 0.0}}, Vec<2>{{grain.position[0], 0.0}}, box)[0];
    if (std::fabs(across) >= reach) continue;
    height = std::max(height, grain.position[1] + std::sqrt(reach * reach - across * across));
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (!walls[w].present) continue;
    const double across = from_wall(walls_[w], walls[w], {{x, walls[w].point[1]}}, box)[0];
    const auto touch = height_on(walls_[w], across, radius);
    if (touch) height = std::max(height, walls[w].point[1] + *touch);
  }
  return height;
}

double Sequential::due() const { return done() ? std::numeric_limits<double>::infinity() : next_; }

bool Sequential::release(Grains<2>& grains, double time, const SourceView& view) {
  constexpr long quiet_steps = 3;
  constexpr std::uint32_t tries_at_once = 64;
  next_ = steps_.later(time, steps_.length);
  if (released_ > 0) {
    quiet_ = at_rest(grains) ? quiet_ + 1 : 0;
    if (quiet_ < quiet_steps) return false;
  }
  const auto seed = static_cast<std::uint64_t>(scene_.seed);
  const auto index = static_cast<std::uint64_t>(released_);
  const auto walls = walls_at(walls_, view.walls, time);
  const auto box = make_box(scene_);
  auto [grain, material] = draw_(index);
  bool found = false;
  for (std::uint32_t n = 0; n < tries_at_once && !found; ++n) {
    const double place = 2.0 * uniform(seed, Purpose::release_position, index, tries_++) - 1.0;
    grain.position[0] = source_.x + source_.half_width * place;
    grain.position[1] = first_touch(grains, walls, grain.position[0], grain.radius) + source_.height;
    const double shrunk = (1.0 - touching) * grain.radius;
    found = !overlapping_wall(walls_, walls, box, grain.position, shrunk, 1.0);
  }
  if (!found) return false;
  const auto limit = scene_.speed_limit();
  grain.velocity = {{0.0, limit ? -*limit : 0.0}};
  grains.add(grain, first_id_ + released_, false, material);
  ++released_;
  last_ = time;
  quiet_ = 0;
  tries_ = 0;
  return true;
}

std::string Sequential::buried() const {
  return fmt::format(
      "grain {} of {} cannot be released: {}", released_ + 1, count(),
      tries_ > 0 ? "it finds no room between the walls"
                 : fmt::format("the others do not come to rest, by source.rest = {} of gravity times time step; less "
                               "tolerance of the solver, or rolling friction, may help",
                               source_.rest));
}

void Sequential::exchange(Archive& archive) {
  archive.value("source/released", released_);
  archive.value("source/next_time", next_);
  archive.value("source/last_time", last_);
  archive.value("source/quiet", quiet_);
  archive.value("source/tries", tries_);
}

std::unique_ptr<Source<2>> SequentialSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                                   Dimension<2>) const {
  return std::make_unique<Sequential>(scene, *this, steps, first_id);
}

}  // namespace repose
