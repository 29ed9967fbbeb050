// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"

#include "repose/core/errors.hpp"

#include <cmath>

namespace repose {

namespace {

Vec<2> vector_of(const std::array<double, 2>& numbers) { return {{numbers[0], numbers[1]}}; }
Vec<2> direction_of(const Vec<2>& vector) { return vector * (1.0 / magnitude(vector)); }

/// What an endless wall and one from point to point have in common.
void complete(const SceneWall& from, const Scene& scene, Wall<2>& wall) {
  wall.smooth = from.smooth;
  wall.material = scene.material_number(from.material);
  wall.motion = from.motion->motion();
  if (from.opens_at) wall.opens_at = *from.opens_at;
}

}  // namespace

std::vector<Wall<2>> make_walls(const Scene& scene) {
  std::vector<Wall<2>> walls;
  if (const auto base = scene.base->wall(scene)) walls.push_back(*base);
  for (const auto& plane : scene.planes) {
    Wall<2> wall{.point = vector_of(plane.point), .normal = direction_of(vector_of(plane.normal))};
    complete(plane, scene, wall);
    walls.push_back(wall);
  }
  for (const auto& piece : scene.pieces) {
    const Vec<2> along = vector_of(piece.to) - vector_of(piece.from);
    Wall<2> wall{.point = vector_of(piece.from) + along * 0.5,
                 .normal = direction_of({{-along[1], along[0]}}),
                 .half_length = 0.5 * magnitude(along)};
    complete(piece, scene, wall);
    walls.push_back(wall);
  }
  for (const auto& drum : scene.drums) {
    const auto of_drum = drum_walls(drum, scene.material_number(drum.material));
    walls.insert(walls.end(), of_drum.begin(), of_drum.end());
  }
  return walls;
}

std::vector<WallNow<2>> walls_at(const std::vector<Wall<2>>& walls, const std::vector<WallState>& states, double time) {
  REPOSE_ASSERT(states.empty() || states.size() == walls.size());
  std::vector<WallNow<2>> now;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    now.push_back(wall_now(walls[w], states.empty() ? WallState{} : states[w], time));
  }
  return now;
}

std::optional<std::size_t> overlapping_wall(const std::vector<Wall<2>>& walls, const std::vector<WallNow<2>>& now,
                                            const Box<2>& box, const Vec<2>& centre, double radius, double reach) {
  const double kept_free = 2.0 * radius * (reach - 1.0);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!now[w].present) continue;
    const auto place = above(walls[w], now[w].normal, from_wall(walls[w], now[w], centre, box));
    if (wall_overlap(walls[w], place, radius) + kept_free > 0.0) return w;
  }
  return std::nullopt;
}

std::optional<std::size_t> wall_that_blocks(const Scene& scene, double x, double half_width, double height) {
  const auto walls = make_walls(scene);
  auto now = walls_at(walls, {}, 0.0);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    now[w].present = walls[w].motion.kind == WallMotion<2>::Kind::none && !std::isfinite(walls[w].opens_at);
  }
  const auto box = make_box(scene);
  const double radius = 0.5 * scene.smallest_drawn();
  constexpr int places = 1000;
  std::optional<std::size_t> blocking;
  for (int k = -places; k <= places; ++k) {
    const Vec<2> place{{x + half_width * k / places, height}};
    const auto wall = overlapping_wall(walls, now, box, place, radius, scene.contact_reach());
    if (!wall) return std::nullopt;
    if (k == 0) blocking = wall;
  }
  return blocking;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.base->wall(scene)) names.emplace_back("base");
  for (const auto& wall : scene.planes) names.push_back(wall.name);
  for (const auto& wall : scene.pieces) names.push_back(wall.name);
  for (const auto& drum : scene.drums) {
    const auto of_drum = drum_wall_names(drum);
    names.insert(names.end(), of_drum.begin(), of_drum.end());
  }
  return names;
}

std::string partner_name(const Scene& scene, std::int64_t partner) {
  if (partner >= 0) return "grain " + std::to_string(partner);
  return "wall " + wall_names(scene).at(static_cast<std::size_t>(-1 - partner));
}

Box<2> make_box(const Scene& scene) {
  Box<2> box;
  box.periodic = scene.box.periodic();
  box.x_min = -scene.box.half_width;
  box.x_max = scene.box.half_width;
  constexpr double fall_below_base = 5.0;  // diameters below base grains: nothing comes back from there
  if (scene.method->traits().follows_time && (scene.base->of_grains() || scene.start.base)) {
    box.floor = -scene.base->depth() - fall_below_base * scene.largest_diameter();
  }
  if (scene.box.floor) box.floor = *scene.box.floor;
  return box;
}

UprightSides upright_sides(const Scene& scene) {
  UprightSides sides{-scene.box.half_width, scene.box.half_width};
  for (const auto& plane : scene.planes) {
    if (plane.normal[1] != 0.0) continue;
    if (plane.normal[0] > 0.0) sides.left = std::max(sides.left, plane.point[0]);
    if (plane.normal[0] < 0.0) sides.right = std::min(sides.right, plane.point[0]);
  }
  return sides;
}

}  // namespace repose
