// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/grains_file.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// For the readers of grain files only: lines, columns and cells, and their problems.

namespace repose {

/// The problems of one file: one line for each of the first 20, then the number of the rest.
class FileProblems {
 public:
  explicit FileProblems(std::string path) : path_(std::move(path)) {}

  void add(std::size_t line, const std::string& what);
  [[noreturn]] void stop() const;
  [[noreturn]] void stop(std::size_t line, const std::string& what) {
    add(line, what);
    stop();
  }
  /// Throws InputError if there are any.
  void check() const {
    if (count_ > 0) stop();
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

/// The quantity that a column of a file holds.
enum class GrainColumn { none, id, x, y, z, vx, vy, spin, radius, diameter, mass, material, type, fixed, base };

/// A whole cell as a number; none if it is anything else, not finite or out of range.
std::optional<double> number_of(std::string_view cell);
std::optional<std::int64_t> integer_of(std::string_view cell);

/// Linear map from a column to a position; box-scaled positions run from 0 to 1 across the box.
struct Scaling {
  double origin = 0.0;
  double length = 1.0;
};

/// Reads grains from lines of cells.
class GrainLines {
 public:
  GrainLines(FileProblems& problems, std::vector<GrainColumn> columns, std::vector<std::string> names,
             std::array<Scaling, 2> scaling = {});

  /// Reads one line, and adds its problems to the problems of the file.
  void read(std::size_t line, const std::vector<std::string_view>& cells);

  /// The grains; by ascending id, if they have ids. Throws InputError if there was any problem.
  std::vector<GrainRow> take();

 private:
  bool set(GrainRow& row, std::size_t column, std::size_t line, std::string_view cell);
  void check_ids();

  FileProblems& problems_;
  std::vector<GrainColumn> columns_;
  std::vector<std::string> names_;
  std::array<Scaling, 2> scaling_;
  std::optional<double> z_;  // z of the first grain
  std::vector<GrainRow> rows_;
  std::vector<std::size_t> lines_;  // line numbers of the rows, if they have ids
};

/// Read the two kinds of file from the start. Throw InputError.
std::vector<GrainRow> read_grains_table(std::istream& file, FileProblems& problems);
std::vector<GrainRow> read_lammps_dump(std::istream& file, FileProblems& problems, std::int64_t step);

}  // namespace repose
