// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen_discrete.hpp"

#include "repose/theory/column_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose::theory {

namespace {

constexpr double grains_in_cell = 3.0;

/// 2 K mu; negative if pushed up.
double wall_ratio(const JanssenDiscrete& stack) { return wall_sense(stack.direction) * 2.0 * stack.k_mu; }

/// The part of the force on a wall that comes from the force below the cell; the rest comes from that above.
double part_from_below(const JanssenDiscrete& stack) {
  if (stack.wall_load == "below") return 1.0;
  return stack.wall_load == "mean" ? 0.5 : 0.0;
}

/// -ln A in F_i = A F_(i-1) + B, from the balance F_i = F_(i-1) + 3 - q [part F_i + (1 - part) F_(i-1)].
double decay(const JanssenDiscrete& stack) {
  const double q = wall_ratio(stack);
  const double part = part_from_below(stack);
  return std::log1p(part * q) - std::log1p(-(1.0 - part) * q);
}

}  // namespace

double force_below(const JanssenDiscrete& stack, std::int64_t layers) {
  const double q = wall_ratio(stack);
  const auto cells = static_cast<double>(layers);
  if (q == 0.0) return grains_in_cell * cells;
  return grains_in_cell * (-std::expm1(-cells * decay(stack)) / q);  // (34): B/(1 - A) = 3/q for any part
}

DiscreteLengths discrete_lengths(const JanssenDiscrete& stack) {
  const double q = wall_ratio(stack);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (q == 0.0) return {.lambda_1 = infinite, .lambda_2 = infinite, .ratio = 1.0};
  return {.lambda_1 = 1.0 / std::abs(q), .lambda_2 = 1.0 / std::abs(decay(stack)), .ratio = decay(stack) / q};
}

void parameters(JanssenDiscrete& stack, Parameters& to) {
  to.number("k_mu", stack.k_mu, not_negative, "1", "stress ratio times wall friction; 2 k_mu < 1 if pushed up");
  to.integer("layers", stack.layers, {.low = 1, .high = 1'000'000}, "number of cells");
  to.choice("direction", stack.direction, column_directions(),
            "rest: the walls carry weight; pushed-up: the same friction holds the grains down");
  to.choice("wall_load", stack.wall_load, {"below", "mean", "above"},
            "force that sets the force on the walls: that below the cell as in (31), that above it, or their mean");
}

std::vector<std::string> relations(const JanssenDiscrete& stack) {
  const double q = wall_ratio(stack);
  const double part = part_from_below(stack);
  const double largest = std::max(-part * q, (1.0 - part) * q);  // below 1, or A is negative or infinite
  if (largest >= 1.0) {
    return {fmt::format(
        "k_mu = {}: must be < {} with direction = {} and wall_load = {}: the walls would take the whole force "
        "on a cell, or more",
        stack.k_mu, stack.wall_load == "mean" ? "1" : "0.5", stack.direction, stack.wall_load)};
  }
  const double x = static_cast<double>(stack.layers) * -decay(stack);
  if (x <= highest_push) return {};
  return {fmt::format(
      "layers = {}: is {:.6g} times lambda_2; must be <= {} times it with direction = pushed-up, where force "
      "grows as exp(layers/lambda_2)",
      stack.layers, x, highest_push)};
}

Table evaluate(const JanssenDiscrete& stack) {
  Column layers{
      .name = "layer", .unit = "1", .about = "number of the cell, counted from the top", .values = {}, .words = {}};
  Column forces{.name = "force",
                .unit = "m g",
                .about = "upward force on the middle grain of this cell",
                .values = {},
                .words = {}};
  for (std::int64_t layer = 1; layer <= stack.layers; ++layer) {
    layers.values.push_back(static_cast<double>(layer));
    forces.values.push_back(force_below(stack, layer));
  }
  const auto lengths = discrete_lengths(stack);
  const bool saturates = stack.direction == "rest";
  return {{layers, forces},
          {{"lambda_1", lengths.lambda_1, "l", "sets the size of the force, in heights of a cell; 1/(2 k_mu)"},
           {"lambda_2", lengths.lambda_2, "l",
            "sets its change with depth, in heights of a cell; 1/|ln(1 +- 2 k_mu)| with wall_load = below"},
           {"ratio", lengths.ratio, "1", "lambda_1/lambda_2; 1 in a continuum"},
           {"saturation_force", saturates ? grains_in_cell * lengths.lambda_1 : std::numeric_limits<double>::infinity(),
            "m g", "force far below the top; infinite if pushed up or without friction"}}};
}

}  // namespace repose::theory
