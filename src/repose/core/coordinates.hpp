// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace repose {

/// A vector as a scene has it: of its three numbers the first two count in two dimensions, and the third is 0.
using Coordinates = std::array<double, 3>;

/// Coordinates that have no value yet.
inline constexpr Coordinates no_coordinates{std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN(), 0.0};

template <int D>
Vec<D> vec(const Coordinates& numbers) {
  Vec<D> vector;
  for (int k = 0; k < D; ++k) vector[k] = numbers[static_cast<std::size_t>(k)];
  return vector;
}

template <int D>
Coordinates coordinates(const Vec<D>& vector) {
  Coordinates numbers{};
  for (int k = 0; k < D; ++k) numbers[static_cast<std::size_t>(k)] = vector[k];
  return numbers;
}

/// "[0, 1]", as in a scene.
std::string coordinates_text(const Coordinates& numbers, std::int64_t dimension);

}  // namespace repose
