// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/deposited_bed.hpp"

#include <fmt/format.h>

namespace repose {

void DepositedBed::check(const Scene& scene, Problems& problems) const {
  if (scene.box.periodic() || scene.box.periodic_y()) {
    problems.problem("base.kind", " = \"deposited\": is round; a periodic box needs another base");
  }
  for (const auto* key : {"base.radius", "grains.diameter", "grains.polydispersity", "species"}) {
    if (!problems.sound(key)) return;
  }
  const double smallest = scene.smallest_drawn();
  const double largest = scene.largest_drawn();
  // The gaps between four spheres in a square let smaller ones through than this, 0.41 of their diameter.
  constexpr double least_size_ratio = 0.5;
  if (smallest < least_size_ratio * largest) {
    problems.problem("base.kind",
                     fmt::format(" = \"deposited\": grains may fall through; the smallest diameter, {:.4g}, "
                                 "must be at least half the largest, {:.4g} [L]",
                                 smallest, largest));
  }
  if (radius < 2.0 * largest) {
    problems.problem("base.radius", fmt::format(" = {}: must be at least two of the largest diameters, {:.4g} [L]",
                                                radius, 2.0 * largest));
  }
  constexpr double per_square = 4.5;  // spheres dropped on the square of a diameter
  const double side = 2.0 * radius / largest;
  if (per_square * side * side > most_base_grains) {
    problems.problem("base.radius", fmt::format(" = {}: {:.3g} spheres would be dropped; at most {:g}", radius,
                                                per_square * side * side, most_base_grains));
  }
}

double DepositedBed::depth(const Scene& scene) const {
  constexpr double thickness = 4.0;  // of the deposit, in largest diameters
  return thickness * scene.largest_drawn();
}

double DepositedBed::height_on_top(const Scene& scene, double diameter) const {
  return 0.5 * (scene.largest_drawn() + diameter);
}

std::string DepositedBed::describe() const { return fmt::format("deposited spheres, radius {:g}", radius); }

}  // namespace repose
