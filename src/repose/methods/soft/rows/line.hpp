// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"

#include <cstddef>

namespace repose::soft {

/// The part of a grain that the fused kernels read and move, in groups of four numbers: 64 bytes in 2D, 96 in 3D. The
/// sum or difference of two lines has all that a law needs of a pair. The mass of a pair follows from the sum of the
/// nominal 1/m, which a fixed grain has too, and the true reduced mass from that of the 1/m with which grains move.
template <int D>
struct Line;

template <>
struct alignas(64) Line<2> {
  double velocity[2];           // NOLINT: plain numbers, which kernels read in groups of four
  double rim_velocity;          ///< [L/T]
  double nominal_inverse_mass;  ///< [1/M]
  double position[2];           // NOLINT
  double radius;                ///< [L]
  double inverse_mass;          ///< [1/M] 0: fixed
};

template <>
struct alignas(32) Line<3> {
  double velocity[3];           // NOLINT
  double nominal_inverse_mass;  ///< [1/M]
  double rim_velocity[3];       // NOLINT
  double inverse_mass;          ///< [1/M] 0: fixed
  double position[3];           // NOLINT
  double radius;                ///< [L]
};
static_assert(sizeof(Line<2>) == 64);
static_assert(sizeof(Line<3>) == 96);

/// Moves the line to the state of its grain.
template <int D>
void follow(const Grain<D>& grain, Line<D>& line) {
  for (int k = 0; k < D; ++k) {
    line.velocity[k] = grain.velocity[k];
    line.position[k] = grain.position[k];
    if constexpr (D == 3) line.rim_velocity[k] = grain.rim_velocity[k];
  }
  if constexpr (D == 2) line.rim_velocity = grain.rim_velocity;
}

template <int D>
Line<D> line_of(const Grain<D>& grain) {
  Line<D> line;
  follow(grain, line);
  line.nominal_inverse_mass = 1.0 / grain.mass;
  line.radius = grain.radius;
  line.inverse_mass = grain.inverse_mass;
  return line;
}

/// Moves the grain to the state of its line.
template <int D>
void take(const Line<D>& line, Grain<D>& grain) {
  for (int k = 0; k < D; ++k) {
    grain.velocity[k] = line.velocity[k];
    grain.position[k] = line.position[k];
    if constexpr (D == 3) grain.rim_velocity[k] = line.rim_velocity[k];
  }
  if constexpr (D == 2) grain.rim_velocity = line.rim_velocity;
}

}  // namespace repose::soft
