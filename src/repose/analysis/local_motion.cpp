// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/local_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();
constexpr double flat = 1e-9;          // of the spread of places along an axis, against their distance from the cell
constexpr double least_freedom = 0.1;  // fraction of the variance that a fit must leave

/// A direction in which the places of grains spread.
struct Spread {
  Vec<2> axis{};
  double variance = 0.0;  // [L^2]
};

std::array<Spread, 2> spreads_of(double xx, double xy, double yy) {
  const double middle = 0.5 * (xx + yy);
  const double deviator = std::hypot(0.5 * (xx - yy), xy);
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Vec<2> axis{{std::cos(angle), std::sin(angle)}};
  return {Spread{axis, middle + deviator}, Spread{{{-axis[1], axis[0]}}, middle - deviator}};
}

}  // namespace

void LocalMotion::add(const Smear& smear, double mass, const Vec<2>& position, const Vec<2>& velocity) {
  const Vec<2> moving = velocity - frame_;
  smear.for_each([&](std::size_t cell, double weight, const Vec<2>& centre) {
    auto& sum = moments_[cell];
    const double m = mass * weight;
    const Vec<2> place = position - centre;
    sum.mass += m;
    sum.momentum += moving * m;
    sum.place += place * m;
    sum.x_place += place * (m * place[0]);
    sum.y_place += place * (m * place[1]);
    sum.x_velocity += place * (m * moving[0]);
    sum.y_velocity += place * (m * moving[1]);
    sum.speed_squared += m * squared(moving);
    sum.squares += m * m;
    sum.squares_place += place * (m * m);
    sum.squares_x += place * (m * m * place[0]);
    sum.squares_y += place * (m * m * place[1]);
  });
}

std::array<std::vector<double>, 2> LocalMotion::velocity() const {
  std::array<std::vector<double>, 2> velocity;
  for (const auto& sum : moments_) {
    for (int k = 0; k < 2; ++k) {
      velocity[static_cast<std::size_t>(k)].push_back(sum.mass > 0.0 ? frame_[k] + sum.momentum[k] / sum.mass
                                                                     : not_defined);
    }
  }
  return velocity;
}

std::vector<double> LocalMotion::temperature() const {
  std::vector<double> temperature;
  for (const auto& sum : moments_) temperature.push_back(temperature_of(sum));
  return temperature;
}

double LocalMotion::temperature_of(const Moments& sum) {
  if (!(sum.mass > 0.0)) return not_defined;
  const double each = 1.0 / sum.mass;
  const Vec<2> mean = sum.momentum * each;
  const Vec<2> place = sum.place * each;
  const auto spreads =
      spreads_of(sum.x_place[0] * each - place[0] * place[0], sum.x_place[1] * each - place[0] * place[1],
                 sum.y_place[1] * each - place[1] * place[1]);
  const Vec<2> x_gain = sum.x_velocity * each - place * mean[0];
  const Vec<2> y_gain = sum.y_velocity * each - place * mean[1];
  double variance = sum.speed_squared * each - squared(mean);
  double taken = sum.squares * squared(each);  // fraction of the variance that the fit removes
  for (const auto& [axis, along] : spreads) {
    if (!(along > flat * (sum.x_place[0] + sum.y_place[1]) * each)) continue;
    variance -= (squared(dot(x_gain, axis)) + squared(dot(y_gain, axis))) / along;
    // Sum of squared weights times the squared distance from the mean place along the axis.
    const double origin = dot(place, axis);
    const double second = axis[0] * dot(sum.squares_x, axis) + axis[1] * dot(sum.squares_y, axis);
    const double about = second - 2.0 * origin * dot(sum.squares_place, axis) + squared(origin) * sum.squares;
    taken += about * squared(each) / along;
  }
  const double left = 1.0 - taken;
  return left > least_freedom ? std::max(0.0, 0.5 * variance) / left : not_defined;
}

}  // namespace repose
