// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen.hpp"

#include "repose/theory/column_walls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace repose::theory {

namespace {

/// The depth in screening lengths: negative if pushed up, exactly 0 without friction.
double screened(const Janssen& column, double depth) {
  const double walls = column.dimension == 2 ? 2.0 : 4.0;  // perimeter times width over area
  return wall_sense(column.direction) * (walls * column.stress_ratio * column.friction * (depth / column.width));
}

}  // namespace

double screening_length(const Janssen& column) {
  const double walls = column.dimension == 2 ? 2.0 : 4.0;
  return column.width / (walls * column.stress_ratio * column.friction);
}

double weight_per_volume(const Janssen& column) { return column.density * column.solid_fraction * column.gravity; }

double area(const Janssen& column) {
  return column.dimension == 2 ? column.width : 0.25 * std::numbers::pi * column.width * column.width;
}

double vertical_stress(const Janssen& column, double depth) {
  const double x = screened(column, depth);
  return weight_per_volume(column) * depth * fraction_at_bottom(x) + column.overload * std::exp(-x);  // (24)
}

void parameters(Janssen& column, Parameters& to) {
  to.integer("dimension", column.dimension, {.low = 2, .high = 3},
             "2: slit, all quantities per unit length along it; 3: round pipe");
  to.number("width", column.width, positive, "L", "distance between the walls in 2D, diameter in 3D");
  to.number("stress_ratio", column.stress_ratio, not_negative, "1", "horizontal over vertical stress, K");
  to.number("friction", column.friction, not_negative, "1", "friction of grains against the wall, mu");
  to.number("solid_fraction", column.solid_fraction, {.low = 0.0, .high = 1.0, .low_allowed = false}, "1",
            "volume of grains over total volume, c");
  to.number("density", column.density, positive, "M/L^3", "density of the material of a grain, rho");
  to.number("gravity", column.gravity, positive, "L/T^2", "g");
  to.number("height", column.height, positive, "L", "height of the column");
  to.choice("direction", column.direction, column_directions(),
            "rest: the walls carry weight; pushed-up: the same friction holds the grains down");
  to.number("overload", column.overload, not_negative, "M/(L T^2)", "vertical stress on the top");
  to.integer("points", column.points, {.low = 2, .high = 1'000'000}, "number of depths, top and bottom included");
}

std::vector<std::string> relations(const Janssen& column) {
  const double x = -screened(column, column.height);
  if (x <= highest_push) return {};
  return {fmt::format(
      "height = {}: is {:.6g} screening lengths ({:.6g}); must be <= {} of them with direction = pushed-up, "
      "where stress grows as exp(height/lambda)",
      column.height, x, screening_length(column), highest_push)};
}

Table evaluate(const Janssen& column) {
  const double mass_per_height = column.density * column.solid_fraction * area(column);
  const bool saturates = column.direction == "rest" && column.stress_ratio * column.friction > 0.0;
  const double lambda = screening_length(column);
  const double saturation = saturates ? lambda : std::numeric_limits<double>::infinity();
  const std::string mass = column.dimension == 2 ? "M/L" : "M";
  Column depths{.name = "depth", .unit = "L", .about = "depth below the top", .values = {}, .words = {}};
  Column stresses{.name = "stress",
                  .unit = "M/(L T^2)",
                  .about = "vertical stress, compression positive",
                  .values = {},
                  .words = {}};
  Column masses{.name = "apparent_mass",
                .unit = mass,
                .about = "stress times area over g: the mass that a balance shows",
                .values = {},
                .words = {}};
  for (std::int64_t i = 0; i < column.points; ++i) {
    const double depth = column.height * (static_cast<double>(i) / static_cast<double>(column.points - 1));
    const double stress = vertical_stress(column, depth);
    depths.values.push_back(depth);
    stresses.values.push_back(stress);
    masses.values.push_back(stress / column.gravity * area(column));
  }
  return {{depths, stresses, masses},
          {{"lambda", lambda, "L", "screening length; infinite without friction"},
           {"saturation_stress", weight_per_volume(column) * saturation, "M/(L T^2)",
            "stress far below the top; infinite if pushed up or without friction"},
           {"saturation_mass", mass_per_height * saturation, mass,
            "apparent mass far below the top; infinite if pushed up or without friction"},
           {"mass_per_height", mass_per_height, column.dimension == 2 ? "M/L^2" : "M/L",
            "mass of the grains per height, rho c area"}}};
}

}  // namespace repose::theory
