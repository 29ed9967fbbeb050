// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/sequential.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

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
double Sequential::first_touch(const Grains<2>& grains, double x, double radius) const {
  const auto box = make_box(scene_);
  double height = 0.0;
  for (const auto& grain : grains.line) {
    const double reach = grain.radius + radius;
    const double across = separation(Vec<2>{{x, 0.0}}, Vec<2>{{grain.position[0], 0.0}}, box)[0];
    if (std::fabs(across) >= reach) continue;
    height = std::max(height, grain.position[1] + std::sqrt(reach * reach - across * across));
  }
  // Planes that slope lie lower under the centre than beside it.
  for (const auto& wall : walls_) {
    if (wall.finite() || wall.normal[1] < 1e-6) continue;
    const double centre = (wall.smooth ? 2.0 : 1.0) * radius - (x - wall.point[0]) * wall.normal[0];
    height = std::max(height, wall.point[1] + centre / wall.normal[1]);
  }
  return height;
}

double Sequential::due() const { return done() ? std::numeric_limits<double>::infinity() : next_; }

bool Sequential::release(Grains<2>& grains, double time, const std::function<double()>&) {
  constexpr long quiet_steps = 3;
  next_ = steps_.later(time, steps_.length);
  if (released_ > 0) {
    quiet_ = at_rest(grains) ? quiet_ + 1 : 0;
    if (quiet_ < quiet_steps) return false;
  }
  const auto index = static_cast<std::uint64_t>(released_);
  auto [grain, material] = draw_(index);
  const double place = 2.0 * uniform(static_cast<std::uint64_t>(scene_.seed), Purpose::release_position, index) - 1.0;
  grain.position[0] = source_.x + source_.half_width * place;
  grain.position[1] = first_touch(grains, grain.position[0], grain.radius) + source_.height;
  const auto limit = scene_.speed_limit();
  grain.velocity = {{0.0, limit ? -*limit : 0.0}};
  grains.add(grain, first_id_ + released_, false, material);
  ++released_;
  last_ = time;
  quiet_ = 0;
  return true;
}

std::string Sequential::buried() const {
  return fmt::format(
      "grain {} of {} cannot be released: the others do not come to rest, by source.rest = {} of gravity times time "
      "step; less tolerance of the solver, or rolling friction, may help",
      released_ + 1, count(), source_.rest);
}

void Sequential::exchange(Archive& archive) {
  archive.value("source/released", released_);
  archive.value("source/next_time", next_);
  archive.value("source/last_time", last_);
  archive.value("source/quiet", quiet_);
}

std::unique_ptr<Source> SequentialSource::start(const Scene& scene, const TimeSteps& steps,
                                                std::int64_t first_id) const {
  return std::make_unique<Sequential>(scene, *this, steps, first_id);
}

}  // namespace repose
