// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"

namespace repose {

namespace {

Vec<2> vector_of(const std::array<double, 2>& numbers) { return {{numbers[0], numbers[1]}}; }
Vec<2> direction_of(const Vec<2>& vector) { return vector * (1.0 / magnitude(vector)); }

void set_motion(const Scene::Wall& from, Wall<2>& wall) {
  using Kind = WallMotion<2>::Kind;
  auto& motion = wall.motion;
  wall.smooth = from.smooth;
  if (from.opens_at) wall.opens_at = *from.opens_at;
  if (from.motion == "fixed") return;
  motion.kind = from.motion == "velocity" ? Kind::velocity : (from.motion == "force" ? Kind::force : Kind::spring);
  const Vec<2> along = vector_of(from.motion == "force" ? from.force : from.velocity);
  motion.direction = direction_of(along);
  (from.motion == "force" ? motion.force : motion.speed) = magnitude(along);
  motion.stiffness = from.stiffness;
  motion.mass = from.mass;
  motion.drag = from.drag;
  motion.start = from.start;
}

}  // namespace

std::vector<Wall<2>> make_walls(const Scene& scene) {
  std::vector<Wall<2>> walls;
  if (scene.base.kind == "plane") {
    walls.push_back({.point = {}, .normal = {{0.0, 1.0}}, .smooth = scene.base.smooth});
    walls.back().material = scene.material_number(scene.base.material);
  }
  for (const auto& plane : scene.planes) {
    Wall<2> wall{.point = vector_of(plane.point), .normal = direction_of(vector_of(plane.normal))};
    set_motion(plane, wall);
    wall.material = scene.material_number(plane.material);
    walls.push_back(wall);
  }
  for (const auto& piece : scene.pieces) {
    const Vec<2> along = vector_of(piece.to) - vector_of(piece.from);
    Wall<2> wall{.point = vector_of(piece.from) + along * 0.5,
                 .normal = direction_of({{-along[1], along[0]}}),
                 .half_length = 0.5 * magnitude(along)};
    set_motion(piece, wall);
    wall.material = scene.material_number(piece.material);
    walls.push_back(wall);
  }
  return walls;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.base.kind == "plane") names.push_back("base");
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
  box.periodic = scene.box.x == "periodic";
  box.x_min = -scene.box.half_width;
  box.x_max = scene.box.half_width;
  constexpr double fall_below_base = 5.0;  // diameters below base grains: nothing comes back from there
  if (!scene.method.deposits() && (scene.base.of_grains() || scene.start.base)) {
    box.floor = -scene.base.roughness - fall_below_base * scene.largest_diameter();
  }
  if (scene.box.floor) box.floor = *scene.box.floor;
  return box;
}

}  // namespace repose
