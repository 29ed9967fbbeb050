// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/deposition/roller.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace repose::deposition {

/// The discs of a packing in columns at least as wide as the largest diameter, each in ascending order of height. A
/// falling disc can only meet discs near the top of three columns. Buried discs stay listed, at four bytes each,
/// because a pit may lead down to them.
class Columns {
 public:
  Columns(const DepositionSettings& settings, const Grains<2>& grains)
      : box_(settings.box),
        largest_(settings.largest_radius),
        mixed_(settings.smallest_radius < settings.largest_radius),
        line_(grains.line),
        columns_(std::max<std::size_t>(1, static_cast<std::size_t>(box_.width() / (2.0 * largest_)))),
        width_(box_.width() / static_cast<double>(columns_.size())) {}

  /// Lists a disc inside the box.
  void add(std::int32_t number) {
    const auto& place = line_[static_cast<std::size_t>(number)].position;
    const auto last = static_cast<long>(columns_.size()) - 1;
    auto& column = columns_[static_cast<std::size_t>(std::clamp(column_of(place[0]), 0L, last))];
    const double y = place[1];
    auto k = column.size();
    column.push_back(number);
    for (; k > 0 && height(column[k - 1]) > y; --k) column[k] = column[k - 1];
    column[k] = number;
  }

  void clear() {
    for (auto& column : columns_) column.clear();
  }

  void fall(Fall& fall) const {
    const double reach = fall.radius + largest_;
    const auto search = [&](const Column& column, double shift) {
      for (auto k = end_below(column, fall.start); k-- > 0;) {
        const auto& disc = line_[static_cast<std::size_t>(column[k])];
        if (disc.position[1] + reach < fall.best.y) break;
        fall.consider({column[k], disc.position[0] + shift, disc.position[1], disc.radius});
      }
    };
    // Its own column first: it mostly lands there, and then few discs of the others can be higher.
    const long own = column_of(fall.x);
    for (const long c : {own, own - 1, own + 1}) use_column(c, search);
  }

  void roll(Arc& arc) const {
    const double other = arc.radius + largest_;
    const double ahead = arc.reach + other;
    const double behind = mixed_ ? ahead : 0.0;
    const double left = arc.pivot.x - (arc.side > 0.0 ? behind : ahead);
    const double right = arc.pivot.x + (arc.side > 0.0 ? ahead : behind);
    for_columns(left, right, [&](const auto& column, double shift) {
      for (auto k = end_below(column, arc.pivot.y + arc.y0 + other); k-- > 0;) {
        const auto& disc = line_[static_cast<std::size_t>(column[k])];
        if (disc.position[1] < arc.pivot.y - other) break;
        arc.consider({column[k], disc.position[0] + shift, disc.position[1], disc.radius});
      }
    });
  }

 private:
  using Column = std::vector<std::int32_t>;

  double height(std::int32_t number) const { return line_[static_cast<std::size_t>(number)].position[1]; }
  long column_of(double x) const { return static_cast<long>(std::floor((x - box_.x_min) / width_)); }

  /// The end of the discs of a column with centres up to `top`, or a little above it.
  std::size_t end_below(const Column& column, double top) const {
    constexpr std::size_t by_one = 4;  // discs checked before a binary search, since the end is usually near the top
    auto end = column.size();
    for (std::size_t k = 0; k < by_one && end > 0 && height(column[end - 1]) > top; ++k) --end;
    if (end == 0 || height(column[end - 1]) <= top) return end;
    const auto place = std::upper_bound(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(end), top,
                                        [&](double y, std::int32_t number) { return y < height(number); });
    return static_cast<std::size_t>(place - column.begin());
  }

  template <class Use>
  void for_columns(double left, double right, const Use& use) const {
    for (long c = column_of(left), last = column_of(right); c <= last; ++c) use_column(c, use);
  }

  /// Calls use(column, shift) for column c, which may be an image outside a periodic box.
  template <class Use>
  void use_column(long c, const Use& use) const {
    const auto count = static_cast<long>(columns_.size());
    if (c >= 0 && c < count) return use(columns_[static_cast<std::size_t>(c)], 0.0);
    if (!box_.periodic) return;
    const long image = c >= 0 ? c / count : -((count - 1 - c) / count);
    use(columns_[static_cast<std::size_t>(c - image * count)], static_cast<double>(image) * box_.width());
  }

  Box<2> box_;
  double largest_;
  bool mixed_;
  const std::vector<Grain<2>>& line_;
  std::vector<Column> columns_;
  double width_;
};

}  // namespace repose::deposition
