// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/huge_pages.hpp"
#include "repose/core/numbers.hpp"
#include "repose/methods/deposition/roller.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::deposition {

/// The discs of a packing in columns at least as wide as the largest diameter. A falling disc can only meet discs near
/// the top of three columns, mostly one of the two highest. So each column has one cache line with all that is needed
/// of its two highest discs, and a second line with the next two. Only deeper discs are looked up among all grains,
/// where each costs a page.
class Columns {
 public:
  Columns(const DepositionSettings& settings, const Grains<2>& grains)
      : box_(settings.box),
        largest_(settings.largest_radius),
        mixed_(settings.smallest_radius < settings.largest_radius),
        line_(grains.line),
        count_(std::max(1L, static_cast<long>(box_.width() / (2.0 * largest_)))),
        per_width_(static_cast<double>(count_) / box_.width()),
        high_(static_cast<std::size_t>(count_) + 1),
        low_(high_.size()) {
    below_.reserve(grains.line.capacity());
    prefer_huge_pages(below_);
  }

  /// Lists a disc inside the box. Numbers ascend from 0.
  void add(std::int32_t number) {
    const auto& grain = line_[static_cast<std::size_t>(number)];
    const double y = grain.position[1];
    const auto c = static_cast<std::size_t>(std::clamp(column_of(grain.position[0]), 0L, count_ - 1));
    auto& high = high_[c];
    auto& low = low_[c];
    const Fixed disc{grain.position[0], y, grain.radius, number};
    if (!(high.y[0] > y)) {
      below_.push_back(high.number[0]);
      low.push(high.disc(1));
      high.push(disc);
    } else if (!(high.y[1] > y)) {
      below_.push_back(high.number[1]);
      below_[static_cast<std::size_t>(high.number[0])] = number;
      low.push(high.disc(1));
      high.set(1, disc);
    } else {
      auto above = high.number[1];
      auto next = below_[static_cast<std::size_t>(above)];
      while (next != nothing && height(next) > y) {
        above = next;
        next = below_[static_cast<std::size_t>(above)];
      }
      below_.push_back(next);
      below_[static_cast<std::size_t>(above)] = number;
      if (!(low.y[0] > y)) {
        low.push(disc);
      } else if (!(low.y[1] > y)) {
        low.set(1, disc);
      }
    }
    high.next = low.y[0];
  }

  /// Fetches the lines that the fall of a disc from x needs.
  void prefetch(double x) const {
    const long own = column_of(x);
    for (const long c : {own - 1, own, own + 1}) {
      __builtin_prefetch(&high_[static_cast<std::size_t>(std::clamp(c, 0L, count_ - 1))]);
    }
  }

  REPOSE_FN void fall(Fall& fall) const {
    const long own = column_of(fall.x);
    const std::array<Image, 3> images{image(own), image(own - 1), image(own + 1)};
    // It mostly lands on one of the two highest discs of these columns: all six are tried at once.
    std::array<Two, 3> landing;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& high = high_[images[k].column];
      landing[k] = fall.landing(high.x + images[k].shift, high.y, high.radius);
    }
    const Two pair = larger(larger(landing[0], landing[1]), landing[2]);
    const double highest = larger(pair[0], pair[1]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (landing[k][0] == highest) fall.land_on(high_[images[k].column].disc(0, images[k].shift), highest);
      if (landing[k][1] == highest) fall.land_on(high_[images[k].column].disc(1, images[k].shift), highest);
    }
    const double reach = fall.radius + largest_;
    for (const auto& image : images) {
      if (high_[image.column].next + reach < fall.best.y) continue;
      for_low(image, [&](const Fixed& disc) {
        if (disc.y + reach < fall.best.y) return false;
        if (disc.y <= fall.start) fall.consider(disc);
        return true;
      });
    }
  }

  REPOSE_FN void roll(Arc& arc) const {
    const double other = arc.radius + largest_;
    const double ahead = arc.reach + other;
    const double behind = mixed_ ? ahead : 0.0;
    const double left = arc.pivot.x - (arc.side > 0.0 ? behind : ahead);
    const double right = arc.pivot.x + (arc.side > 0.0 ? ahead : behind);
    const double highest = arc.pivot.y + arc.y0 + other;
    const auto meet = [&](const Fixed& disc) {
      if (disc.y < arc.pivot.y - other) return false;
      if (disc.y <= highest) arc.consider(disc);
      return true;
    };
    for (long c = column_of(left), last = column_of(right); c <= last; ++c) {
      const auto image = this->image(c);
      const auto& high = high_[image.column];
      if (meet(high.disc(0, image.shift)) && meet(high.disc(1, image.shift))) for_low(image, meet);
    }
  }

 private:
  static constexpr double lowest = -std::numeric_limits<double>::infinity();

  /// Two discs of a column, the higher one first. Where there is none, its y is below all.
  struct alignas(64) Pair {
    Two x{no_number, no_number};
    Two y{lowest, lowest};
    Two radius{};
    std::array<std::int32_t, 2> number{nothing, nothing};
    double next = lowest;  ///< [L] y of the next lower disc of the column

    Fixed disc(std::size_t k, double shift = 0.0) const { return {x[k] + shift, y[k], radius[k], number[k]}; }
    void set(std::size_t k, const Fixed& disc) {
      x[k] = disc.x;
      y[k] = disc.y;
      radius[k] = disc.radius;
      number[k] = disc.number;
    }
    /// Puts a disc on top; the lower of the two drops out.
    void push(const Fixed& disc) {
      set(1, this->disc(0));
      set(0, disc);
    }
  };
  static_assert(sizeof(Pair) == 64);

  /// A column, or its image outside a periodic box.
  struct Image {
    std::size_t column;
    double shift;  ///< [L] of the image
  };

  template <class T>
  static T larger(T a, T b) {
    return a > b ? a : b;
  }
  double height(std::int32_t number) const { return line_[static_cast<std::size_t>(number)].position[1]; }
  long column_of(double x) const { return static_cast<long>(std::floor((x - box_.x_min) * per_width_)); }

  Image image(long c) const {
    if (c >= 0 && c < count_) return {static_cast<std::size_t>(c), 0.0};
    if (!box_.periodic) return {static_cast<std::size_t>(count_), 0.0};
    const long image = c >= 0 ? c / count_ : -((count_ - 1 - c) / count_);
    return {static_cast<std::size_t>(c - image * count_), static_cast<double>(image) * box_.width()};
  }

  /// Calls use(disc) for the discs of a column from the third highest down until it returns false.
  template <class Use>
  REPOSE_FN void for_low(const Image& image, const Use& use) const {
    const auto& low = low_[image.column];
    if (!use(low.disc(0, image.shift)) || !use(low.disc(1, image.shift)) || low.number[1] == nothing) return;
    auto number = low.number[1];
    while ((number = below_[static_cast<std::size_t>(number)]) != nothing) {
      const auto& disc = line_[static_cast<std::size_t>(number)];
      if (!use(Fixed{disc.position[0] + image.shift, disc.position[1], disc.radius, number})) return;
    }
  }

  Box<2> box_;
  double largest_;
  bool mixed_;
  const std::vector<Grain<2>>& line_;
  long count_;
  double per_width_;
  std::vector<Pair> high_;  // the two highest discs of each column; the last is empty, for the space beside walls
  std::vector<Pair> low_;   // the next two
  std::vector<std::int32_t> below_;  // for each disc, the next lower one of its column
};

}  // namespace repose::deposition
