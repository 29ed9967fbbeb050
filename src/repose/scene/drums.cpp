// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/drums.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/scene/contact.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr WholeBounds few_to_many{.low = 3, .high = 10'000};

/// Neighbours that differ by less than 3 degrees act as one surface. Of more walls than that, so many that the middle
/// of each is within a hundredth of a diameter of the circle through its ends.
std::int64_t usual_pieces(const SceneDrum& drum, double diameter) {
  constexpr double smooth = 128.0;
  constexpr double sagitta = 0.01;
  const double needed = std::numbers::pi * std::sqrt(drum.radius / (2.0 * sagitta * diameter));
  const double pieces = std::ceil(std::max(smooth, needed));
  return pieces < static_cast<double>(few_to_many.high) ? static_cast<std::int64_t>(pieces) : few_to_many.high;
}

}  // namespace

void drum_keys(Scene& scene, Parameters& keys) {
  table_keys(keys, "drum", scene.drums, [&](Parameters& entry, SceneDrum& drum, std::size_t k) {
    entry.text("name", drum.name, {fmt::format("drum {}", k), "\"drum k\""},
               "its walls are known by this name and their number");
    entry.vector("centre", drum.centre, 2, Coordinates{}, "L", "about which it rotates");
    entry.number("radius", drum.radius, required, positive, "L", "from the centre to the middle of each wall");
    const auto usual = usual_pieces(drum, scene.grains.diameter);
    entry.integer("pieces", drum.pieces, usual, few_to_many,
                  "straight walls that it consists of; more for a large drum, so that it is a circle within 0.01 d");
    material_key("material", drum.material, scene, entry);
    entry.number("angular_velocity", drum.angular_velocity, required, any, "1/T", "counter-clockwise, in radians");
    entry.number("start", drum.start, not_negative, "T", "the drum stands still until then");
    entry.optional_number("stop", drum.stop, {"", "never"}, not_negative, "T", "the drum stands still from then on");
  });
}

std::vector<Wall<2>> drum_walls(const SceneDrum& drum, std::uint16_t material) {
  const auto centre = vec<2>(drum.centre);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(drum.pieces);
  const double half_length = drum.radius * reproducible::sin(0.5 * step) / reproducible::cos(0.5 * step);
  std::vector<Wall<2>> walls;
  for (std::int64_t k = 0; k < drum.pieces; ++k) {
    const double angle = step * static_cast<double>(k);
    const Vec<2> outwards{{reproducible::cos(angle), reproducible::sin(angle)}};
    Wall<2> wall{.point = centre + outwards * drum.radius, .normal = -outwards, .half_length = half_length};
    wall.material = material;
    wall.motion = {.kind = WallMotion<2>::Kind::rotation,
                   .speed = drum.angular_velocity,
                   .centre = centre,
                   .axis = 1.0,
                   .start = drum.start,
                   .stop = drum.stop.value_or(std::numeric_limits<double>::infinity())};
    walls.push_back(wall);
  }
  return walls;
}

std::vector<std::string> drum_wall_names(const SceneDrum& drum) {
  std::vector<std::string> names;
  for (std::int64_t k = 0; k < drum.pieces; ++k) names.push_back(fmt::format("{} {}", drum.name, k));
  return names;
}

}  // namespace repose
