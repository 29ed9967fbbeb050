// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"

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
  return walls;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.base->wall(scene)) names.emplace_back("base");
  for (const auto& wall : scene.planes) names.push_back(wall.name);
  for (const auto& wall : scene.pieces) names.push_back(wall.name);
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

}  // namespace repose
