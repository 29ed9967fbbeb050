// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/smear.hpp"
#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace repose {

/// The motion of grains around each cell of a grid: the mean velocity, and how far velocities scatter about a linear
/// flow. Grains count by their mass times the weight of the cell in their Gaussian.
///
/// The granular temperature is half the weighted variance of the two velocity components about the straight lines
/// (linear in x and y) that fit them best at the cell, divided by the fraction of the variance that such a fit leaves
/// on average (the sum of its weighted residual degrees of freedom). So it is 0 for rigid motion and uniform shear,
/// which would otherwise add width^2 (sum of squared velocity gradients)/2, and its mean is the variance of a component
/// for independent velocities.
/// Validated by tests/unit/fields_motion_test.cpp.
class LocalMotion {
 public:
  /// `frame` [L/T]: velocities are summed relative to it, so that a common motion costs no digits.
  LocalMotion(std::size_t cells, const Vec<2>& frame) : moments_(cells), frame_(frame) {}

  /// Adds a grain, whose weights `smear` holds.
  void add(const Smear& smear, double mass, const Vec<2>& position, const Vec<2>& velocity);

  /// Momentum over mass [L/T]; NaN where there is no grain.
  std::array<std::vector<double>, 2> velocity() const;

  /// [L^2/T^2]; NaN where fewer than about four grains are near.
  std::vector<double> temperature() const;

 private:
  /// Sums over grains; places are relative to the centre of the cell.
  struct Moments {
    double mass = 0.0;
    Vec<2> momentum{}, place{};
    Vec<2> x_place{}, y_place{};        // x and y of the place, times the place
    Vec<2> x_velocity{}, y_velocity{};  // x and y of the velocity, times the place
    double speed_squared = 0.0;
    double squares = 0.0;  // of the masses; the same times the place, and its products
    Vec<2> squares_place{}, squares_x{}, squares_y{};
  };

  static double temperature_of(const Moments& moments);

  std::vector<Moments> moments_;
  Vec<2> frame_;
};

}  // namespace repose
