// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace repose {

/// Two upright walls that face each other, and the level floor between them.
struct Pipe {
  std::int64_t left_wall = 0;   ///< number of the wall on the left
  std::int64_t right_wall = 0;  ///< number of the wall on the right
  double left = 0.0;            ///< [L] x of its face
  double right = 0.0;           ///< [L]
  double floor = 0.0;           ///< [L] y of the floor

  double width() const { return right - left; }
  double cross_section() const { return width(); }  ///< [L]
  double perimeter() const { return 2.0; }          ///< length of the walls per height
};

/// An upright cylinder with spheres inside, and the level floor in it.
struct CylinderPipe {
  std::int64_t wall = 0;  ///< number of its wall
  Vec<2> axis{};          ///< [L] x, y
  double radius = 0.0;    ///< [L]
  double floor = 0.0;     ///< [L] z of the floor

  double cross_section() const { return std::numbers::pi * radius * radius; }  ///< [L^2]
  double perimeter() const { return 2.0 * std::numbers::pi * radius; }         ///< [L] area of the wall per height
};

/// The column of grains in a pipe at one time. Grains that touch something count, and those between them that touch
/// nothing at that moment; grains that still fall towards it do not.
struct ColumnRow {
  double height = 0.0;          ///< [L] mean height of the surface above the floor
  double centre = 0.0;          ///< [L] of the centre of mass above the floor
  double solid_fraction = 0.0;  ///< of the slices but the lowest and the highest tenth of them; NaN where empty
};

/// A part of a column between two levels: all slices hold the same area of discs, or volume of spheres, so that a slice
/// keeps its grains while the column moves as a whole. Forces on walls are per length of wall in 2D, per area in 3D.
struct ColumnSlice {
  double top = 0.0;       ///< [L] its upper level above the floor
  double mass = 0.0;      ///< [M] of the grains with their centres in it
  double pressure = 0.0;  ///< [M/T^2], in 3D [M/(L T^2)] normal force of these grains on the walls
  double shear = 0.0;     ///< [M/T^2], in 3D [M/(L T^2)] force of the walls on these grains, upwards
  double load = 0.0;      ///< [M L/T^2] force through the lower level: upwards on the grains with centres above it
};

struct MeasuredColumn {
  ColumnRow row;
  std::vector<ColumnSlice> slices;  ///< from the floor up
};

/// Measures the column by the contacts at one time. The load of the lowest slice is the force of everything but the two
/// walls and the grains of the column: the floor, fixed grains, grains below the floor. At rest the load of a slice is
/// that of the next one, plus the weight of its grains, less the upward force of the walls on them. Validated by
/// tests/unit/pipe_test.cpp and, in 3D, tests/unit/cylinder_pipe_test.cpp.
MeasuredColumn measure_column(const Pipe& pipe, const Grains<2>& grains, const Contacts<2>& contacts,
                              std::size_t slices);
MeasuredColumn measure_column(const CylinderPipe& pipe, const Grains<3>& grains, const Contacts<3>& contacts,
                              std::size_t slices);

}  // namespace repose
