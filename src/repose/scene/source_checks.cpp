// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

/// A lattice pile stands on what it can stand on, and within the box.
void check_pile(const Scene& scene, Reader& reader) {
  const auto& source = scene.source;
  if (scene.base.kind != "row" && scene.base.kind != "plane" && reader.sound("source.kind") &&
      reader.sound("base.kind")) {
    reader.problem("source.kind", " = \"lattice\": needs a base to stand on: base.kind = \"row\" or \"plane\"");
  }
  if (scene.grains.polydispersity > 0.0 && reader.sound("grains.polydispersity")) {
    reader.problem("grains.polydispersity", fmt::format(" = {}: must be 0 for a lattice", scene.grains.polydispersity));
  }
  if (!scene.species.empty() && reader.sound("species")) {
    reader.problem("species", ": a lattice pile is of equal grains; source.columns makes a block of any sizes");
  }
  const double half = 0.5 * static_cast<double>(source.rows + 1) * scene.base_pitch();
  const double room = scene.base.kind == "row" && scene.box.x == "open" ? scene.base.half_width : scene.box.half_width;
  if (std::fabs(source.x) + half > room && reader.sound("source.rows") && reader.sound("box.half_width")) {
    reader.problem("source.rows", fmt::format(" = {}: the pile must lie within x = +-{}", source.rows, room));
  }
}

void check_block(const Scene& scene, Reader& reader) {
  constexpr double most_grains = 1e7;
  const auto& source = scene.source;
  if (static_cast<double>(source.rows) * static_cast<double>(source.columns) > most_grains &&
      reader.sound("source.rows")) {
    reader.problem("source.rows",
                   fmt::format(" = {}: the block would have {:.3g} grains; at most {:g}", source.rows,
                               static_cast<double>(source.rows) * static_cast<double>(source.columns), most_grains));
  }
  const double width = static_cast<double>(source.columns) * scene.block_pitch();
  const double room = scene.box.half_width;
  if (!reader.sound("source.columns") || !reader.sound("box.half_width")) return;
  if (scene.box.x == "periodic") {
    if (width > 2.0 * room * (1.0 + 1e-9)) {
      reader.problem("source.columns", fmt::format(" = {}: the block is {:.6g} wide; the periodic box only {}",
                                                   source.columns, width, 2.0 * room));
    }
    return;
  }
  // Every other row stands out by half a pitch, and in hollows the block may be half a pitch off.
  const double half = 0.5 * width + (scene.block_nests() ? 0.75 : 0.25) * scene.block_pitch();
  if (std::fabs(source.x) + half > room) {
    reader.problem("source.columns",
                   fmt::format(" = {}: the block must lie within the box, x = +-{}; it reaches {:.6g}", source.columns,
                               room, std::fabs(source.x) + half));
  }
}

void check_lattice(const Scene& scene, Reader& reader) {
  constexpr std::int64_t most_rows = 4000;
  const auto& source = scene.source;
  if (source.rows > most_rows && reader.sound("source.rows")) {
    reader.problem("source.rows", fmt::format(" = {}: must be at most {}", source.rows, most_rows));
  }
  const bool nests = source.columns == 0 || scene.block_nests();
  const double d = scene.grains.diameter;
  const bool fits = scene.base.spacing >= d && scene.base.spacing <= 1.5 * d;
  if (scene.base.kind == "row" && nests && reader.sound("base.spacing") && !fits) {
    reader.problem("base.spacing", fmt::format(" = {}: must be 1 to 1.5 diameters, {} to {}, under a lattice [L]",
                                               scene.base.spacing, d, 1.5 * d));
  }
  source.columns == 0 ? check_pile(scene, reader) : check_block(scene, reader);
}

void check_drops(const Scene& scene, Reader& reader) {
  const auto& source = scene.source;
  if (scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("source.kind", fmt::format(" = \"{}\": needs gravity > 0", source.kind));
  }
  if (reader.sound("source.half_width") && reader.sound("box.half_width") &&
      std::fabs(source.x) + source.half_width > scene.box.half_width) {
    reader.problem("source.half_width", fmt::format(" = {}: the opening must lie within the box, x = +-{}",
                                                    source.half_width, scene.box.half_width));
  }
}

}  // namespace

void check_sources(const Scene& scene, Reader& reader) {
  if (scene.source.kind == "none" && scene.placed.empty() && scene.start.from.empty() && reader.sound("grain") &&
      reader.sound("source.kind") && reader.sound("start.from")) {
    reader.problem("source.kind", ": there are no grains: needs a source.kind, a start.from or at least one [[grain]]");
  }
  if (scene.source.kind == "lattice") check_lattice(scene, reader);
  if (scene.source.drops()) check_drops(scene, reader);
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
