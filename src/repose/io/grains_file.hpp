// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// A grain as given in a file.
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

/// In place of the number of a step: the last snapshot of a dump.
inline constexpr std::int64_t last_snapshot = -1;

/// Reads a table of grains (a line of names, then values separated by comma, semicolon or tab) or a snapshot of a
/// LAMMPS text dump: that of a step, or the last. The content decides which kind of file it is. docs/reference/scene.md
/// lists the columns. Grains with ids are returned by ascending id, others in the order of the file. Throws InputError:
/// one line "file:line: problem" for each of the first 20 problems, then the number of the rest.
std::vector<GrainRow> read_grains_file(const std::string& path, std::int64_t step = last_snapshot);

}  // namespace repose
