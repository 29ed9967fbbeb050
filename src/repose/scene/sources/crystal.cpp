// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/crystal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

void CrystalSource::keys(const Scene&, Parameters& keys) {
  keys.choice("source.structure", structure, {"fcc", "hcp", "sc"},
              "face-centred cubic on square layers, hexagonal close-packed, or simple cubic");
  keys.choice("source.shape", shape, {"block", "pyramid"}, "of the crystal; a pyramid is of structure fcc");
  keys.integer("source.columns", columns, std::nullopt, {.low = 1, .high = 4000},
               "spheres along x in the lowest layer");
  keys.integer("source.rows", rows, std::nullopt, {.low = 1, .high = 4000}, "spheres along y in the lowest layer");
  keys.integer("source.layers", layers, std::nullopt, {.low = 1, .high = 4000}, "layers one above the other");
  keys.number("source.gap", gap, not_negative, "L", "gap between spheres of the largest size");
  keys.number("source.jitter", jitter, zero_to_one, "",
              "each sphere is displaced by up to this times half the gap, so that none touch");
  keys.number("source.x", x, any, "L", "middle of the crystal");
  keys.number("source.y", y, any, "L", "middle of the crystal");
}

double CrystalSource::rise(const Scene& scene) const {
  if (structure == "sc") return pitch(scene);
  return pitch(scene) * std::sqrt(structure == "fcc" ? 0.5 : 2.0 / 3.0);
}

std::int64_t CrystalSource::placed() const {
  std::int64_t all = 0;
  for (std::int64_t layer = 0; layer < layers; ++layer) all += columns_of(layer) * rows_of(layer);
  return all;
}

double CrystalSource::fall(const Scene& scene) const {
  return scene.largest_drawn() + rise(scene) * static_cast<double>(layers);
}

std::string CrystalSource::describe() const {
  return fmt::format("{} in {} of {} layers of structure {}, the lowest {} by {}", placed(),
                     is_pyramid() ? "a pyramid" : "a block", layers, structure, columns, rows);
}

void CrystalSource::check(const Scene& scene, Problems& problems) const {
  for (const auto* key : {"source.columns", "source.rows", "source.layers"}) {
    if (!problems.sound(key)) return;
  }
  if (is_pyramid() && structure != "fcc") {
    problems.problem("source.structure", fmt::format(" = \"{}\": a pyramid is of structure \"fcc\"", structure));
  }
  if (is_pyramid() && layers > std::min(columns, rows)) {
    problems.problem("source.layers", fmt::format(" = {}: a pyramid {} by {} has at most {}", layers, columns, rows,
                                                  std::min(columns, rows)));
    return;
  }
  constexpr std::int64_t most = 10'000'000;
  if (placed() > most) {
    problems.problem("source.layers",
                     fmt::format(" = {}: the crystal would have {} spheres; at most {}", layers, placed(), most));
  }
  if (!problems.sound("box.half_width") || !problems.sound("box.half_depth")) return;
  const double a = pitch(scene);
  const auto fits = [&](const std::string& key, double middle, double width, double shift, double half, bool periodic) {
    const bool room = periodic ? width <= 2.0 * half * (1.0 + 1e-9) : std::fabs(middle) + 0.5 * (width + shift) <= half;
    if (room) return;
    problems.problem(key, fmt::format(": the crystal is {:.6g} wide there; the box +-{}", width + shift, half));
  };
  const double shift = is_pyramid() || structure == "sc" ? 0.0 : 0.5 * a;
  const double row = structure == "hcp" ? 0.5 * std::sqrt(3.0) * a : a;
  fits("source.columns", x, static_cast<double>(columns) * a, shift, scene.box.half_width, scene.box.periodic());
  fits("source.rows", y, static_cast<double>(rows) * row, shift, scene.box.half_depth, scene.box.periodic_y());
}

}  // namespace repose
