// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// A grain as a file has it.
struct GrainRow {
  std::optional<std::int64_t> id;
  Vec<2> position{};           ///< [L]
  Vec<2> velocity{};           ///< [L/T]
  double spin = 0.0;           ///< [1/T]
  double radius = 0.0;         ///< [L]
  std::optional<double> mass;  ///< [M]
  std::uint16_t material = 0;
  bool fixed = false;
  bool base = false;
};

/// Reads a table of grains: comma-separated values under a line with the names of the columns: x, y, radius or
/// diameter, and if wanted vx, vy, spin, fixed (0 or 1); lines that begin with # are left out. Throws InputError, one
/// line "file:line: what" for each of the first problems.
std::vector<GrainRow> read_grains_file(const std::string& path);

}  // namespace repose
