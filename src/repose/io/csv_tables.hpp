// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/hdf5_reader.hpp"

#include <array>
#include <string>
#include <vector>

namespace repose {

/// Datasets of one group that make one table: as many rows each.
struct CsvTable {
  std::string name;  ///< "GROUP" or "GROUP_DATASET"
  std::string group;
  std::vector<std::string> datasets;
  /// A row for each place of a grid: `datasets` have the shape (places along the second axis, places along the first).
  bool grid = false;
  std::array<std::string, 2> axes{"x", "y"};  ///< datasets of a grid with the places along its axes
};

/// The tables that a file holds, whatever it is about. Datasets of a group that are equally long share a table; the one
/// with the most datasets has the name of the group, others add that of their first dataset to it. Where a group has
/// x (n), y (m), or r (n), z (m), and datasets of shape (m, n), these are its main table.
std::vector<CsvTable> csv_tables(const Hdf5Reader& file);

/// Writes a table: units, meanings and the attributes of the group in lines that begin with #, a line of names, then
/// the rows. Numbers have the fewest digits that read back as the same bits. Throws InputError, RunError.
void write_csv(const std::string& path, const Hdf5Reader& file, const CsvTable& table);

}  // namespace repose
