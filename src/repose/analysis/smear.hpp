// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose {

/// The cells of a grid along one axis.
struct FieldAxis {
  double origin = 0.0;  ///< [L] lower edge of cell 0
  long count = 0;
  bool wraps = false;
};

/// A grid of square cells, numbered by ascending y, then x.
struct FieldGrid {
  double cell = 0.0;  ///< [L] side
  std::array<FieldAxis, 2> axis{};

  double cells() const { return static_cast<double>(axis[0].count) * static_cast<double>(axis[1].count); }
  std::vector<double> centres(std::size_t along) const;  ///< [L]
};

/// Spreads quantities over the cells of a grid by a Gaussian that ends at walls. Each spreading sums to one.
///
/// At level and upright planes the Gaussian is cut off and divided by the part of it that is left, along each axis and
/// at each point for itself, exactly as an average over cells. So the sum over a row of cells does not feel upright
/// planes, and the sum over a column does not feel level ones. Of other planes and of finite walls it keeps what the
/// eye sees, a point on the grains' side of the wall, in cells near walls to a sixteenth of the cell, and is divided by
/// the sum of that. Where less than a millionth would be left (a source behind a wall), walls are not felt.
class Smear {
 public:
  static constexpr double reach = 8.5;  ///< widths; 2e-17 of a Gaussian lies beyond

  Smear(const FieldGrid& grid, double width, const std::vector<FlatWall>& walls, const Box<2>& box);

  /// The Gaussian about a point [L].
  void at(const Vec<2>& point, const Vec<2>& eye);

  /// The mean of the Gaussians about the points of a line from `start` along `branch` [L].
  void along(const Vec<2>& start, const Vec<2>& branch, const Vec<2>& eye);

  /// Adds `total` times the present weights to a field, as a density.
  void add(std::vector<double>& field, double total) const;

  /// Calls use(cell, weight, centre) for the cells that have a weight. The centre [L] is that of the image of the cell
  /// near the source, which may lie outside a periodic box.
  template <class Use>
  void for_each(const Use& use) const {
    for (std::size_t row = 0; row < count_[1]; ++row) {
      for (std::size_t column = 0; column < count_[0]; ++column) {
        const double weight = weights_[row * count_[0] + column];
        if (weight > 0.0) use(cell_of(row, column), weight, centre_of(row, column));
      }
    }
  }

  /// The fraction of each cell that walls leave to the sources so far; 0 where none reaches.
  std::vector<double> room() const;

 private:
  /// The interval that planes across an axis leave.
  struct Between {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };

  long cell_at(double place, std::size_t axis) const;
  std::size_t cell_of(std::size_t row, std::size_t column) const;
  Vec<2> centre_of(std::size_t row, std::size_t column) const;
  void open(const Vec<2>& start, const Vec<2>& end);
  void spread(const Vec<2>& point, double weight);
  void spread_along(std::size_t axis, double place);
  void keep_visible(const Vec<2>& eye);
  unsigned visible_points(const Vec<2>& from_eye, const Vec<2>& eye, const std::vector<FlatWall>& planes,
                          const std::vector<PieceOfWall>& pieces) const;

  FieldGrid grid_;
  double width_;
  Box<2> box_;
  std::array<Between, 2> between_{};
  std::vector<FlatWall> planes_;  // neither level nor upright
  std::vector<FlatWall> pieces_;
  std::array<long, 2> first_{};  // first cell; on a wrapping axis, before wrapping
  std::array<std::size_t, 2> count_{};
  std::array<std::vector<double>, 2> along_;
  std::vector<double> weights_;
  std::vector<double> visible_;
  std::vector<std::uint16_t> seen_;  // of each cell, a bit for each of its sixteen points
};

}  // namespace repose
