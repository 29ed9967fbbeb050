// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

/// A lattice pile stands on what it can stand on, and within the box.
void check_lattice(const Scene& scene, Reader& reader) {
  constexpr std::int64_t most_rows = 4000;
  const auto& source = scene.source;
  if (source.rows > most_rows && reader.sound("source.rows")) {
    reader.problem("source.rows", fmt::format(" = {}: must be at most {}", source.rows, most_rows));
  }
  if (scene.base.kind == "none" && reader.sound("source.kind") && reader.sound("base.kind")) {
    reader.problem("source.kind", " = \"lattice\": needs a base to stand on: base.kind = \"row\" or \"plane\"");
  }
  const double d = scene.grains.diameter;
  const bool fits = scene.base.spacing >= d && scene.base.spacing <= 1.5 * d;
  if (scene.base.kind == "row" && reader.sound("base.spacing") && !fits) {
    reader.problem("base.spacing", fmt::format(" = {}: must be 1 to 1.5 diameters, {} to {}, under a lattice [L]",
                                               scene.base.spacing, d, 1.5 * d));
  }
  if (scene.grains.polydispersity > 0.0 && reader.sound("grains.polydispersity")) {
    reader.problem("grains.polydispersity", fmt::format(" = {}: must be 0 for a lattice", scene.grains.polydispersity));
  }
  const double half = 0.5 * static_cast<double>(source.rows + 1) * scene.base_pitch();
  const double room = scene.base.kind == "row" && scene.box.x == "open" ? scene.base.half_width : scene.box.half_width;
  if (std::fabs(source.x) + half > room && reader.sound("source.rows") && reader.sound("box.half_width")) {
    reader.problem("source.rows", fmt::format(" = {}: the pile must lie within x = +-{}", source.rows, room));
  }
}

}  // namespace

void check_sources(const Scene& scene, Reader& reader) {
  if (scene.source.kind == "none" && scene.placed.empty() && reader.sound("grain") && reader.sound("source.kind")) {
    reader.problem("source.kind", ": there are no grains: needs a source.kind or at least one [[grain]]");
  }
  if (scene.source.kind == "pour" && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("source.kind", " = \"pour\": needs gravity > 0");
  }
  if (scene.source.kind == "lattice") check_lattice(scene, reader);
  if (scene.source.kind == "pour" && reader.sound("source.half_width") && reader.sound("box.half_width") &&
      std::fabs(scene.source.x) + scene.source.half_width > scene.box.half_width) {
    reader.problem("source.half_width", fmt::format(" = {}: the opening must lie within the box, x = +-{}",
                                                    scene.source.half_width, scene.box.half_width));
  }
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto key = fmt::format("grain[{}].position", k);
    if (std::fabs(scene.placed[k].position[0]) > scene.box.half_width && reader.sound(key) &&
        reader.sound("box.half_width")) {
      reader.problem(key, fmt::format(" = [{}, {}]: must lie within the box, x = +-{}", scene.placed[k].position[0],
                                      scene.placed[k].position[1], scene.box.half_width));
    }
  }
}

}  // namespace repose
