// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/boundaries.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace repose {

namespace {

constexpr Coordinates origin{};

void base_key(Scene& scene, Parameters& keys) {
  const auto traits = scene.method->traits();
  const auto suits = [&](const BaseKind& base) { return base.suits(traits) && base.in_dimension(scene.dimension); };
  kind_key("base.kind", scene.base, base_kinds(), suits,
           {traits.follows_time    ? "none"
            : scene.dimension == 2 ? "contiguous"
                                   : "floor",
            ""},
           "what the grains rest on, at height 0", keys);
  scene.base->keys(scene, keys);
}

void box_keys(Scene& scene, Parameters& keys) {
  const double d = scene.grains.diameter;
  const bool in_time = scene.method->traits().follows_time;
  const auto of_base = scene.base->box_half_width(scene);
  const std::vector<Word> sides = in_time                ? std::vector<Word>{"open", "periodic"}
                                  : scene.dimension == 2 ? std::vector<Word>{"periodic", "walls"}
                                                         : std::vector<Word>{"open", "periodic", "walls"};
  keys.choice("box.x", scene.box.x,
              {of_base ? "periodic" : "open", in_time ? "\"open\"; \"periodic\" over a contiguous base" : ""}, sides,
              in_time ? "its sides; grains that leave an open box are lost and counted" : "its sides");
  if (of_base && !scene.box.open()) {
    scene.box.half_width = *of_base;
  } else {
    const double room = scene.base->of_grains() ? scene.base->reach(scene) : 200.0 * d;
    keys.number("box.half_width", scene.box.half_width,
                {scene.box.periodic() ? room : room + 20.0 * d,
                 "base.half_width or base.radius, or 200 d without a base of grains; 20 d more if open"},
                positive, "L", "x from -half_width to half_width");
  }
  if (scene.dimension == 3) {
    keys.choice("box.y", scene.box.y, {scene.box.x, "as box.x"}, sides, "its sides along y");
    keys.number("box.half_depth", scene.box.half_depth, {scene.box.half_width, "box.half_width"}, positive, "L",
                "y from -half_depth to half_depth");
  }
  if (!in_time) return;
  keys.optional_number(
      "box.floor", scene.box.floor, {"auto", ""}, any, "L",
      "grains that fall below are lost and counted; \"auto\": 5 diameters below base grains, else nowhere");
}

void wall_keys(SceneWall& wall, const DefaultOf<std::string_view>& name, const Scene& scene, Parameters& keys) {
  const auto suits = [&](const MotionKind& motion) { return motion.in_dimension(scene.dimension); };
  keys.text("name", wall.name, name, "name of its series in the output");
  keys.flag("smooth", wall.smooth, "as base.smooth");
  material_key("material", wall.material, scene, keys);
  kind_key("motion", wall.motion, motion_kinds(), suits, "fixed", "how it moves", keys);
  wall.motion->keys(keys, scene.dimension);
  keys.optional_number("opens_at", wall.opens_at, {"", "never"}, not_negative, "T", "the wall is removed at this time");
}

void check_direction(const std::string& key, const Coordinates& vector, const Scene& scene, Problems& problems) {
  if (reproducible::hypot(reproducible::hypot(vector[0], vector[1]), vector[2]) >= 1e-100) return;
  if (!problems.sound(key)) return;
  problems.problem(key, fmt::format(" = {}: must have a direction", coordinates_text(vector, scene.dimension)));
}

/// An explicit step must follow a piston on its spring and between the grains that may touch it at once.
template <int D>
void check_piston(const std::string& prefix, const Wall<D>& piston, const Scene& scene, Problems& problems) {
  const auto& motion = piston.motion;
  const double step = scene.time_step();
  const double frequency = scene.contact_frequency();
  const double contact = scene.nominal_mass() * (frequency * frequency);
  const double phase = step * std::sqrt((motion.stiffness + contact) / motion.mass);
  const auto least = scene.least_piston(piston);
  const double needed = std::max(least.mass, phase > 1.0 ? motion.mass * phase * phase : 0.0);
  if (motion.mass >= needed) return;
  problems.problem(prefix + "mass",
                   fmt::format(" = {}: too light for the time step {:.4g}: up to {:.0f} grains may touch the piston at "
                               "once, and it cannot follow them; at least {:.4g} [M], or a smaller method.time_step",
                               motion.mass, step, least.grains, needed));
}

void check_motion(const std::string& prefix, const SceneWall& wall, std::size_t number, const Scene& scene,
                  Problems& problems) {
  if (const auto* stop = wall.motion->stop(); stop != nullptr && *stop && **stop <= wall.motion->start()) {
    if (problems.sound(prefix + "stop") && problems.sound(prefix + "start")) {
      problems.problem(prefix + "stop",
                       fmt::format(" = {}: must be after its start = {}", **stop, wall.motion->start()));
    }
  }
  if (const auto* direction = wall.motion->direction()) {
    check_direction(prefix + std::string(wall.motion->direction_key()), *direction, scene, problems);
  }
  const auto* piston = wall.motion.as<Piston>();
  if (piston != nullptr && piston->surface_speed != 0.0 && scene.method->traits().impulse_laws &&
      problems.sound(prefix + "surface_speed")) {
    problems.problem(prefix + "surface_speed",
                     fmt::format(" = {}: contact dynamics lets the surface of a belt run, not "
                                 "that of a piston",
                                 piston->surface_speed));
  }
  if (piston == nullptr || !scene.method->traits().force_laws || !problems.none()) return;
  with_dimension(scene.dimension,
                 [&](auto dimension) { check_piston(prefix, make_walls<dimension>(scene)[number], scene, problems); });
}

/// Walls are known by their names in the output.
void check_names(const Scene& scene, Problems& problems) {
  std::set<std::string> names;
  const auto check = [&](const std::string& table, const auto& walls) {
    for (std::size_t k = 0; k < walls.size(); ++k) {
      if (names.insert(walls[k].name).second) continue;
      problems.problem(fmt::format("{}[{}].name", table, k), fmt::format(" = \"{}\": is used twice", walls[k].name));
    }
  };
  check("plane", scene.planes);
  check("wall", scene.pieces);
  check("drum", scene.drums);
}

void check_box(const Scene& scene, Problems& problems) {
  const auto& box = scene.box;
  const bool of_base = scene.base->box_half_width(scene).has_value() && !box.open();
  if (of_base || !problems.sound("box.half_width")) return;
  if (box.periodic() && box.half_width < 4.0 * scene.largest_diameter()) {
    problems.problem("box.half_width", fmt::format(" = {}: a periodic box must be at least 8 of the largest diameters "
                                                   "wide",
                                                   box.half_width));
  } else if (box.periodic() && problems.none() && scene.contact_reach() * scene.largest_diameter() >= box.half_width) {
    problems.problem("box.half_width",
                     fmt::format(" = {}: the largest grains act on each other up to {} apart, which must be less than "
                                 "half of a periodic box",
                                 box.half_width, scene.contact_reach() * scene.largest_diameter()));
  }
  if (scene.dimension == 3 && box.periodic_y() && problems.sound("box.half_depth") &&
      box.half_depth < 4.0 * scene.largest_diameter()) {
    problems.problem("box.half_depth", fmt::format(" = {}: a periodic box must be at least 8 of the largest diameters "
                                                   "deep",
                                                   box.half_depth));
  }
  if (!scene.base->of_grains()) return;
  const auto* reach = scene.dimension == 2 ? "base.half_width" : "base.radius";
  const auto must_hold_base = [&](const std::string& key, double half) {
    if (!problems.sound(reach) || !problems.sound(key) || half >= scene.base->reach(scene)) return;
    problems.problem(key, fmt::format(" = {}: must be at least {} = {}", half, reach, scene.base->reach(scene)));
  };
  if (!box.periodic()) must_hold_base("box.half_width", box.half_width);
  if (scene.dimension == 3 && !box.periodic_y()) must_hold_base("box.half_depth", box.half_depth);
}

void check_planes(const Scene& scene, Problems& problems) {
  const std::size_t before = scene.base->wall(scene) ? 1 : 0;  // walls of the scene that precede the planes
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const auto prefix = fmt::format("plane[{}].", k);
    const auto& normal = scene.planes[k].normal;
    check_direction(prefix + "normal", normal, scene, problems);
    const double level = 1e-12 * std::fabs(normal[scene.vertical()]);
    const bool leans_x = scene.box.periodic() && std::fabs(normal[0]) > level;
    const bool leans_y = scene.dimension == 3 && scene.box.periodic_y() && std::fabs(normal[1]) > level;
    if ((leans_x || leans_y) && problems.sound(prefix + "normal")) {
      problems.problem(prefix + "normal",
                       fmt::format(" = {}: a plane must be level in a periodic box; a [[wall]] need not be",
                                   coordinates_text(normal, scene.dimension)));
    }
    if (scene.planes[k].motion.as<RotatingWall>() != nullptr && problems.sound(prefix + "motion")) {
      problems.problem(prefix + "motion", " = \"rotation\": a plane is endless; a [[wall]] can rotate");
    }
    check_motion(prefix, scene.planes[k], before + k, scene, problems);
  }
}

/// Walls of finite extent in three dimensions. `before`: walls of the scene that precede them.
void check_shapes(std::size_t before, const Scene& scene, Problems& problems) {
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    const auto& piece = scene.pieces[k];
    const auto prefix = fmt::format("wall[{}].", k);
    piece.shape->check(prefix, scene.grains.diameter, problems);
    if (!problems.none()) continue;
    const auto walls = piece.shape->walls().size();
    const bool flat = piece.shape.as<CylinderShape>() == nullptr && piece.shape.as<ConicalShape>() == nullptr;
    if ((walls > 1 || !flat) && piece.motion.as<Piston>() != nullptr) {
      problems.problem(prefix + "motion", fmt::format(" = \"{}\": a piston is flat", piece.motion->name()));
    }
    check_motion(prefix, piece, before, scene, problems);
    before += walls;
  }
}

void check_pieces(const Scene& scene, Problems& problems) {
  const std::size_t before = (scene.base->wall(scene) ? 1 : 0) + scene.planes.size();
  if (scene.dimension == 3) return check_shapes(before, scene, problems);
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    const auto& piece = scene.pieces[k];
    const auto prefix = fmt::format("wall[{}].", k);
    const double length = reproducible::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
    if (length < 1e-6 * scene.grains.diameter && problems.sound(prefix + "from") && problems.sound(prefix + "to")) {
      problems.problem(prefix + "to", fmt::format(" = [{}, {}]: is where the wall begins", piece.to[0], piece.to[1]));
    }
    check_motion(prefix, piece, before + k, scene, problems);
  }
}

}  // namespace

void boundary_keys(Scene& scene, Parameters& keys) {
  base_key(scene, keys);
  box_keys(scene, keys);
  if (!scene.method->traits().follows_time) return;
  table_keys(keys, "plane", scene.planes, [&](Parameters& entry, SceneWall& plane, std::size_t k) {
    entry.vector("point", plane.point, scene.dimension, std::nullopt, "L", "a point on the plane");
    entry.vector("normal", plane.normal, scene.dimension, std::nullopt, "", "normal vector, towards the grains");
    wall_keys(plane, {fmt::format("plane {}", k), "\"plane k\""}, scene, entry);
  });
  table_keys(keys, "wall", scene.pieces, [&](Parameters& entry, SceneWall& piece, std::size_t k) {
    if (scene.dimension == 2) {
      entry.vector("from", piece.from, 2, std::nullopt, "L", "one end of a straight wall, which has two sides");
      entry.vector("to", piece.to, 2, std::nullopt, "L", "the other end");
    } else {
      kind_key("shape", piece.shape, shape_kinds(), any_kind, "", "shape of the wall, which has two sides", entry);
      piece.shape->keys(entry);
    }
    wall_keys(piece, {fmt::format("wall {}", k), "\"wall k\""}, scene, entry);
  });
  if (scene.dimension == 2) drum_keys(scene, keys);
  table_keys(keys, "load", scene.loads, [&](Parameters& entry, SceneLoad& load, std::size_t) {
    entry.vector("force", load.force, scene.dimension, std::nullopt, "M L/T^2", "force on one grain");
    entry.integer("grain", load.grain, {.low = -1}, "its id; -1: the moving grain nearest to the position");
    if (load.grain < 0) {
      entry.vector("position", load.position, scene.dimension, origin, "L", "place at the start of the load");
    }
    entry.number("start", load.start, not_negative, "T", "the load begins then");
  });
}

void check_boundaries(const Scene& scene, Problems& problems) {
  check_direction("gravity_direction", scene.gravity_direction, scene, problems);
  scene.base->check(scene, problems);
  check_box(scene, problems);
  check_planes(scene, problems);
  check_pieces(scene, problems);
  check_names(scene, problems);
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    check_direction(fmt::format("load[{}].force", k), scene.loads[k].force, scene, problems);
  }
}

}  // namespace repose
