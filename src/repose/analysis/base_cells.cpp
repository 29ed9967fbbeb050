// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_cells.hpp"

#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace repose {

namespace {

/// The cells along one axis. Their numbers are whole, but may exceed every integer where a load lies far away.
class CellAxis {
 public:
  CellAxis(double width, bool periodic, double low, double high) : side_(width) {
    if (!periodic) return;
    count_ = std::max(1.0, std::round((high - low) / width));
    side_ = (high - low) / count_;
    low_ = low;
    first_middle_ = low + 0.5 * side_;
  }

  double side() const { return side_; }
  double middle(double cell) const { return first_middle_ + cell * side_; }
  double cell(double place) const {
    if (count_ == 0.0) return std::floor(place / side_ + 0.5);
    return std::clamp(std::floor((place - low_) / side_), 0.0, count_ - 1.0);
  }

 private:
  double side_;
  double count_ = 0.0;  // of a periodic axis
  double low_ = 0.0;
  double first_middle_ = 0.0;
};

}  // namespace

BaseCells measure_base_cells(const std::vector<BaseLoad>& loads, double width, const Box<3>& box) {
  REPOSE_ASSERT(width > 0.0);
  const CellAxis along_x(width, box.periodic, box.x_min, box.x_max);
  const CellAxis along_y(width, box.periodic_y, box.y_min, box.y_max);
  struct Sum {
    std::int64_t count = 0;
    Vec<3> force{};
  };
  std::map<std::array<double, 2>, Sum> sums;
  Vec<3> all{};
  for (const auto& load : loads) {
    const auto place = box.wrapped({{load.place[0], load.place[1], 0.0}});
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) continue;
    auto& sum = sums[{along_x.cell(place[0]), along_y.cell(place[1])}];
    ++sum.count;
    sum.force += load.force;
    all += load.force;
  }
  BaseCells result;
  result.side = {along_x.side(), along_y.side()};
  result.load = -all[2];
  result.traction = {all[0], all[1]};
  const double per_area = 1.0 / result.area();
  for (const auto& [cell, sum] : sums) {
    result.cells.push_back({along_x.middle(cell[0]), along_y.middle(cell[1]), sum.count, -sum.force[2] * per_area,
                            sum.force[0] * per_area, sum.force[1] * per_area});
  }
  return result;
}

}  // namespace repose
