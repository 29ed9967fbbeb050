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

/// The last snapshot of a dump, instead of the number of a step.
inline constexpr std::int64_t last_snapshot = -1;

/// Reads a table of grains (comma, semicolon or tab between the values, under a line of names) or a snapshot of
/// a LAMMPS text dump: that of a step, or the last; which kind of file, the content says. Columns:
/// docs/reference/scene.md. Grains that have ids come by ascending id, others as they are in the file. Throws
/// InputError, one line "file:line: what" for each of the first 20 problems, then the number of the others.
std::vector<GrainRow> read_grains_file(const std::string& path, std::int64_t step = last_snapshot);

}  // namespace repose
