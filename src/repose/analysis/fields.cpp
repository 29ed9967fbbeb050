// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace repose {

namespace {

constexpr double tail = 8.5;  // widths
constexpr double most_cells = 4e6;

/// Points and weights of Gauss and Legendre on [0, 1], of order 16.
constexpr std::array<std::pair<double, double>, 8> quadrature = {{{0.019855071751231884, 0.050614268145188130},
                                                                  {0.101666761293186631, 0.111190517226687235},
                                                                  {0.237233795041835507, 0.156853322938943644},
                                                                  {0.408282678752175097, 0.181341891689180991},
                                                                  {0.591717321247824903, 0.181341891689180991},
                                                                  {0.762766204958164493, 0.156853322938943644},
                                                                  {0.898333238706813369, 0.111190517226687235},
                                                                  {0.980144928248768116, 0.050614268145188130}}};

/// The Gaussian of one point over the cells of one axis: shares of cells first, first + 1, ...
struct Shares {
  long first = 0;
  std::vector<double> share;
};

class Grid {
 public:
  Grid(const Grains<2>& grains, const std::vector<bool>& in_heap, const Box<2>& box, double width);

  bool empty() const { return columns_ == 0; }
  /// Zero everywhere.
  std::vector<double> field() const { return std::vector<double>(static_cast<std::size_t>(columns_ * rows_), 0.0); }
  void fill_places(Fields& fields) const;

  /// Calls `add(cell, share)` for every cell that the Gaussian about a point reaches.
  template <class Add>
  void spread(const Vec<2>& point, const Add& add);

 private:
  void shares(double place, Shares& shares) const;

  double width_;
  double cell_ = 0.0;
  long first_column_ = 0;  // the grid's edges are at multiples of the cell, in a periodic box from its side
  long first_row_ = 0;
  long columns_ = 0;
  long rows_ = 0;
  bool periodic_ = false;
  double origin_ = 0.0;
  Shares along_x_;
  Shares along_y_;
};

Grid::Grid(const Grains<2>& grains, const std::vector<bool>& in_heap, const Box<2>& box, double width)
    : width_(width), cell_(0.5 * width), periodic_(box.periodic) {
  Vec<2> low{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
  Vec<2> high = low * -1.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    // Contact points with supports may lie a diameter outside the centres.
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], grain.position[axis] - 2.0 * grain.radius);
      high[axis] = std::max(high[axis], grain.position[axis] + 2.0 * grain.radius);
    }
  }
  if (!(low[0] <= high[0])) return;
  const double wide = periodic_ ? box.width() : high[0] - low[0] + 2.0 * tail * width;
  const double tall = high[1] - low[1] + 2.0 * tail * width;
  cell_ = std::max(cell_, std::sqrt(wide * tall / most_cells));
  const auto at = [&](double place) { return static_cast<long>(std::floor(place / cell_)); };
  if (periodic_) {
    columns_ = std::max(1L, static_cast<long>(std::ceil(wide / cell_)));
    cell_ = wide / static_cast<double>(columns_);
    origin_ = box.x_min;
  } else {
    first_column_ = at(low[0] - tail * width);
    columns_ = at(high[0] + tail * width) - first_column_ + 1;
  }
  first_row_ = at(low[1] - tail * width);
  rows_ = at(high[1] + tail * width) - first_row_ + 1;
}

void Grid::fill_places(Fields& fields) const {
  fields.width = width_;
  fields.cell = cell_;
  for (long k = 0; k < columns_; ++k) {
    fields.x.push_back(origin_ + (static_cast<double>(first_column_ + k) + 0.5) * cell_);
  }
  for (long k = 0; k < rows_; ++k) fields.y.push_back((static_cast<double>(first_row_ + k) + 0.5) * cell_);
}

void Grid::shares(double place, Shares& shares) const {
  shares.first = static_cast<long>(std::floor((place - tail * width_) / cell_));
  const long last = static_cast<long>(std::floor((place + tail * width_) / cell_));
  shares.share.clear();
  const auto below = [&](long edge) {
    return 0.5 * std::erfc((place - static_cast<double>(edge) * cell_) / (width_ * std::numbers::sqrt2));
  };
  double left = below(shares.first);
  for (long k = shares.first; k <= last; ++k) {
    const double right = below(k + 1);
    shares.share.push_back(right - left);
    left = right;
  }
}

template <class Add>
void Grid::spread(const Vec<2>& point, const Add& add) {
  shares(point[0] - origin_, along_x_);
  shares(point[1], along_y_);
  for (std::size_t m = 0; m < along_y_.share.size(); ++m) {
    const long row = along_y_.first + static_cast<long>(m) - first_row_;
    if (row < 0 || row >= rows_) continue;
    for (std::size_t k = 0; k < along_x_.share.size(); ++k) {
      long column = along_x_.first + static_cast<long>(k) - first_column_;
      if (periodic_) column = (column % columns_ + columns_) % columns_;
      if (column < 0 || column >= columns_) continue;
      add(static_cast<std::size_t>(row * columns_ + column), along_x_.share[k] * along_y_.share[m]);
    }
  }
}

}  // namespace

Fields coarse_grained(const Grains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, double width) {
  Fields fields;
  fields.width = width;
  Grid grid(grains, in_heap, box, width);
  if (grid.empty()) return fields;
  grid.fill_places(fields);
  fields.density = grid.field();
  fields.solid_fraction = grid.field();
  for (auto& component : fields.stress) component = grid.field();
  for (auto& component : fields.support) component = grid.field();
  const double per_area = 1.0 / (fields.cell * fields.cell);

  std::unordered_map<std::int64_t, std::size_t> place;
  for (const auto k : by_id(grains)) {
    place.emplace(grains.id[k], k);
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    const double mass = grain.mass * per_area;
    const double area = std::numbers::pi * grain.radius * grain.radius * per_area;
    grid.spread(grain.position, [&](std::size_t cell, double share) {
      fields.density[cell] += mass * share;
      fields.solid_fraction[cell] += area * share;
    });
  }

  for (const auto& contact : contacts.list) {
    const auto first = place.at(contact.first);
    const bool first_counts = in_heap[first];
    const bool second_counts = contact.second >= 0 && in_heap[place.at(contact.second)];
    if (!first_counts && !second_counts) continue;
    const Vec<2> force = force_of(contact) * per_area;
    const Vec<2> centre = grains.line[first].position;
    const Vec<2> point = centre - contact.normal * contact.first_lever;
    // The branch ends at the first partner; at a support it runs between the contact point and the grain of the heap.
    Vec<2> start = point;
    Vec<2> branch = centre - point;
    if (second_counts) {
      const Vec<2> whole = separation(centre, grains.line[place.at(contact.second)].position, box);
      start = centre - whole;
      branch = first_counts ? whole : point - start;
    }
    for (const auto& [along, weight] : quadrature) {
      const Vec<2> xx_xy = branch * (weight * force[0]);
      const Vec<2> yx_yy = branch * (weight * force[1]);
      grid.spread(start + branch * along, [&](std::size_t cell, double share) {
        fields.stress[0][cell] += xx_xy[0] * share;
        fields.stress[1][cell] += xx_xy[1] * share;
        fields.stress[2][cell] += yx_yy[0] * share;
        fields.stress[3][cell] += yx_yy[1] * share;
      });
    }
    if (first_counts != second_counts) {
      const Vec<2> on_heap = first_counts ? force : force * -1.0;
      grid.spread(point, [&](std::size_t cell, double share) {
        fields.support[0][cell] += on_heap[0] * share;
        fields.support[1][cell] += on_heap[1] * share;
      });
    }
  }
  return fields;
}

}  // namespace repose
