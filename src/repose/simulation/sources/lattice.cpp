// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/lattice.hpp"

#include "repose/core/random.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// The multiple of the pitch, shifted, that is nearest to x: where the hollows of the base row are.
double snapped(double x, double shift, double pitch) { return std::round((x - shift) / pitch) * pitch + shift; }

/// A triangular lattice pile whose lowest grains lie in the hollows of the base row, belong to it, or lie side by side
/// on a plane. Each grain has the place of one of the largest size.
void add_pile(const LatticeSource& source, const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  const double d = scene.grains.diameter;
  const double pitch = source.pitch(scene);
  const double rise = std::sqrt(d * d - 0.25 * pitch * pitch);
  const double on_base = source.nests(scene) ? rise : scene.base->height_on_top(scene, d);
  const double lowest = source.fixed_base ? 0.0 : on_base;
  const double middle = source.middle(scene);
  const auto counts = source.row_counts();
  const GrainDraw<2> draw(scene, Purpose::grain_species, Purpose::grain_size);
  std::uint64_t index = 0;
  for (std::size_t row = source.fixed_base ? 1 : 0; row < counts.size(); ++row) {
    for (std::int64_t k = 0; k < counts[row]; ++k) {
      auto [grain, material] = draw(index++);
      grain.position[0] = middle + (static_cast<double>(k) - 0.5 * static_cast<double>(counts[row] - 1)) * pitch;
      grain.position[1] = lowest + static_cast<double>(row) * rise;
      grains.add(grain, id++, false, material);
    }
  }
}

/// A block of equal rows, every other one shifted by half a pitch. Its grains touch and lie in the hollows of the base
/// row if they can; else each has the room of the largest, and a gap.
void add_block(const LatticeSource& source, const Scene& scene, Grains<2>& grains, std::int64_t& id) {
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const double d = scene.largest_drawn();
  const double pitch = source.pitch(scene);
  const bool nests = source.nests(scene);
  const double apart = d + source.gap;
  const double rise = std::sqrt(apart * apart - 0.25 * pitch * pitch);
  const double lowest = nests ? rise : scene.base->height_on_top(scene, d) + source.gap;
  // The first row stands a quarter of a pitch to the left, the second as far to the right.
  double first = source.x - 0.5 * static_cast<double>(source.columns - 1) * pitch - 0.25 * pitch;
  if (nests) first = snapped(first, 0.5 * pitch, pitch);
  const GrainDraw<2> draw(scene, Purpose::grain_species, Purpose::grain_size);
  for (std::int64_t row = 0; row < source.rows; ++row) {
    for (std::int64_t k = 0; k < source.columns; ++k) {
      const auto index = static_cast<std::uint64_t>(row * source.columns + k);
      auto [grain, material] = draw(index);
      grain.position[0] = first + (static_cast<double>(k) + (row % 2 == 1 ? 0.5 : 0.0)) * pitch;
      grain.position[1] = lowest + static_cast<double>(row) * rise;
      const double shift = 0.5 * source.gap * source.jitter * uniform(seed, Purpose::lattice_place, index, 0);
      const double turn = 2.0 * std::numbers::pi * uniform(seed, Purpose::lattice_place, index, 1);
      if (shift > 0.0) grain.position += Vec<2>{{shift * reproducible::cos(turn), shift * reproducible::sin(turn)}};
      grains.add(grain, id++, false, material);
    }
  }
}

}  // namespace

void LatticeSource::add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const {
  is_pile() ? add_pile(*this, scene, grains, id) : add_block(*this, scene, grains, id);
}

}  // namespace repose
