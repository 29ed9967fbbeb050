// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/smear.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

constexpr double least_visible = 1e-6;
constexpr double straight = 1e-9;  // of the normal of a level or upright plane
constexpr int points_across = 4;   // a cell
constexpr unsigned whole_cell = 0xffffU;

/// Gauss-Legendre rule with five points on [0, 1].
struct Quadrature {
  std::array<double, 5> place{};
  std::array<double, 5> weight{};

  Quadrature() {
    const double root = 2.0 * std::sqrt(10.0 / 7.0);
    const std::array<double, 3> node{0.0, std::sqrt(5.0 - root) / 3.0, std::sqrt(5.0 + root) / 3.0};
    const double near = (322.0 + 13.0 * std::sqrt(70.0)) / 1800.0;
    const double far = 0.5 * (1.0 - 64.0 / 225.0 - 2.0 * near);  // the weights sum to one
    place = {0.5 - 0.5 * node[2], 0.5 - 0.5 * node[1], 0.5, 0.5 + 0.5 * node[1], 0.5 + 0.5 * node[2]};
    weight = {far, near, 64.0 / 225.0, near, far};
  }
};

}  // namespace

std::vector<double> FieldGrid::centres(std::size_t along) const {
  std::vector<double> values;
  for (long k = 0; k < axis[along].count; ++k) {
    values.push_back(axis[along].origin + (static_cast<double>(k) + 0.5) * cell);
  }
  return values;
}

Smear::Smear(const FieldGrid& grid, double width, const std::vector<FlatWall>& walls, const Box<2>& box)
    : grid_(grid), width_(width), box_(box), seen_(static_cast<std::size_t>(grid.cells()), 0) {
  for (const auto& wall : walls) {
    if (std::isfinite(wall.half_length)) {
      pieces_.push_back(wall);
      continue;
    }
    bool across = false;
    for (int k = 0; k < 2; ++k) {
      if (std::fabs(wall.normal[1 - k]) > straight) continue;
      across = true;
      auto& between = between_[static_cast<std::size_t>(k)];
      if (wall.normal[k] > 0.0) between.low = std::max(between.low, wall.point[k]);
      if (wall.normal[k] < 0.0) between.high = std::min(between.high, wall.point[k]);
    }
    if (!across) planes_.push_back(wall);
  }
}

void Smear::at(const Vec<2>& point, const Vec<2>& eye) {
  open(point, point);
  spread(point, 1.0);
  keep_visible(eye);
}

void Smear::along(const Vec<2>& start, const Vec<2>& branch, const Vec<2>& eye) {
  static const Quadrature quadrature;
  open(start, start + branch);
  const double intervals = std::max(1.0, std::ceil(magnitude(branch) / width_));
  for (double interval = 0.0; interval < intervals; interval += 1.0) {
    for (std::size_t k = 0; k < quadrature.place.size(); ++k)
      spread(start + branch * ((interval + quadrature.place[k]) / intervals), quadrature.weight[k] / intervals);
  }
  keep_visible(eye);
}

void Smear::add(std::vector<double>& field, double total) const {
  const double scale = total / squared(grid_.cell);
  const auto& columns = grid_.axis[0];
  for (std::size_t row = 0; row < count_[1]; ++row) {
    const double* weight = weights_.data() + row * count_[0];
    double* line = field.data() + (first_[1] + static_cast<long>(row)) * columns.count;
    long column = columns.wraps ? ((first_[0] % columns.count) + columns.count) % columns.count : first_[0];
    for (std::size_t k = 0; k < count_[0]; ++k) {
      line[column] += scale * weight[k];
      if (++column == columns.count) column = 0;
    }
  }
}

std::vector<double> Smear::room() const {
  std::array<std::vector<double>, 2> left;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const double centre : grid_.centres(axis)) {
      const double low = std::max(centre - 0.5 * grid_.cell, between_[axis].low);
      const double high = std::min(centre + 0.5 * grid_.cell, between_[axis].high);
      left[axis].push_back(std::clamp((high - low) / grid_.cell, 0.0, 1.0));
    }
  }
  std::vector<double> room;
  room.reserve(seen_.size());
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const double seen = std::popcount(seen_[k]) / 16.0;
    room.push_back(seen * left[0][k % left[0].size()] * left[1][k / left[0].size()]);
  }
  return room;
}

long Smear::cell_at(double place, std::size_t axis) const {
  return static_cast<long>(std::floor((place - grid_.axis[axis].origin) / grid_.cell));
}

std::size_t Smear::cell_of(std::size_t row, std::size_t column) const {
  const long columns = grid_.axis[0].count;
  long place = first_[0] + static_cast<long>(column);
  if (grid_.axis[0].wraps) place = ((place % columns) + columns) % columns;
  return static_cast<std::size_t>((first_[1] + static_cast<long>(row)) * columns + place);
}

Vec<2> Smear::centre_of(std::size_t row, std::size_t column) const {
  const auto place = [&](std::size_t axis, std::size_t k) {
    return grid_.axis[axis].origin + (static_cast<double>(first_[axis] + static_cast<long>(k)) + 0.5) * grid_.cell;
  };
  return {{place(0, column), place(1, row)}};
}

/// Sets the weights of the cells around a line to zero.
void Smear::open(const Vec<2>& start, const Vec<2>& end) {
  for (int k = 0; k < 2; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    first_[axis] = cell_at(std::min(start[k], end[k]) - reach * width_, axis);
    long last = cell_at(std::max(start[k], end[k]) + reach * width_, axis);
    if (!grid_.axis[axis].wraps) {  // rounding may reach past the outermost cell
      first_[axis] = std::max(first_[axis], 0L);
      last = std::min(last, grid_.axis[axis].count - 1);
    }
    count_[axis] = static_cast<std::size_t>(last - first_[axis] + 1);
    along_[axis].resize(count_[axis]);
  }
  weights_.assign(count_[0] * count_[1], 0.0);
}

void Smear::spread(const Vec<2>& point, double weight) {
  for (int k = 0; k < 2; ++k) spread_along(static_cast<std::size_t>(k), point[k]);
  for (std::size_t row = 0; row < count_[1]; ++row) {
    const double factor = weight * along_[1][row];
    double* sum = weights_.data() + row * count_[0];
    for (std::size_t k = 0; k < count_[0]; ++k) sum[k] += factor * along_[0][k];
  }
}

/// The part of a Gaussian about `place` that lies in each cell along an axis, between planes.
void Smear::spread_along(std::size_t axis, double place) {
  const double scale = std::numbers::sqrt2 * width_;
  const double start = grid_.axis[axis].origin + static_cast<double>(first_[axis]) * grid_.cell - place;
  const double end = start + static_cast<double>(count_[axis]) * grid_.cell;
  double low = between_[axis].low - place;
  double high = between_[axis].high - place;
  double divisor = 1.0;
  if (low > start || high < end) {
    divisor = 0.5 * (std::erf(std::min(high, end) / scale) - std::erf(std::max(low, start) / scale));
    if (!(divisor > least_visible)) {
      divisor = 1.0;
      low = start;
      high = end;
    }
  }
  const auto edge = [&](double at) { return std::erf(std::max(low, std::min(high, at)) / scale); };
  double below = edge(start);
  for (std::size_t j = 0; j < count_[axis]; ++j) {
    const double upto = edge(start + static_cast<double>(j + 1) * grid_.cell);
    along_[axis][j] = 0.5 * (upto - below) / divisor;
    below = upto;
  }
}

/// Which of the sixteen points of a cell the eye sees, as bits; one point stands for all in cells away from walls.
unsigned Smear::visible_points(const Vec<2>& from_eye, const Vec<2>& eye, const std::vector<FlatWall>& planes,
                               const std::vector<PieceOfWall>& pieces) const {
  const auto is_visible = [&](const Vec<2>& point) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const auto& plane) { return dot(eye + point - plane.point, plane.normal) >= 0.0; }) &&
           std::none_of(pieces.begin(), pieces.end(), [&](const auto& piece) { return hides(piece, point); });
  };
  const double corner = std::numbers::sqrt2 * 0.5 * grid_.cell;
  const bool cut = std::any_of(planes.begin(), planes.end(),
                               [&](const auto& plane) {
                                 return std::fabs(dot(eye + from_eye - plane.point, plane.normal)) < corner;
                               }) ||
                   std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
                     return distance_to({piece.from - from_eye, piece.to - from_eye}) < corner;
                   });
  if (!cut) return is_visible(from_eye) ? whole_cell : 0U;
  unsigned points = 0;
  for (int k = 0; k < points_across * points_across; ++k) {
    const auto off = [&](int number) { return ((number + 0.5) / points_across - 0.5) * grid_.cell; };
    if (is_visible(from_eye + Vec<2>{{off(k % points_across), off(k / points_across)}})) points |= 1U << k;
  }
  return points;
}

void Smear::keep_visible(const Vec<2>& eye) {
  Vec<2> farthest{};
  for (int k = 0; k < 2; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    const double low = grid_.axis[axis].origin + static_cast<double>(first_[axis]) * grid_.cell;
    const double high = low + static_cast<double>(count_[axis]) * grid_.cell;
    farthest[k] = std::max(std::fabs(low - eye[k]), std::fabs(high - eye[k]));
  }
  const double reached = magnitude(farthest);
  const auto pieces = pieces_near(eye, pieces_, box_, 1.0, reached);
  std::vector<FlatWall> planes;
  for (const auto& plane : planes_) {
    const double height = dot(eye - plane.point, plane.normal);
    if (height >= 0.0 && height < reached) planes.push_back(plane);
  }
  if (pieces.empty() && planes.empty()) {
    for_each([&](std::size_t cell, double, const Vec<2>&) { seen_[cell] = whole_cell; });
    return;
  }
  visible_ = weights_;
  double sum = 0.0;
  std::vector<std::pair<std::size_t, std::uint16_t>> seen;
  for (std::size_t row = 0; row < count_[1]; ++row) {
    for (std::size_t column = 0; column < count_[0]; ++column) {
      auto& weight = visible_[row * count_[0] + column];
      if (!(weight > 0.0)) continue;
      const auto points = visible_points(centre_of(row, column) - eye, eye, planes, pieces);
      weight *= std::popcount(points) / 16.0;
      sum += weight;
      seen.emplace_back(cell_of(row, column), static_cast<std::uint16_t>(points));
    }
  }
  const bool enough = sum > least_visible;
  for (const auto& [cell, points] : seen) {
    seen_[cell] = static_cast<std::uint16_t>(seen_[cell] | (enough ? points : whole_cell));
  }
  if (!enough) return;
  for (auto& weight : visible_) weight *= 1.0 / sum;
  weights_.swap(visible_);
}

}  // namespace repose
