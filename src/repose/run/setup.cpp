// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/setup.hpp"

#include "repose/methods/soft/soft.hpp"

#include <cmath>

namespace repose {

namespace {

std::vector<double> row_places(const Scene& scene) {
  const double spacing = scene.base.spacing;
  std::vector<double> places;
  if (scene.box.x == "periodic") {
    const long count = std::lround(2.0 * scene.box.half_width / spacing);
    for (long k = 0; k < count; ++k) places.push_back(static_cast<double>(k - count / 2) * spacing);
  } else {
    const long side = static_cast<long>(std::floor(scene.base.half_width / spacing + 1e-9));
    for (long k = -side; k <= side; ++k) places.push_back(static_cast<double>(k) * spacing);
  }
  return places;
}

/// A triangular lattice pile whose lowest grains lie in the hollows of the base row, or side by side on a plane.
void add_lattice(const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  const double d = scene.grains.diameter;
  const double pitch = scene.base_pitch();
  const double rise = std::sqrt(d * d - 0.25 * pitch * pitch);
  const bool on_row = scene.base.kind == "row";
  const double lowest = on_row ? rise : (scene.base.smooth ? d : 0.5 * d);
  // The grains of a row of even length lie at odd multiples of half a pitch about its middle, and so do hollows.
  const double shift = on_row && scene.source.rows % 2 == 1 ? 0.5 * pitch : 0.0;
  const double middle = on_row ? std::round((scene.source.x - shift) / pitch) * pitch + shift : scene.source.x;
  for (std::int64_t row = 0; row < scene.source.rows; ++row) {
    const auto count = scene.source.rows - row;
    for (std::int64_t k = 0; k < count; ++k) {
      auto grain = make_grain(scene, d);
      grain.position[0] = middle + (static_cast<double>(k) - 0.5 * static_cast<double>(count - 1)) * pitch;
      grain.position[1] = lowest + static_cast<double>(row) * rise;
      grains.add(grain, id++);
    }
  }
}

}  // namespace

Grain<2> make_grain(const Scene& scene, double diameter, const std::string& material) {
  Grain<2> grain;
  grain.radius = 0.5 * diameter;
  grain.mass = scene.mass_of(diameter, material);
  grain.inverse_mass = 1.0 / grain.mass;
  return grain;
}

Grains<2> initial_grains(const Scene& scene) {
  Grains<2> grains;
  std::int64_t id = 0;
  if (scene.base.kind == "row") {
    for (const double x : row_places(scene)) {
      auto grain = make_grain(scene, scene.grains.diameter, scene.base.material);
      grain.inverse_mass = 0.0;
      grain.position[0] = x;
      grains.add(grain, id++, true, scene.material_number(scene.base.material));
    }
  }
  if (scene.source.kind == "lattice") add_lattice(scene, grains, id);
  for (const auto& placed : scene.placed) {
    auto grain = make_grain(scene, placed.diameter, placed.material);
    for (int k = 0; k < 2; ++k) {
      grain.position[k] = placed.position[static_cast<std::size_t>(k)];
      grain.velocity[k] = placed.velocity[static_cast<std::size_t>(k)];
    }
    grain.rim_velocity = placed.spin * grain.radius;
    if (placed.fixed) {
      grain.inverse_mass = 0.0;
      grain.velocity = {};
      grain.rim_velocity = 0.0;
    }
    grains.add(grain, id++, false, scene.material_number(placed.material));
  }
  return grains;
}

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

Box<2> make_box(const Scene& scene) {
  Box<2> box;
  box.periodic = scene.box.x == "periodic";
  box.x_min = -scene.box.half_width;
  box.x_max = scene.box.half_width;
  constexpr double fall_below_base = 5.0;  // diameters below a row of grains: nothing comes back from there
  if (scene.base.kind == "row") box.floor = -fall_below_base * scene.largest_diameter();
  if (scene.box.floor) box.floor = *scene.box.floor;
  return box;
}

std::unique_ptr<Method<2>> make_method(const Scene& scene) {
  SoftSettings<2> settings;
  settings.time_step = scene.time_step();
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  settings.synchronised = scene.synchronised();
  settings.audit = scene.output.energy;
  settings.skin = scene.method.skin;
  return make_soft<2>(scene.material_laws(), settings);
}

}  // namespace repose
