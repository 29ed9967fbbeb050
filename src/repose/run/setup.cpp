// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/setup.hpp"

#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"
#include "repose/methods/deposition/deposition.hpp"
#include "repose/methods/soft/soft.hpp"
#include "repose/run/sources/draw.hpp"
#include "repose/run/sources/initial.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

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
  add_base(scene, grains, id);
  if (scene.method.deposits()) return grains;
  add_start(scene, grains, id);
  add_lattice(scene, grains, id);
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
  constexpr double fall_below_base = 5.0;  // diameters below base grains: nothing comes back from there
  if (!scene.method.deposits() && (scene.base.of_grains() || scene.start.base)) {
    box.floor = -scene.base.roughness - fall_below_base * scene.largest_diameter();
  }
  if (scene.box.floor) box.floor = *scene.box.floor;
  return box;
}

namespace {

std::unique_ptr<Method<2>> make_deposition_of(const Scene& scene) {
  DepositionSettings settings;
  settings.critical_angle_deg = scene.method.critical_angle;
  settings.box = make_box(scene);
  settings.floor = -0.5 * scene.grains.diameter;
  settings.smallest_radius = 0.5 * std::min(scene.smallest_drawn(), scene.grains.diameter);
  settings.largest_radius = 0.5 * std::max(scene.largest_drawn(), scene.grains.diameter);
  settings.snapped = scene.snapped();
  settings.count = scene.source.count;
  settings.drop = [seed = static_cast<std::uint64_t>(scene.seed),
                   draw = GrainDraw(scene, Purpose::grain_species, Purpose::grain_size)](std::int64_t k) {
    const auto index = static_cast<std::uint64_t>(k);
    const auto [grain, material] = draw(index);
    return DroppedDisc{uniform(seed, Purpose::release_position, index), grain, material};
  };
  return make_deposition(settings);
}

std::unique_ptr<Method<2>> make_contact_dynamics_of(const Scene& scene) {
  ContactDynamicsSettings<2> settings;
  settings.time_step = scene.time_step();
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  if (const auto limit = scene.speed_limit()) settings.speed_limit = *limit;
  settings.solver.tolerance = scene.method.tolerance;
  settings.solver.most_sweeps = scene.method.most_sweeps;
  settings.solver.accelerated = scene.method.solver == "accelerated";
  settings.overlap_recovery = scene.method.overlap_recovery;
  settings.skin = scene.method.skin;
  return make_contact_dynamics<2>(scene.impulse_laws(), settings);
}

}  // namespace

std::unique_ptr<Method<2>> make_method(const Scene& scene) {
  if (scene.method.deposits()) return make_deposition_of(scene);
  if (scene.method.rigid()) return make_contact_dynamics_of(scene);
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
