// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/neighbours/pair_list.hpp"

#include "repose/neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

template <int D>
double largest_radius(const Grains<D>& grains) {
  double largest = 0.0;
  for (const auto& grain : grains.line) largest = std::max(largest, grain.radius);
  return largest;
}

/// A few lines of cells.
struct Lines {
  std::array<int, 9> line{};
  std::size_t count = 0;
  void add(int number) { line[count++] = number; }
  const int* begin() const { return line.data(); }
  const int* end() const { return line.data() + count; }
};

/// The neighbouring lines of cells whose grains come later in memory than those of the line through `cell`, ascending.
template <int D>
Lines later_lines(const CellGrid<D>& grid, const std::array<int, D>& cell, bool periodic) {
  Lines lines;
  const auto add_neighbours = [&](int x, int lowest_y) {
    if constexpr (D == 2) {
      if (lowest_y <= 0) lines.add(x);
    } else {
      const int last = std::min(grid.count(1) - 1, cell[1] + 1);
      for (int y = std::max(0, cell[1] + lowest_y); y <= last; ++y) lines.add(x * grid.count(1) + y);
    }
  };
  add_neighbours(cell[0], 1);
  if (cell[0] + 1 < grid.count(0)) add_neighbours(cell[0] + 1, -1);
  if (periodic && cell[0] == 0 && grid.count(0) > 2) add_neighbours(grid.count(0) - 1, -1);
  return lines;
}

/// The index in the old list of the pair (i, j), given by indices in the old order; `none` if it was not listed.
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
std::uint32_t old_place(const std::vector<std::uint32_t>& row_start, const std::vector<std::uint32_t>& partner,
                        std::uint32_t i, std::uint32_t j) {
  const auto low = std::min(i, j);
  const auto high = std::max(i, j);
  if (low + 1 >= row_start.size()) return none;
  for (auto k = row_start[low]; k < row_start[low + 1]; ++k) {
    if (partner[k] == high) return k;
  }
  return none;
}

}  // namespace

/// Returns the largest extra allowance of a fast grain [L].
template <int D>
double PairList<D>::set_allowances(const Grains<D>& grains) {
  const double half_skin = 0.5 * reach_.skin;
  const double furthest = 4.0 * largest_radius(grains);
  const double fall = 0.5 * reach_.gravity * reach_.horizon * reach_.horizon;
  allowance_.assign(grains.size(), half_skin);
  built_at_.resize(grains.size());
  std::size_t fast = 0;
  double largest = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    built_at_[k] = grain.position;
    const double travel = std::sqrt(dot(grain.velocity, grain.velocity)) * reach_.horizon + fall;
    if (grain.fixed() || travel <= half_skin) continue;
    ++fast;
    allowance_[k] = half_skin + std::min(travel, furthest);
    largest = std::max(largest, allowance_[k] - half_skin);
  }
  // If many grains are fast, a wider search for each costs more than building the list more often.
  if (fast * 8 > grains.size() && fast > 32) {
    allowance_.assign(grains.size(), half_skin);
    return 0.0;
  }
  return largest;
}

template <int D>
template <class Grid>
void PairList<D>::list_row(const Grains<D>& grains, const Box<D>& box, const Grid& grid, std::uint32_t i,
                           std::vector<std::uint32_t>& row) const {
  const auto& line = grains.line[i];
  const auto cell = grid.cell_of(line.position);
  const auto list = [&](std::uint32_t begin, std::uint32_t end) {
    for (auto j = begin; j < end; ++j) {
      if (line.fixed() && grains.line[j].fixed()) continue;
      const Vec<D> d = separation(line.position, grains.line[j].position, box);
      const double within = listed_within(grains, i, j);
      if (dot(d, d) < within * within) row.push_back(j);
    }
  };
  list(i + 1, grid.places(grid.line_of(cell), cell[D - 1], cell[D - 1] + 1).end);
  for (const int other : later_lines<D>(grid, cell, box.periodic)) {
    const auto places = grid.places(other, cell[D - 1] - 1, cell[D - 1] + 1);
    list(places.begin, places.end);
  }
}

/// Pairs farther apart than the skin that the motion of a fast grain may bring together, ascending, each once.
template <int D>
template <class Grid>
auto PairList<D>::pairs_of_fast_grains(const Grains<D>& grains, const Box<D>& box, const Grid& grid,
                                       double furthest_travel) const -> std::vector<Extra> {
  std::vector<Extra> extras;
  const double half_skin = 0.5 * reach_.skin;
  const double widest = 2.0 * reach_.cutoff * largest_radius(grains) + reach_.skin;
  for (std::uint32_t i = 0; i < grains.size(); ++i) {
    const double travel = allowance_[i] - half_skin;
    if (travel <= 0.0) continue;
    const double range = widest + travel + furthest_travel;
    const auto centre = grid.cell_of(grains.line[i].position);
    std::array<int, D> low{};
    std::array<int, D> high{};
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const int cells = static_cast<int>(std::ceil(range / grid.size(axis)));
      const bool wraps = box.periodic && axis == 0;
      low[a] = wraps ? centre[a] - cells : std::max(0, centre[a] - cells);
      high[a] = wraps ? centre[a] + cells : std::min(grid.count(axis) - 1, centre[a] + cells);
      if (wraps && high[a] - low[a] >= grid.count(axis)) {
        low[a] = 0;
        high[a] = grid.count(axis) - 1;
      }
    }
    const auto search_line = [&](int line) {
      const auto places = grid.places(line, low[D - 1], high[D - 1]);
      for (auto j = places.begin; j < places.end; ++j) {
        const double other = allowance_[j] - half_skin;
        if (j == i || (other > 0.0 && j < i)) continue;
        const Vec<D> d = separation(grains.line[i].position, grains.line[j].position, box);
        const double near = listed_within(grains, i, j);
        const double far_out = near + travel + other;
        const double distance2 = dot(d, d);
        if (distance2 >= near * near && distance2 < far_out * far_out) {
          extras.push_back({std::min(i, j), std::max(i, j)});
        }
      }
    };
    for (int x = low[0]; x <= high[0]; ++x) {
      const int column = ((x % grid.count(0)) + grid.count(0)) % grid.count(0);
      if constexpr (D == 2) {
        search_line(column);
      } else {
        for (int y = low[1]; y <= high[1]; ++y) search_line(column * grid.count(1) + y);
      }
    }
  }
  std::sort(extras.begin(), extras.end(),
            [](const Extra& a, const Extra& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  return extras;
}

template <int D>
std::vector<std::uint32_t> PairList<D>::build(Grains<D>& grains, const Box<D>& box, Team& team) {
  std::vector<std::uint32_t> present;
  std::vector<Vec<D>> positions;
  present.reserve(grains.size());
  positions.reserve(grains.size());
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    auto& grain = grains.line[k];
    if (!grain.fixed() && box.outside(grain.position)) continue;
    grain.position = box.wrapped(grain.position);
    present.push_back(k);
    positions.push_back(grain.position);
  }
  const double cell_size = 2.0 * reach_.cutoff * largest_radius(grains) + reach_.skin;
  const CellGrid<D> grid(positions, box, cell_size);
  std::vector<std::uint32_t> order(present.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = present[grid.order()[k]];
  grains.reorder(order);

  const double furthest_travel = set_allowances(grains);
  std::vector<Extra> extras;
  if (furthest_travel > 0.0) extras = pairs_of_fast_grains(grains, box, grid, furthest_travel);

  const std::vector<std::uint32_t> old_start = std::move(row_start);
  const std::vector<std::uint32_t> old_partner = std::move(partner);
  const std::vector<Tangent<D>> old_slip = std::move(slip);
  const std::vector<Tangent<D>> old_roll = std::move(roll);
  const std::vector<std::uint8_t> old_bonded = std::move(bonded);
  row_start.assign(grains.size() + 1, 0);
  const auto members = static_cast<std::size_t>(team.size());
  std::vector<std::vector<std::uint32_t>> parts(members);
  team.run([&](int member) {
    const Range rows = range_of(grains.size(), member, team.size());
    auto& row = parts[static_cast<std::size_t>(member)];
    row.reserve((rows.end - rows.begin) * 4);
    const auto by_low = [](const Extra& e, std::uint32_t i) { return e.low < i; };
    auto extra = std::lower_bound(extras.begin(), extras.end(), static_cast<std::uint32_t>(rows.begin), by_low);
    for (auto i = static_cast<std::uint32_t>(rows.begin); i < rows.end; ++i) {
      const auto before = static_cast<std::ptrdiff_t>(row.size());
      list_row(grains, box, grid, i, row);
      if (extra != extras.end() && extra->low == i) {
        for (; extra != extras.end() && extra->low == i; ++extra) row.push_back(extra->high);
        std::sort(row.begin() + before, row.end());
      }
      row_start[i + 1] = static_cast<std::uint32_t>(static_cast<std::ptrdiff_t>(row.size()) - before);
    }
  });
  for (std::size_t i = 0; i < grains.size(); ++i) row_start[i + 1] += row_start[i];
  partner.resize(row_start.back());
  slip.resize(row_start.back());
  if (reach_.rolling) roll.resize(row_start.back());
  if (reach_.bonds) bonded.resize(row_start.back());
  std::vector<std::uint32_t> widest(members, 0);
  team.run([&](int member) {
    const Range rows = range_of(grains.size(), member, team.size());
    const auto& part = parts[static_cast<std::size_t>(member)];
    std::copy(part.begin(), part.end(), partner.begin() + row_start[rows.begin]);
    std::uint32_t band = 0;
    for (auto i = static_cast<std::uint32_t>(rows.begin); i < rows.end; ++i) {
      for (auto k = row_start[i]; k < row_start[i + 1]; ++k) {
        const auto was = old_place(old_start, old_partner, order[i], order[partner[k]]);
        const bool turned_round = order[i] > order[partner[k]];
        slip[k] = was == none ? Tangent<D>{} : (turned_round ? swapped(old_slip[was]) : old_slip[was]);
        if (reach_.rolling) roll[k] = was == none ? Tangent<D>{} : (turned_round ? -old_roll[was] : old_roll[was]);
        if (reach_.bonds) bonded[k] = was == none ? std::uint8_t{0} : old_bonded[was];
        if (partner[k] - i <= far) band = std::max(band, partner[k] - i);
      }
    }
    widest[static_cast<std::size_t>(member)] = band;
  });
  bandwidth = *std::max_element(widest.begin(), widest.end());

  valid_ = true;
  travelled_ = 0.0;
  slack_ = 0.5 * reach_.skin;
  ++builds_;
  return order;
}

template <int D>
bool PairList<D>::stale(const Grains<D>& grains, double wall_displacement, double ahead) {
  if (!valid_) return true;
  double least = 0.5 * reach_.skin - wall_displacement;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const Vec<D> d = grains.line[k].position + grains.line[k].velocity * ahead - built_at_[k];
    least = std::min(least, allowance_[k] - std::sqrt(dot(d, d)));
  }
  // With so little left, the next check would come after one step.
  if (least < 0.05 * reach_.skin) return true;
  slack_ = least;
  travelled_ = 0.0;
  return false;
}

template class PairList<2>;
template class PairList<3>;

}  // namespace repose
