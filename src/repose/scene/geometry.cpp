// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"

#include "repose/core/errors.hpp"

#include <cmath>

namespace repose {

namespace {

template <int D>
Vec<D> direction_of(const Vec<D>& vector) {
  return vector * (1.0 / magnitude(vector));
}

/// What an endless wall and one of finite extent have in common.
template <int D>
void complete(const SceneWall& from, const Scene& scene, Wall<D>& wall) {
  wall.smooth = from.smooth;
  wall.material = scene.material_number(from.material);
  wall.motion = from.motion->motion(Dimension<D>{});
  if (from.opens_at) wall.opens_at = *from.opens_at;
}

/// A wall from one end to the other.
Wall<2> piece_of(const SceneWall& piece) {
  const Vec<2> along = vec<2>(piece.to) - vec<2>(piece.from);
  return {.point = vec<2>(piece.from) + along * 0.5,
          .normal = direction_of(Vec<2>{{-along[1], along[0]}}),
          .half_length = 0.5 * magnitude(along)};
}

/// The walls that a [[wall]] consists of.
template <int D>
std::vector<Wall<D>> walls_of(const SceneWall& piece) {
  if constexpr (D == 2) {
    return {piece_of(piece)};
  } else {
    return piece.shape->walls();
  }
}

}  // namespace

template <int D>
std::vector<Wall<D>> make_walls(const Scene& scene) {
  std::vector<Wall<D>> walls;
  if (const auto base = scene.base->wall(scene)) {
    Wall<D> wall;
    wall.normal[up<D>] = 1.0;
    wall.smooth = base->smooth;
    wall.material = base->material;
    walls.push_back(wall);
  }
  for (const auto& plane : scene.planes) {
    Wall<D> wall;
    wall.point = vec<D>(plane.point);
    wall.normal = direction_of(vec<D>(plane.normal));
    complete(plane, scene, wall);
    walls.push_back(wall);
  }
  for (const auto& piece : scene.pieces) {
    for (auto wall : walls_of<D>(piece)) {
      complete(piece, scene, wall);
      walls.push_back(wall);
    }
  }
  if constexpr (D == 2) {
    for (const auto& drum : scene.drums) {
      const auto of_drum = drum_walls(drum, scene.material_number(drum.material));
      walls.insert(walls.end(), of_drum.begin(), of_drum.end());
    }
  }
  return walls;
}

template <int D>
std::vector<WallNow<D>> walls_at(const std::vector<Wall<D>>& walls, const std::vector<WallState>& states, double time) {
  REPOSE_ASSERT(states.empty() || states.size() == walls.size());
  std::vector<WallNow<D>> now;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    now.push_back(wall_now(walls[w], states.empty() ? WallState{} : states[w], time));
  }
  return now;
}

template <int D>
std::optional<std::size_t> overlapping_wall(const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now,
                                            const Box<D>& box, const Vec<D>& centre, double radius, double reach) {
  const double kept_free = 2.0 * radius * (reach - 1.0);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!now[w].present) continue;
    const auto place = above(walls[w], now[w], from_wall(walls[w], now[w], centre, box));
    if (wall_overlap(walls[w], place, radius) + kept_free > 0.0) return w;
  }
  return std::nullopt;
}

template <int D>
std::optional<std::size_t> wall_that_blocks(const Scene& scene, const std::vector<Vec<D>>& places) {
  const auto walls = make_walls<D>(scene);
  auto now = walls_at(walls, {}, 0.0);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    now[w].present = walls[w].motion.kind == WallMotion<D>::Kind::none && !std::isfinite(walls[w].opens_at);
  }
  const auto box = make_box<D>(scene);
  const double radius = 0.5 * scene.smallest_drawn();
  std::optional<std::size_t> blocking;
  for (const auto& place : places) {
    const auto wall = overlapping_wall(walls, now, box, place, radius, scene.contact_reach());
    if (!wall) return std::nullopt;
    if (!blocking) blocking = wall;
  }
  return blocking;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.base->wall(scene)) names.emplace_back("base");
  for (const auto& wall : scene.planes) names.push_back(wall.name);
  for (const auto& piece : scene.pieces) {
    const auto count = scene.dimension == 3 ? walls_of<3>(piece).size() : 1;
    for (std::size_t k = 0; k < count; ++k) {
      names.push_back(count == 1 ? piece.name : piece.name + " " + std::to_string(k));
    }
  }
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

template <int D>
Box<D> make_box(const Scene& scene) {
  Box<D> box;
  box.periodic = scene.box.periodic();
  box.x_min = -scene.box.half_width;
  box.x_max = scene.box.half_width;
  if constexpr (D == 3) {
    box.periodic_y = scene.box.periodic_y();
    box.y_min = -scene.box.half_depth;
    box.y_max = scene.box.half_depth;
  }
  constexpr double fall_below_base = 5.0;  // diameters below base grains: nothing comes back from there
  if (scene.method->traits().follows_time && (scene.base->of_grains() || scene.start.base)) {
    box.floor = -scene.base->depth(scene) - fall_below_base * scene.largest_diameter();
  }
  if (scene.box.floor) box.floor = *scene.box.floor;
  return box;
}

UprightSides upright_sides(const Scene& scene) {
  UprightSides sides{-scene.box.half_width, scene.box.half_width};
  for (const auto& plane : scene.planes) {
    if (plane.normal[scene.vertical()] != 0.0 || (scene.dimension == 3 && plane.normal[1] != 0.0)) continue;
    if (plane.normal[0] > 0.0) sides.left = std::max(sides.left, plane.point[0]);
    if (plane.normal[0] < 0.0) sides.right = std::min(sides.right, plane.point[0]);
  }
  return sides;
}

template std::vector<Wall<2>> make_walls(const Scene&);
template std::vector<Wall<3>> make_walls(const Scene&);
template std::vector<WallNow<2>> walls_at(const std::vector<Wall<2>>&, const std::vector<WallState>&, double);
template std::vector<WallNow<3>> walls_at(const std::vector<Wall<3>>&, const std::vector<WallState>&, double);
template std::optional<std::size_t> overlapping_wall(const std::vector<Wall<2>>&, const std::vector<WallNow<2>>&,
                                                     const Box<2>&, const Vec<2>&, double, double);
template std::optional<std::size_t> overlapping_wall(const std::vector<Wall<3>>&, const std::vector<WallNow<3>>&,
                                                     const Box<3>&, const Vec<3>&, double, double);
template std::optional<std::size_t> wall_that_blocks(const Scene&, const std::vector<Vec<2>>&);
template std::optional<std::size_t> wall_that_blocks(const Scene&, const std::vector<Vec<3>>&);
template Box<2> make_box(const Scene&);
template Box<3> make_box(const Scene&);

}  // namespace repose
