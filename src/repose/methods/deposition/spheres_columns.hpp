// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/huge_pages.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/methods/deposition/spheres_roller.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose::deposition::spheres {

/// The spheres of a packing in upright columns, each a list from the highest down. A path looks into the columns whose
/// spheres it may reach, from the top to the depth that it may reach. So its cost does not grow with the height of the
/// bed. A sphere takes 40 bytes here.
class Columns {
 public:
  Columns(const SphereDepositionSettings& settings, const Grains<3>& grains)
      : largest_(settings.largest_radius), line_(grains.line) {
    const auto& box = settings.box;
    double x_low = settings.drop_centre[0];
    double x_high = x_low;
    double y_low = settings.drop_centre[1];
    double y_high = y_low;
    for (const auto& grain : line_) {
      x_low = std::min(x_low, grain.position[0]);
      x_high = std::max(x_high, grain.position[0]);
      y_low = std::min(y_low, grain.position[1]);
      y_high = std::max(y_high, grain.position[1]);
    }
    // On an open axis the outer columns hold everything beyond.
    const double room = 2.0 * largest_ * (2.0 + reproducible::pow(static_cast<double>(settings.count), 1.0 / 3.0));
    const auto axis = [&](bool periodic, double low, double high, double least, double most) {
      return Axis(periodic, std::isfinite(low) ? low : least - room, std::isfinite(high) ? high : most + room,
                  largest_);
    };
    x_ = axis(box.periodic, box.x_min, box.x_max, x_low, x_high);
    y_ = axis(box.periodic_y, box.y_min, box.y_max, y_low, y_high);
    top_.assign(static_cast<std::size_t>(x_.count * y_.count), nothing);
    spheres_.reserve(grains.line.capacity());
    prefer_huge_pages(spheres_);
  }

  /// Lists a sphere inside the box. Numbers ascend from 0.
  void add(std::int32_t number) {
    const auto& grain = line_[static_cast<std::size_t>(number)];
    auto* link = &top_[column(x_.inside(grain.position[0]), y_.inside(grain.position[1]))];
    while (*link != nothing && at(*link).centre[2] > grain.position[2]) link = &at(*link).below;
    const std::int32_t below = *link;
    *link = number;  // before the array may move
    spheres_.push_back({grain.position, grain.radius, below});
  }

  /// Fetches what the fall of a sphere from (x, y) needs first.
  void prefetch(double x, double y) const {
    const auto top = top_[column(x_.inside(x), y_.inside(y))];
    if (top != nothing) __builtin_prefetch(&at(top));
  }

  void fall(Fall& fall) const {
    const double reach = fall.radius + largest_;
    // The column below first: the landing there is mostly the highest, and ends the search in the others early.
    const long own_x = x_.cell(fall.x);
    const long own_y = y_.cell(fall.y);
    const auto meet = [&](long i, long j) {
      for_column(i, j, [&](const Vec<3>& centre, double radius, std::int32_t number) {
        if (centre[2] + reach < fall.height) return false;
        fall.consider(centre, radius, number);
        return true;
      });
    };
    meet(own_x, own_y);
    const long last_x = x_.cell(fall.x + reach);
    const long last_y = y_.cell(fall.y + reach);
    for (long i = x_.cell(fall.x - reach); i <= last_x; ++i) {
      for (long j = y_.cell(fall.y - reach); j <= last_y; ++j) {
        if (i != own_x || j != own_y) meet(i, j);
      }
    }
  }

  void roll(Arc& arc) const {
    const double reach = arc.own + largest_;
    const auto along_x = arc.range(0);
    const auto along_y = arc.range(1);
    const auto along_z = arc.range(2);
    const double lowest = along_z[0] - reach;
    const double highest = along_z[1] + reach;
    const long last_x = x_.cell(along_x[1] + reach);
    const long first_y = y_.cell(along_y[0] - reach);
    const long last_y = y_.cell(along_y[1] + reach);
    for (long i = x_.cell(along_x[0] - reach); i <= last_x; ++i) {
      for (long j = first_y; j <= last_y; ++j) {
        for_column(i, j, [&](const Vec<3>& centre, double radius, std::int32_t number) {
          if (centre[2] < lowest) return false;
          if (centre[2] <= highest) arc.consider(centre, radius, number);
          return true;
        });
      }
    }
  }

 private:
  struct Sphere {
    Vec<3> centre;
    double radius;
    std::int32_t below;  ///< the next lower one of its column
  };

  /// The columns along one axis.
  struct Axis {
    bool periodic = false;
    double low = 0.0;     ///< [L]
    double length = 1.0;  ///< [L]
    long count = 1;
    double per_length = 1.0;

    Axis() = default;
    Axis(bool is_periodic, double least, double most, double largest_radius)
        : periodic(is_periodic), low(least), length(most - least) {
      constexpr double most_columns = 4096.0;
      count = static_cast<long>(std::clamp(length / (1.5 * largest_radius), 1.0, most_columns));
      per_length = static_cast<double>(count) / length;
    }

    /// The column of a place: inside a periodic axis or that of an image, else the nearest one.
    long cell(double place) const {
      const double k = std::floor((place - low) * per_length);
      return static_cast<long>(periodic ? k : std::clamp(k, 0.0, static_cast<double>(count - 1)));
    }
    long inside(double place) const { return std::clamp(cell(place), 0L, count - 1); }
    /// How many lengths away from the box a column lies.
    long image(long k) const { return k >= 0 ? k / count : -((count - 1 - k) / count); }
  };

  std::size_t column(long i, long j) const { return static_cast<std::size_t>(i * y_.count + j); }
  const Sphere& at(std::int32_t number) const { return spheres_[static_cast<std::size_t>(number)]; }
  Sphere& at(std::int32_t number) { return spheres_[static_cast<std::size_t>(number)]; }

  /// Calls use(centre, radius, number) for the spheres of a column from the highest down until it returns false.
  template <class Use>
  void for_column(long i, long j, const Use& use) const {
    const long image_x = x_.image(i);
    const long image_y = y_.image(j);
    const double shift_x = static_cast<double>(image_x) * x_.length;
    const double shift_y = static_cast<double>(image_y) * y_.length;
    auto number = top_[column(i - image_x * x_.count, j - image_y * y_.count)];
    while (number != nothing) {
      const auto& sphere = at(number);
      Vec<3> centre = sphere.centre;
      if (image_x != 0) centre[0] += shift_x;
      if (image_y != 0) centre[1] += shift_y;
      if (!use(centre, sphere.radius, number)) return;
      number = sphere.below;
    }
  }

  double largest_;
  const std::vector<Grain<3>>& line_;
  Axis x_;
  Axis y_;
  std::vector<std::int32_t> top_;  // the highest sphere of each column
  std::vector<Sphere> spheres_;
};

}  // namespace repose::deposition::spheres
