// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"

#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace repose {

namespace {

constexpr double reach = 8.5;  // standard deviations
constexpr double most_cells = 4e6;

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

/// A contact of the heap: a force and the branch that it acts along.
struct Branch {
  Vec<2> start{};   // [L]
  Vec<2> branch{};  // [L] from `start` to the centre of the grain on which the force acts
  Vec<2> force{};   // [M L/T^2]
  bool support = false;
};

/// The contacts of the heap, in the order of the list.
std::vector<Branch> find_branches(const OrderedGrains<2>& grains, const Contacts<2>& contacts,
                                  const std::vector<bool>& in_heap, const Box<2>& box) {
  std::vector<Branch> branches;
  for (const auto& contact : contacts.list) {
    const auto first = grains.find(contact.first).value();
    const Vec<2>& at_first = grains->line[first].position;
    const Vec<2> force = force_of(contact);
    if (contact.second < 0) {
      const Vec<2> branch = contact.normal * contact.first_lever;
      if (in_heap[first]) branches.push_back({at_first - branch, branch, force, true});
      continue;
    }
    const auto second = grains.find(contact.second).value();
    const Vec<2>& at_second = grains->line[second].position;
    const Vec<2> between = separation(at_first, at_second, box);
    const Vec<2> lever = contact.normal * contact.first_lever;
    if (in_heap[first] && in_heap[second]) {
      branches.push_back({at_first - between, between, force, false});
    } else if (in_heap[first]) {
      branches.push_back({at_first - lever, lever, force, true});
    } else if (in_heap[second]) {
      branches.push_back({at_second + (between - lever), lever - between, -force, true});
    }
  }
  return branches;
}

/// The cells along one axis.
struct Axis {
  double origin = 0.0;  // [L] lower edge of cell 0
  long count = 0;
  bool wraps = false;
};

struct Grid {
  double cell = 0.0;
  std::array<Axis, 2> axis{};

  double cells() const { return static_cast<double>(axis[0].count) * static_cast<double>(axis[1].count); }
};

/// A grid with cells of about `cell` [L] that covers the points from `low` to `high` and a margin of `reach`.
Grid make_grid(const Vec<2>& low, const Vec<2>& high, const Box<2>& box, double width, double cell) {
  Grid grid;
  grid.cell = cell;
  if (box.periodic) {
    const double columns = std::max(1.0, std::ceil(box.width() / cell * (1.0 - 1e-12)));
    grid.cell = box.width() / columns;
    grid.axis[0] = {box.x_min, static_cast<long>(columns), true};
  }
  for (int k = box.periodic ? 1 : 0; k < 2; ++k) {
    const double first = std::floor((low[k] - reach * width) / grid.cell);
    const double last = std::floor((high[k] + reach * width) / grid.cell);
    grid.axis[static_cast<std::size_t>(k)] = {first * grid.cell, static_cast<long>(last - first) + 1, false};
  }
  return grid;
}

/// The weights that a Gaussian, at a point or averaged along a line, has in the cells near it. They sum to one.
class Smear {
 public:
  Smear(const Grid& grid, double width) : grid_(grid), width_(width) {}

  void at(const Vec<2>& point) {
    open(point, point);
    spread(point, 1.0);
  }

  void along(const Vec<2>& start, const Vec<2>& branch) {
    open(start, start + branch);
    const double intervals = std::max(1.0, std::ceil(magnitude(branch) / width_));
    for (double interval = 0.0; interval < intervals; interval += 1.0) {
      for (std::size_t k = 0; k < quadrature_.place.size(); ++k)
        spread(start + branch * ((interval + quadrature_.place[k]) / intervals), quadrature_.weight[k] / intervals);
    }
  }

  /// Adds `total` times the weights to a field, as a density.
  void add(std::vector<double>& field, double total) const {
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

 private:
  long cell_at(double place, std::size_t axis) const {
    return static_cast<long>(std::floor((place - grid_.axis[axis].origin) / grid_.cell));
  }

  /// Sets the weights of the cells around a line to zero.
  void open(const Vec<2>& start, const Vec<2>& end) {
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

  void spread(const Vec<2>& point, double weight) {
    for (int k = 0; k < 2; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const double scale = std::numbers::sqrt2 * width_;
      const double start = grid_.axis[axis].origin + static_cast<double>(first_[axis]) * grid_.cell - point[k];
      double below = std::erf(start / scale);
      for (std::size_t j = 0; j < count_[axis]; ++j) {
        const double upto = std::erf((start + static_cast<double>(j + 1) * grid_.cell) / scale);
        along_[axis][j] = 0.5 * (upto - below);
        below = upto;
      }
    }
    for (std::size_t row = 0; row < count_[1]; ++row) {
      const double factor = weight * along_[1][row];
      double* sum = weights_.data() + row * count_[0];
      for (std::size_t k = 0; k < count_[0]; ++k) sum[k] += factor * along_[0][k];
    }
  }

  Grid grid_;
  double width_;
  Quadrature quadrature_;
  std::array<long, 2> first_{};  // first cell; on a wrapping axis, before wrapping
  std::array<std::size_t, 2> count_{};
  std::array<std::vector<double>, 2> along_;
  std::vector<double> weights_;
};

std::vector<double> centres(const Axis& axis, double cell) {
  std::vector<double> values;
  for (long k = 0; k < axis.count; ++k) values.push_back(axis.origin + (static_cast<double>(k) + 0.5) * cell);
  return values;
}

}  // namespace

Fields coarse_grained(const OrderedGrains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, double width) {
  REPOSE_ASSERT(width > 0.0 && in_heap.size() == grains.size());
  Fields fields;
  fields.width = width;
  fields.cell = 0.5 * width;
  const auto branches = find_branches(grains, contacts, in_heap, box);
  std::vector<Vec<2>> points;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (in_heap[k]) points.push_back(grains->line[k].position);
  if (points.empty()) return fields;
  for (const auto& branch : branches) {
    points.push_back(branch.start);
    points.push_back(branch.start + branch.branch);
  }
  Vec<2> low = points.front();
  Vec<2> high = low;
  for (const auto& point : points) {
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }

  // Cells are no wider than a periodic box, so a grain far above would need too many of them.
  if (box.periodic && high[1] - low[1] + 2.0 * reach * width > 0.5 * most_cells * box.width()) return fields;
  Grid grid = make_grid(low, high, box, width, fields.cell);
  for (double cell = fields.cell; grid.cells() > most_cells; grid = make_grid(low, high, box, width, cell))
    cell *= 1.25;
  fields.cell = grid.cell;
  fields.x = centres(grid.axis[0], grid.cell);
  fields.y = centres(grid.axis[1], grid.cell);
  const auto cells = fields.x.size() * fields.y.size();
  fields.density.assign(cells, 0.0);
  fields.solid_fraction.assign(cells, 0.0);
  for (auto& component : fields.stress) component.assign(cells, 0.0);
  for (auto& component : fields.support) component.assign(cells, 0.0);

  Smear smear(grid, width);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    const auto& grain = grains->line[k];
    smear.at(grain.position);
    smear.add(fields.density, grain.mass);
    smear.add(fields.solid_fraction, std::numbers::pi * squared(grain.radius));
  }
  for (const auto& contact : branches) {
    smear.along(contact.start, contact.branch);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        smear.add(fields.stress[static_cast<std::size_t>(2 * a + b)], contact.force[a] * contact.branch[b]);
    if (!contact.support) continue;
    smear.at(contact.start);
    for (int a = 0; a < 2; ++a) smear.add(fields.support[static_cast<std::size_t>(a)], contact.force[a]);
  }
  return fields;
}

}  // namespace repose
