// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/grains_file.hpp"
#include "repose/tables/cells.hpp"
#include "repose/tables/file_problems.hpp"
#include "repose/tables/text_lines.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// For the readers of grain files only: columns and lines of grains.

namespace repose {

/// The quantity that a column of a file holds. x, y and z are the axes of the file up to in_plane(), and from there on
/// those of the discs: to the right, up, and across the plane.
enum class GrainColumn {
  none,
  id,
  x,
  y,
  z,
  vx,
  vy,
  vz,
  spin_x,
  spin_y,
  spin_z,
  radius,
  diameter,
  mass,
  density,   ///< of a sphere
  material,  ///< counted from 0, or its name
  type,      ///< counted from 1, or its name
  label,     ///< counted from 1, or from 0 where one is 0, or its name
  fixed,
  base
};

/// The quantity of a column by its name in tables, without regard to case and to the signs between words.
struct NamedColumn {
  GrainColumn column = GrainColumn::none;
  bool own_name = false;  ///< a name of Repose, not one of other programs
};
NamedColumn column_of(std::string_view name);

/// The same quantity seen in a plane: with xz, z is the height.
GrainColumn in_plane(GrainColumn column, Plane plane);

/// The names of the axes of a plane: "x", "y", and "z" across it.
std::array<std::string, 3> axes_of(Plane plane);

/// Linear map from a column to a position; box-scaled positions run from 0 to 1 across the box.
struct Scaling {
  double origin = 0.0;
  double length = 1.0;
};

/// What a reader is asked for: discs in a plane of the file, or spheres in space.
struct ReaderOptions : GrainsFileOptions {
  bool in_space = false;

  /// The axes of the file that places need.
  std::size_t axes() const { return in_space ? 3 : 2; }
};

/// A file as its reader gives it, by the axes as in_plane() sees them. Of discs, velocities across the plane and spins
/// about its axes are left out.
using SeenFile = GrainsFile<3>;
using SeenRow = GrainRow<3>;
using SeenBox = FileBox<3>;

/// Reads grains from lines of cells.
class GrainLines {
 public:
  struct Column {
    GrainColumn column = GrainColumn::none;
    std::string name;
    double factor = 1.0;  ///< of its unit over the unit of the file
  };

  /// The columns are those of the file, not yet seen in the plane.
  GrainLines(FileProblems& problems, std::vector<Column> columns, const ReaderOptions& options,
             std::array<Scaling, 3> scaling = {});

  /// Reads one line, and adds its problems to the problems of the file.
  void read(std::size_t line, const std::vector<std::string_view>& cells);

  /// The grain of an id, for further sections of a file; none if there is none. Ids must be unique by then.
  SeenRow* find(std::int64_t id);

  /// Fills in the grains, by ascending id if they have ids, the names of their types, and the columns used and left
  /// out. Throws InputError if there was any problem.
  void take(SeenFile& into);

 private:
  bool set(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell);
  bool set_number(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell);
  bool set_type(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell);
  bool refuse(std::size_t column, std::size_t line, std::string_view cell, const std::string& allowed);
  void sort_by_id();
  void count_labels();

  FileProblems& problems_;
  std::vector<Column> columns_;
  bool downward_spin_ = false;  // the third axis points into the plane
  std::array<Scaling, 3> scaling_;
  std::vector<std::string> used_;
  std::vector<std::string> left_out_;
  std::vector<SeenRow> rows_;
  std::vector<std::string> types_;  // names of types
  std::optional<bool> named_types_;
  bool labels_ = false;
  double density_ = 0.0;  // of the present row
  bool sorted_ = false;
};

/// Reads a snapshot's worth of lines: `count` rows from the present place on.
void read_rows(TextLines& lines, std::int64_t count, FileProblems& problems, GrainLines& into);

// The readers of the kinds of file, each from its start. Throw InputError.
SeenFile read_grains_table(TextLines& lines, FileProblems& problems, const ReaderOptions& options);
SeenFile read_yade_text(TextLines& lines, FileProblems& problems, const ReaderOptions& options);
SeenFile read_lammps_dump(TextLines& lines, FileProblems& problems, const ReaderOptions& options);
SeenFile read_lammps_data(TextLines& lines, FileProblems& problems, const ReaderOptions& options);
SeenFile read_extended_xyz(TextLines& lines, FileProblems& problems, const ReaderOptions& options);
SeenFile read_mercury_data(TextLines& lines, FileProblems& problems, const ReaderOptions& options);

/// The units that LAMMPS calls "si", "cgs", "micro", "nano" or "lj".
FileUnits lammps_units(std::string_view name);

}  // namespace repose
