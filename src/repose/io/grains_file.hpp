// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// A grain as given in a file, in the units of the file: a disc in a plane, or a sphere.
template <int D>
struct GrainRow {
  std::optional<std::int64_t> id;
  Vec<D> position{};           ///< [L]
  Vec<D> velocity{};           ///< [L/T]
  Spin<D> spin{};              ///< [1/T]
  double radius = 0.0;         ///< [L]
  std::optional<double> mass;  ///< [M]
  std::uint16_t material = 0;
  bool fixed = false;
  bool base = false;
  std::int64_t type = 0;  ///< as the file writes it
  double third = 0.0;     ///< [L] of a disc: its position across the plane
  std::size_t line = 0;   ///< of the file; 0 in a run
};

/// The units of a file, in SI; 0 where they are not known.
struct FileUnits {
  std::string name;      ///< as the file gives them: "mm", "si"; "": it gives none
  bool reduced = false;  ///< the file says that it has no units
  double length = 0.0;   ///< [m]
  double mass = 0.0;     ///< [kg]
  double time = 0.0;     ///< [s]
};

/// The box of a file, along the two axes of the plane or all three.
template <int D>
struct FileBox {
  Vec<D> low{};                      ///< [L]
  Vec<D> high{};                     ///< [L]
  std::array<std::string, D> sides;  ///< "periodic", "open"; "": the file does not tell
  bool tilted = false;
};

/// What a file of grains holds, but for the grains and their box.
struct FileFacts {
  std::string format;
  std::vector<std::string> used;      ///< columns
  std::vector<std::string> left_out;  ///< columns
  FileUnits units;
  std::vector<std::string> types;        ///< names, by GrainRow::material, where types or materials are words
  std::optional<std::int64_t> snapshot;  ///< its step
  std::size_t snapshots = 1;             ///< in the file
  std::vector<std::string> warnings;
};

template <int D>
struct GrainsFile : FileFacts {
  std::vector<GrainRow<D>> grains;
  std::optional<FileBox<D>> box;
};

/// The plane of a file in three dimensions in which the grains are discs: its first axis points to the right, its
/// second one up.
enum class Plane { xy, xz, yz };

/// In place of the number of a step: the last snapshot.
inline constexpr std::int64_t last_snapshot = -1;

struct GrainsFileOptions {
  std::int64_t step = last_snapshot;
  Plane plane = Plane::xy;  ///< of discs
};

/// Reads the grains of a table, a LAMMPS or LIGGGHTS text dump, a LAMMPS data file (atom_style sphere), an extended XYZ
/// file, a text export of YADE, or a .data file of MercuryDPM; packed by gzip or not. The content decides which kind of
/// file it is; docs/reference/scene.md lists the columns. Grains with ids are returned by ascending id, others in the
/// order of the file. Discs lie in a plane of a file in three dimensions; spheres need all three axes, z upwards.
/// Throws InputError: one line "file:line: problem" for each of the first 20 problems, then the number of the rest.
/// Validated by tests/unit/grains_file_test.cpp, tests/unit/other_programs_test.cpp and tests/unit/files_3d_test.cpp.
template <int D>
GrainsFile<D> read_grains_file(const std::string& path, const GrainsFileOptions& options = {});

}  // namespace repose
