// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen_discrete.hpp"

#include "repose/theory/column_walls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace repose::theory {

namespace {

constexpr double grains_in_cell = 3.0;

/// 2 K mu, negative pushed up: F_i = (F_(i-1) + 3) / (1 + friction_share).
double friction_share(const JanssenDiscrete& stack) { return wall_sense(stack.direction) * 2.0 * stack.k_mu; }

}  // namespace

double force_below(const JanssenDiscrete& stack, std::int64_t layers) {
  const double q = friction_share(stack);
  const auto cells = static_cast<double>(layers);
  if (q == 0.0) return grains_in_cell * cells;
  return grains_in_cell * (-std::expm1(-cells * std::log1p(q)) / q);  // (34) with A = 1/(1 + q), B = 3/(1 + q)
}

DiscreteLengths discrete_lengths(const JanssenDiscrete& stack) {
  const double q = friction_share(stack);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (q == 0.0) return {.lambda_1 = infinite, .lambda_2 = infinite, .ratio = 1.0};
  const double logarithm = std::log1p(q);
  return {.lambda_1 = 1.0 / std::abs(q), .lambda_2 = 1.0 / std::abs(logarithm), .ratio = logarithm / q};
}

void parameters(JanssenDiscrete& stack, ModelParameters& to) {
  to.number("k_mu", stack.k_mu, not_negative, "1", "stress ratio times friction of the walls, below 1/2 pushed up");
  to.integer("layers", stack.layers, {.low = 1, .high = 10'000'000}, "cells");
  to.choice("direction", stack.direction, column_directions(),
            "rest: the walls carry; pushed-up: they hold back with the same friction");
}

std::vector<std::string> relations(const JanssenDiscrete& stack) {
  if (stack.direction == "rest") return {};
  if (2.0 * stack.k_mu >= 1.0) {
    return {
        fmt::format("k_mu = {}: must be < 0.5 pushed up, where 2 k_mu >= 1 jams: walls hold back all that a cell "
                    "is pushed with",
                    stack.k_mu)};
  }
  const double x = static_cast<double>(stack.layers) / discrete_lengths(stack).lambda_2;
  if (x <= highest_push) return {};
  return {
      fmt::format("layers = {}: are {:.6g} times lambda_2, must be <= {} times pushed up, where force grows as "
                  "exp(layers/lambda_2)",
                  stack.layers, x, highest_push)};
}

Table evaluate(const JanssenDiscrete& stack) {
  Column layers{
      .name = "layer", .unit = "1", .about = "cells from the top, down to this one", .values = {}, .words = {}};
  Column forces{
      .name = "force", .unit = "m g", .about = "upward on the middle grain of this cell", .values = {}, .words = {}};
  for (std::int64_t layer = 1; layer <= stack.layers; ++layer) {
    layers.values.push_back(static_cast<double>(layer));
    forces.values.push_back(force_below(stack, layer));
  }
  const auto lengths = discrete_lengths(stack);
  const bool saturates = stack.direction == "rest";
  return {{layers, forces},
          {{"lambda_1", lengths.lambda_1, "l", "1/(2 k_mu), in heights of a cell; sets the size of the force"},
           {"lambda_2", lengths.lambda_2, "l", "1/|ln(1 +- 2 k_mu)|, in heights of a cell; sets its change with depth"},
           {"ratio", lengths.ratio, "1", "lambda_1/lambda_2; 1 in a continuum"},
           {"saturation_force", saturates ? grains_in_cell * lengths.lambda_1 : std::numeric_limits<double>::infinity(),
            "m g", "force far below the top; infinite pushed up or without friction"}}};
}

}  // namespace repose::theory
