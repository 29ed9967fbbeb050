// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Random123/philox.h>

#include <cstdint>

namespace repose {

/// The purpose of a random number; each purpose has its own stream.
enum class Purpose : std::uint32_t {
  release_position = 1,
  grain_size = 2,
  grain_species = 3,
  base_size = 4,
  base_species = 5,
  base_height = 6,
  lattice_place = 7,
  parking = 8,
  force_fraction = 9,
  resample = 10
};

/// A random number uniform in [0, 1) with 53 bits: a pure function of (seed, purpose, index, draw), by Philox4x32-10
/// (Salmon et al. 2011).
inline double uniform(std::uint64_t seed, Purpose purpose, std::uint64_t index, std::uint32_t draw = 0) {
  using Philox = r123::Philox4x32;
  const Philox::ctr_type counter{{static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32), draw,
                                  static_cast<std::uint32_t>(purpose)}};
  const Philox::key_type key{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const auto bits = Philox{}(counter, key);
  const std::uint64_t word = (static_cast<std::uint64_t>(bits[0]) << 32) | bits[1];
  return static_cast<double>(word >> 11) * 0x1.0p-53;
}

}  // namespace repose
