// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/reproducible_math.hpp"
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace repose {

namespace {

void check_direction(const std::string& key, const std::array<double, 2>& vector, Reader& reader) {
  if (reproducible::hypot(vector[0], vector[1]) < 1e-100 && reader.sound(key)) {
    reader.problem(key, fmt::format(" = [{}, {}]: must have a direction", vector[0], vector[1]));
  }
}

void check_motion(const std::string& prefix, const Scene::Wall& wall, const Scene& scene, Reader& reader) {
  if (wall.motion == "velocity" || wall.motion == "spring") check_direction(prefix + "velocity", wall.velocity, reader);
  if (wall.motion == "force") check_direction(prefix + "force", wall.force, reader);
  const bool feels = wall.motion == "force" || wall.motion == "spring";
  if (!feels || scene.method.rigid() || !reader.problems().empty()) return;
  // The piston on its spring, or between it and one grain: explicit steps are unstable beyond w dt = 2.
  const double step = scene.time_step();
  const double frequency = scene.contact_frequency();
  const double contact = scene.grains.mass * (frequency * frequency);
  const double phase = step * std::sqrt((wall.stiffness + contact) / wall.mass);
  if (phase <= 1.0) return;
  reader.problem(prefix + "mass",
                 fmt::format(" = {}: too light for the time step {:.4g}: w dt = {:.3g} > 1 against one grain and its "
                             "spring; at least {:.4g} [M], and more where many grains touch it",
                             wall.mass, step, phase, wall.mass * phase * phase));
}

/// Walls are known by their names in the output.
void check_names(const Scene& scene, Reader& reader) {
  std::set<std::string> names;
  const auto check = [&](const std::string& table, const std::vector<Scene::Wall>& walls) {
    for (std::size_t k = 0; k < walls.size(); ++k) {
      if (names.insert(walls[k].name).second) continue;
      reader.problem(fmt::format("{}[{}].name", table, k), fmt::format(" = \"{}\": is taken", walls[k].name));
    }
  };
  check("plane", scene.planes);
  check("wall", scene.pieces);
}

void check_deposited(const Scene& scene, Reader& reader) {
  constexpr double most_base_grains = 1e7;
  const double smallest = scene.smallest_drawn();
  const double largest = scene.largest_drawn();
  const bool periodic = scene.box.x == "periodic";
  const double width = 2.0 * (periodic ? scene.box.half_width : scene.base.half_width);
  const std::string key = periodic ? "box.half_width" : "base.half_width";
  if (reader.sound("base.roughness") && scene.base.roughness > 0.5 * smallest) {
    reader.problem("base.roughness", fmt::format(" = {}: must be at most {}, half the smallest diameter, or neighbours "
                                                 "would lie on each other [L]",
                                                 scene.base.roughness, 0.5 * smallest));
  }
  if (!reader.sound(key)) return;
  if (width / smallest > most_base_grains) {
    reader.problem(key, fmt::format(" = {}: the base could have {:.3g} grains; at most {:g}", 0.5 * width,
                                    width / smallest, most_base_grains));
  }
  // What is left over of the width, less than a disc, is shared out among all gaps: none may let a grain through.
  if (largest * largest > 0.5 * smallest * width) {
    reader.problem(key, fmt::format(" = {}: too narrow for a deposited base of these sizes, at least {:.4g} [L]",
                                    0.5 * width, largest * largest / smallest));
  }
}

}  // namespace

void check_boundaries(const Scene& scene, Reader& reader) {
  if (scene.base.kind == "deposited") check_deposited(scene, reader);
  const double d = scene.grains.diameter;
  constexpr double most_base_grains = 1e7;
  const double row = scene.box.x == "periodic" ? scene.box.half_width : scene.base.half_width;
  if (scene.base.kind == "row" && 2.0 * row / scene.base.spacing > most_base_grains && reader.sound("base.spacing") &&
      reader.sound("base.half_width")) {
    reader.problem("base.spacing",
                   fmt::format(" = {}: the row of half-width {} would have {:.3g} grains; at most {:g}",
                               scene.base.spacing, row, 2.0 * row / scene.base.spacing, most_base_grains));
  }
  if (scene.box.x == "periodic" && reader.sound("box.half_width")) {
    if (scene.box.half_width < 4.0 * scene.largest_diameter()) {
      const bool counted = scene.base.kind == "contiguous";
      reader.problem(counted ? "base.count" : "box.half_width",
                     fmt::format(" = {}: a periodic box must be at least 8 of the largest diameters wide",
                                 counted ? static_cast<double>(scene.base.count) : scene.box.half_width));
    }
    const double discs = 2.0 * scene.box.half_width / scene.base.spacing;
    if (scene.base.kind == "row" && reader.sound("base.spacing") &&
        std::fabs(discs - std::round(discs)) > 1e-9 * discs) {
      reader.problem("base.spacing",
                     fmt::format(" = {}: must divide the width {} of the periodic box into whole spacings",
                                 scene.base.spacing, 2.0 * scene.box.half_width));
    }
  } else if (scene.base.of_grains() && reader.sound("base.half_width") && reader.sound("box.half_width") &&
             scene.box.half_width < scene.base.half_width) {
    reader.problem("box.half_width", fmt::format(" = {}: must be at least base.half_width = {}", scene.box.half_width,
                                                 scene.base.half_width));
  }
  const double through = d + (scene.species.empty() ? d : scene.smallest_drawn());
  if (scene.base.kind == "row" && reader.sound("base.spacing") && reader.sound("grains.diameter") &&
      scene.base.spacing >= through) {
    reader.problem(
        "base.spacing",
        fmt::format(" = {}: must be < {}, {}, or grains fall through the base [L]", scene.base.spacing, through,
                    scene.species.empty() ? "two diameters" : "a diameter and that of the smallest grain"));
  }
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const auto prefix = fmt::format("plane[{}].", k);
    check_direction(prefix + "normal", scene.planes[k].normal, reader);
    const auto& normal = scene.planes[k].normal;
    if (scene.box.x == "periodic" && std::fabs(normal[0]) > 1e-12 * std::fabs(normal[1]) &&
        reader.sound(prefix + "normal")) {
      reader.problem(prefix + "normal", fmt::format(" = [{}, {}]: a plane must be level in a periodic box; a [[wall]] "
                                                    "need not be",
                                                    normal[0], normal[1]));
    }
    check_motion(prefix, scene.planes[k], scene, reader);
  }
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    const auto& piece = scene.pieces[k];
    const auto prefix = fmt::format("wall[{}].", k);
    const double length = reproducible::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
    if (length < 1e-6 * d && reader.sound(prefix + "from") && reader.sound(prefix + "to")) {
      reader.problem(prefix + "to", fmt::format(" = [{}, {}]: is where the wall begins", piece.to[0], piece.to[1]));
    }
    check_motion(prefix, piece, scene, reader);
  }
  check_names(scene, reader);
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    check_direction(fmt::format("load[{}].force", k), scene.loads[k].force, reader);
  }
}

}  // namespace repose
