// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

constexpr std::array<double, 2> nothing{0.0, 0.0};

void base_keys(Scene& scene, Keys& keys) {
  keys.choice("base.kind", scene.base.kind, "none", {"row", "deposited", "contiguous", "plane", "none"},
              "what the heap stands on, at height 0: a row of fixed grains, fixed grains of the sizes of the others at "
              "random heights, touching discs as a deposition has them, a plane, or nothing");
  if (scene.base.kind == "contiguous") {
    keys.integer("base.count", scene.base.count, 32, 2, "touching discs, from side to side of the box");
    scene.base.half_width = 0.5 * static_cast<double>(scene.base.count) * scene.grains.diameter;
  } else if (scene.base.kind == "row") {
    keys.number("base.spacing", scene.base.spacing, scene.grains.diameter, positive, "L",
                "between the centres, one of them at x = 0");
    keys.number("base.half_width", scene.base.half_width, required, positive, "L", "the row covers +- this");
  } else if (scene.base.kind == "deposited") {
    keys.number("base.roughness", scene.base.roughness, 0.25 * scene.smallest_drawn(), not_negative, "L",
                "centres lie between this below height 0 and 0; at most half the smallest diameter");
    keys.number("base.half_width", scene.base.half_width, required, positive, "L", "the base covers +- this");
  } else if (scene.base.kind == "plane") {
    keys.flag("base.smooth", scene.base.smooth, false,
              "no friction, and the height of the centre as distance (Baxter et al. 1997)");
  }
  if (scene.base.kind != "none") material_key("base.material", scene.base.material, scene, keys);
}

void deposition_base_keys(Scene& scene, Keys& keys) {
  keys.choice(
      "base.kind", scene.base.kind, "contiguous", {"contiguous", "flat", "disordered"},
      "what the first discs fall on: a row of touching discs with centres at height 0, the floor below, or discs "
      "at random places on it until no more fit");
  keys.integer("base.count", scene.base.count, 32, 2, "width in diameters: so many discs make a contiguous base");
  keys.choice("box.x", scene.box.x, "periodic", {"periodic", "walls"}, "what is at the sides");
  scene.base.half_width = scene.box.half_width = 0.5 * static_cast<double>(scene.base.count) * scene.grains.diameter;
}

void box_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  const bool contiguous = scene.base.kind == "contiguous";
  keys.choice("box.x", scene.box.x, contiguous ? "periodic" : "open", {"open", "periodic"},
              "grains that leave an open box are lost and counted");
  const double room = scene.base.of_grains() ? scene.base.half_width : 200.0 * d;
  if (contiguous && scene.box.x == "periodic") {
    scene.box.half_width = scene.base.half_width;
  } else {
    keys.number("box.half_width", scene.box.half_width, scene.box.x == "periodic" ? room : room + 20.0 * d, positive,
                "L", "x from -half_width to half_width");
  }
  keys.optional_number(
      "box.floor", scene.box.floor, "auto", any, "L",
      "grains that fall below are lost and counted; \"auto\": 5 diameters below base grains, else nowhere");
}

void motion_keys(const std::string& prefix, Scene::Wall& wall, Keys& keys) {
  keys.choice(
      prefix + "motion", wall.motion, "fixed", {"fixed", "velocity", "force", "spring"},
      "given velocity, given force on a piston, or a piston pulled by a spring whose far end goes at a velocity");
  const bool feels = wall.motion == "force" || wall.motion == "spring";
  if (wall.motion == "velocity" || wall.motion == "spring") {
    keys.vector(prefix + "velocity", wall.velocity, std::nullopt, "L/T",
                "of the wall, or of the far end of the spring");
  }
  if (wall.motion == "force") {
    keys.vector(prefix + "force", wall.force, std::nullopt, "M L/T^2", "on the piston, which moves along it");
  }
  if (wall.motion == "spring") {
    keys.number(prefix + "stiffness", wall.stiffness, required, positive, "M/T^2", "of the spring");
  }
  if (feels) {
    keys.number(prefix + "mass", wall.mass, required, positive, "M", "of the piston; gravity does not act on it");
    keys.number(prefix + "drag", wall.drag, 0.0, not_negative, "M/T", "force against the motion per speed");
  }
  if (wall.motion != "fixed") keys.number(prefix + "start", wall.start, 0.0, not_negative, "T", "it stands until then");
}

void wall_keys(const std::string& prefix, Scene::Wall& wall, const std::string& name, const Scene& scene, Keys& keys) {
  keys.text(prefix + "name", wall.name, name, "under which its series is kept");
  keys.flag(prefix + "smooth", wall.smooth, false, "as base.smooth");
  material_key(prefix + "material", wall.material, scene, keys);
  motion_keys(prefix, wall, keys);
  keys.optional_number(prefix + "opens_at", wall.opens_at, "", not_negative, "T", "from then on it is not there");
}

}  // namespace

void boundary_keys(Scene& scene, Keys& keys) {
  if (scene.method.deposits()) return deposition_base_keys(scene, keys);
  base_keys(scene, keys);
  box_keys(scene, keys);
  table_keys<Scene::Wall>(keys, "plane", scene.planes, [&](const auto& prefix, auto& plane, std::size_t k) {
    keys.vector(prefix + "point", plane.point, std::nullopt, "L", "a point of the plane");
    keys.vector(prefix + "normal", plane.normal, std::nullopt, "", "towards the grains");
    wall_keys(prefix, plane, fmt::format("plane {}", k), scene, keys);
  });
  table_keys<Scene::Wall>(keys, "wall", scene.pieces, [&](const auto& prefix, auto& piece, std::size_t k) {
    keys.vector(prefix + "from", piece.from, std::nullopt, "L",
                "one end of a straight piece of wall, which has two sides");
    keys.vector(prefix + "to", piece.to, std::nullopt, "L", "the other end");
    wall_keys(prefix, piece, fmt::format("wall {}", k), scene, keys);
  });
  table_keys<Scene::Load>(keys, "load", scene.loads, [&](const auto& prefix, auto& load, std::size_t) {
    keys.vector(prefix + "force", load.force, std::nullopt, "M L/T^2", "that acts on one grain");
    keys.integer(prefix + "grain", load.grain, -1, -1, "its id; -1: the moving grain nearest to the position");
    if (load.grain < 0) keys.vector(prefix + "position", load.position, nothing, "L", "at the start of the load");
    keys.number(prefix + "start", load.start, 0.0, not_negative, "T", "of the load");
  });
}

}  // namespace repose
