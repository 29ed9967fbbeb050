// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace repose {

/// A named VTK array with a number of components per point or cell.
struct VtkArray {
  std::string name;
  std::size_t components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint8_t>> values;
};

/// Points, and cells of one kind: a vertex for each point, or lines between two points, or triangles.
struct VtkPolyData {
  std::vector<double> points;           ///< (n, 3)
  std::vector<std::int64_t> lines;      ///< (cells, 2) indices of points
  std::vector<std::int64_t> triangles;  ///< (cells, 3) indices of points
  bool vertices = true;
  std::vector<VtkArray> point_data;
  std::vector<VtkArray> cell_data;
};

/// Writes a .vtp file: XML with appended raw data, little-endian. Repose has its own writer because the VTK library is
/// a hundred times as large as Repose. Throws RunError.
void write_vtp(const std::string& path, const VtkPolyData& data);

/// Square cells in rows from below, with values for each.
struct VtkGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double x = 0.0;  ///< [L] of the corner
  double y = 0.0;
  double cell = 0.0;  ///< [L]
  std::vector<VtkArray> cell_data;
};

/// Writes a .vti file (image data), like .vtp. Throws RunError.
void write_vti(const std::string& path, const VtkGrid& grid);

/// Writes a .pvd file, which lists the files of a time series with their times. Throws RunError.
void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& files);

}  // namespace repose
