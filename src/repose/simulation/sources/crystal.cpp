// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/crystal.hpp"

#include "repose/core/random.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// A displacement in a random direction.
Vec<3> shift_of(std::uint64_t seed, std::uint64_t index, double length) {
  const auto random = [&](std::uint32_t draw) { return uniform(seed, Purpose::lattice_place, index, draw); };
  const double height = 2.0 * random(1) - 1.0;
  const double turn = 2.0 * std::numbers::pi * random(2);
  const double across = std::sqrt(std::max(0.0, 1.0 - height * height));
  return Vec<3>{{across * reproducible::cos(turn), across * reproducible::sin(turn), height}} * (length * random(0));
}

}  // namespace

void CrystalSource::add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const {
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const double a = pitch(scene);
  const double row_distance = structure == "hcp" ? 0.5 * std::sqrt(3.0) * a : a;
  const double lowest = scene.base->height_on_top(scene, scene.largest_drawn()) + gap;
  const GrainDraw<3> draw(scene, Purpose::grain_species, Purpose::grain_size);
  std::uint64_t index = 0;
  for (std::int64_t layer = 0; layer < layers; ++layer) {
    const bool odd = layer % 2 == 1;
    // Every other layer of a block lies half a pitch to the right, and behind; those of a pyramid are centred.
    const double shift = structure == "sc" || is_pyramid() ? 0.0 : (odd ? 0.25 : -0.25) * a;
    const double behind = structure == "hcp" ? (odd ? 0.5 : -0.5) * a / std::sqrt(3.0) : shift;
    for (std::int64_t row = 0; row < rows_of(layer); ++row) {
      // Rows of a triangular layer are shifted against each other.
      const double of_row = structure == "hcp" ? (row % 2 == 1 ? 0.25 : -0.25) * a : 0.0;
      const double along_y = static_cast<double>(row) - 0.5 * static_cast<double>(rows_of(layer) - 1);
      for (std::int64_t column = 0; column < columns_of(layer); ++column) {
        const double along_x = static_cast<double>(column) - 0.5 * static_cast<double>(columns_of(layer) - 1);
        auto [grain, number] = draw(index);
        grain.position = {{x + along_x * a + (structure == "hcp" ? of_row : shift), y + along_y * row_distance + behind,
                           lowest + static_cast<double>(layer) * rise(scene)}};
        if (gap * jitter > 0.0) grain.position += shift_of(seed, index, 0.5 * gap * jitter);
        grains.add(grain, id++, false, number);
        ++index;
      }
    }
  }
}

}  // namespace repose
