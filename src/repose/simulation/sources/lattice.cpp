// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// Height [L] of centres of this diameter that lie on a plane at height 0.
double height_on_plane(const Scene& scene, double diameter) {
  return scene.base.kind == "plane" && scene.base.smooth ? diameter : 0.5 * diameter;
}

/// The multiple of the pitch, shifted, that is nearest to x: where the hollows of the base row are.
double snapped(double x, double shift, double pitch) { return std::round((x - shift) / pitch) * pitch + shift; }

/// A triangular lattice pile whose lowest grains lie in the hollows of the base row, or side by side on a plane.
void add_pile(const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  const double d = scene.grains.diameter;
  const double pitch = scene.base_pitch();
  const double rise = std::sqrt(d * d - 0.25 * pitch * pitch);
  const bool on_row = scene.base.kind == "row";
  const double lowest = on_row ? rise : height_on_plane(scene, d);
  // The grains of a row of even length lie at odd multiples of half a pitch about its middle, and so do hollows.
  const double shift = scene.source.rows % 2 == 1 ? 0.5 * pitch : 0.0;
  const double middle = on_row ? snapped(scene.source.x, shift, pitch) : scene.source.x;
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

/// A block of equal rows, every other one shifted by half a pitch. Its grains touch and lie in the hollows of the base
/// row if they can; else each has the room of the largest, and a gap.
void add_block(const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  const auto& source = scene.source;
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const double d = scene.largest_drawn();
  const double pitch = scene.block_pitch();
  const bool nests = scene.block_nests();
  const double apart = d + source.gap;
  const double rise = std::sqrt(apart * apart - 0.25 * pitch * pitch);
  double lowest = height_on_plane(scene, d) + source.gap;
  if (scene.base.kind == "row") lowest = nests ? rise : 0.5 * (scene.grains.diameter + d) + source.gap;
  if (scene.base.kind == "deposited") lowest = d + source.gap;
  // The first row stands a quarter of a pitch to the left, the second as far to the right.
  double first = source.x - 0.5 * static_cast<double>(source.columns - 1) * pitch - 0.25 * pitch;
  if (nests) first = snapped(first, 0.5 * pitch, pitch);
  const GrainDraw draw(scene, Purpose::grain_species, Purpose::grain_size);
  for (std::int64_t row = 0; row < source.rows; ++row) {
    for (std::int64_t k = 0; k < source.columns; ++k) {
      const auto index = static_cast<std::uint64_t>(row * source.columns + k);
      auto [grain, material] = draw(index);
      grain.position[0] = first + (static_cast<double>(k) + (row % 2 == 1 ? 0.5 : 0.0)) * pitch;
      grain.position[1] = lowest + static_cast<double>(row) * rise;
      const double shift = 0.5 * source.gap * source.jitter * uniform(seed, Purpose::lattice_place, index, 0);
      const double turn = 2.0 * std::numbers::pi * uniform(seed, Purpose::lattice_place, index, 1);
      if (shift > 0.0) grain.position += Vec<2>{{shift * std::cos(turn), shift * std::sin(turn)}};
      grains.add(grain, id++, false, material);
    }
  }
}

}  // namespace

void add_lattice(const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  if (scene.source.kind != "lattice") return;
  scene.source.columns > 0 ? add_block(scene, grains, id) : add_pile(scene, grains, id);
}

}  // namespace repose
