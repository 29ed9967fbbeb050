// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/neighbours/pair_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace repose {

namespace {

/// The largest radius of the grains that cells are made for: all but the largest ones, if those are few and at least
/// twice as large as the others. A cell for the largest of a few would hold hundreds of the others.
template <int D>
double usual_radius(const Grains<D>& grains, double smallest, double largest) {
  if (smallest > 0.5 * largest) return largest;
  const std::size_t few = grains.size() / 16;
  for (double radius = largest;;) {
    double next = 0.0;
    std::size_t larger = 0;
    for (const auto& grain : grains.line) {
      if (grain.radius <= 0.5 * radius) {
        next = std::max(next, grain.radius);
      } else {
        ++larger;
      }
    }
    if (larger > few || next == 0.0) return radius;
    radius = next;
  }
}

/// The places of the candidates for partners of a grain, ascending.
template <int D>
struct Candidates {
  using Places = typename CellGrid<D>::Places;
  std::array<Places, 10> range;
  std::size_t ranges = 0;
  std::size_t most = 0;

  void add(const Places& places) {
    if (places.begin >= places.end) return;
    range[ranges++] = places;
    most += places.end - places.begin;
  }
};

/// Appends to `row` the candidates whose spots are near spot i. The loop has no branch, since whether a candidate is
/// near cannot be predicted. Returns the new end of the row.
template <bool Wraps, int D>
std::uint32_t* append_near(const Spots<D>& spots, const Box<D>& box, std::uint32_t i, const Candidates<D>& candidates,
                           std::uint32_t* row) {
  std::array<const double*, D> at;
  std::array<double, D> own;
  for (std::size_t axis = 0; axis < D; ++axis) {
    at[axis] = spots.at[axis].data();
    own[axis] = at[axis][i];
  }
  const double* const range = spots.range.data();
  const double own_range = range[i];
  // Half an endless length on an axis that does not wrap.
  std::array<double, D - 1> length{};
  std::array<double, D - 1> half{};
  for (int axis = 0; axis + 1 < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const bool wraps = D == 2 || wraps_along(box, axis);
    length[a] = wraps ? length_along(box, axis) : 0.0;
    half[a] = wraps ? 0.5 * length[a] : std::numeric_limits<double>::infinity();
  }
  for (std::size_t r = 0; r < candidates.ranges; ++r) {
    for (auto j = candidates.range[r].begin; j < candidates.range[r].end; ++j) {
      double distance2 = 0.0;
      for (std::size_t axis = 0; axis < D; ++axis) {
        double d = own[axis] - at[axis][j];
        if constexpr (Wraps) {
          if (axis + 1 < D) d = d > half[axis] ? d - length[axis] : (d < -half[axis] ? d + length[axis] : d);
        }
        distance2 += d * d;
      }
      const double within = own_range + range[j];
      *row = j;
      row += distance2 < within * within ? 1 : 0;
    }
  }
  return row;
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

/// Drops grains that have left the box, and puts the others into the order of the cells.
template <int D>
void PairList<D>::sort_grains(Grains<D>& grains, const Box<D>& box) {
  present_.clear();
  positions_.clear();
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    auto& grain = grains.line[k];
    if (!grain.fixed() && box.outside(grain.position)) continue;
    grain.position = box.wrapped(grain.position);
    present_.push_back(k);
    positions_.push_back(grain.position);
    smallest = std::min(smallest, grain.radius);
    largest = std::max(largest, grain.radius);
  }
  const double usual = usual_radius(grains, smallest, largest);
  spots_.cell_range = reach_.cutoff * usual + 0.5 * reach_.skin;
  grid_.build(positions_, box, 2.0 * spots_.cell_range);
  order_.resize(present_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = present_[grid_.order()[k]];
  spare_.take(grains, order_);
  grains.swap(spare_);
  note_spots(grains, 4.0 * usual);
  any_large_ = largest > usual;
}

/// Notes where the grains are, and how far each may move. `furthest` [L] is the longest extra allowance of a fast one.
template <int D>
void PairList<D>::note_spots(const Grains<D>& grains, double furthest) {
  const double half_skin = 0.5 * reach_.skin;
  const double fall = 0.5 * reach_.gravity * reach_.horizon * reach_.horizon;
  spots_.resize(grains.size());
  built_at_.resize(grains.size());
  allowance_.resize(grains.size());
  std::size_t fast = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    built_at_[k] = grain.position;
    for (int axis = 0; axis < D; ++axis) spots_.at[static_cast<std::size_t>(axis)][k] = grain.position[axis];
    spots_.range[k] = reach_.cutoff * grain.radius + half_skin;
    spots_.fixed[k] = grain.fixed() ? 1 : 0;
    const double travel = std::sqrt(dot(grain.velocity, grain.velocity)) * reach_.horizon + fall;
    const bool is_fast = !grain.fixed() && travel > half_skin;
    allowance_[k] = is_fast ? half_skin + std::min(travel, furthest) : half_skin;
    fast += is_fast ? 1 : 0;
  }
  // If many grains are fast, a wider search for each costs more than building the list more often.
  any_fast_ = fast > 0 && !(fast * 8 > grains.size() && fast > 32);
  if (!any_fast_ && fast > 0) std::fill(allowance_.begin(), allowance_.end(), half_skin);
}

/// Lists the partners of some rows in `part`, and their numbers in row_start. Grains of a cell have the same
/// candidates.
template <int D>
void PairList<D>::list_rows(const Grains<D>& grains, const Box<D>& box, const Range& rows, Part& part) {
  const auto& wide = wide_.pairs();
  auto extra = std::lower_bound(wide.begin(), wide.end(), rows.begin,
                                [](const auto& pair, std::size_t row) { return pair.low < row; });
  part.pairs = 0;
  if (rows.begin == rows.end) return;
  const auto first_cell = grid_.cell_of(grains.line[rows.begin].position);
  auto i = static_cast<std::uint32_t>(rows.begin);
  int height = first_cell[D - 1];
  for (int line = grid_.line_of(first_cell); i < rows.end; ++line, height = 0) {
    const auto foot = grid_.foot_of(line);
    const auto later = grid_.later_lines(foot, box);
    const auto at_boundary = [&](int axis) {
      const int place = foot[static_cast<std::size_t>(axis)];
      return wraps_along(box, axis) && (place == 0 || place + 1 >= grid_.count(axis) || grid_.count(axis) < 4);
    };
    const bool wraps = at_boundary(0) || (D == 3 && at_boundary(1));
    for (; height < grid_.count(D - 1) && i < rows.end; ++height) {
      const auto cell_end = std::min<std::size_t>(grid_.places(line, height, height).end, rows.end);
      if (i == cell_end) continue;
      Candidates<D> candidates;
      candidates.add({i, grid_.places(line, height, height + 1).end});
      for (const int other : later) candidates.add(grid_.places(other, height - 1, height + 1));
      for (; i < cell_end; ++i) {
        const std::size_t before = part.pairs;
        candidates.range[0].begin = i + 1;
        if (!spots_.large(i)) {
          part.make_room(before + candidates.most);
          auto* const begin = part.partner.data() + before;
          auto* end = wraps ? append_near<true>(spots_, box, i, candidates, begin)
                            : append_near<false>(spots_, box, i, candidates, begin);
          const auto unwanted = [&](std::uint32_t j) { return spots_.large(j) || spots_.both_fixed(i, j); };
          if (spots_.fixed[i] != 0 || any_large_) end = std::remove_if(begin, end, unwanted);
          part.pairs = before + static_cast<std::size_t>(end - begin);
        }
        if (extra != wide.end() && extra->low == i) {
          for (; extra != wide.end() && extra->low == i; ++extra) {
            part.make_room(part.pairs + 1);
            part.partner[part.pairs++] = extra->high;
          }
          std::sort(part.partner.data() + before, part.partner.data() + part.pairs);
        }
        row_start[i + 1] = static_cast<std::uint32_t>(part.pairs - before);
      }
    }
  }
}

/// Gives the pairs of some rows the displacements that they had in the old list.
template <int D>
void PairList<D>::keep_displacements(const Range& rows, Part& part) {
  part.bandwidth = 0;
  for (auto i = static_cast<std::uint32_t>(rows.begin); i < rows.end; ++i) {
    for (auto k = row_start[i]; k < row_start[i + 1]; ++k) {
      const auto j = partner[k];
      const auto was = old_place(old_.row_start, old_.partner, order_[i], order_[j]);
      const bool turned_round = order_[i] > order_[j];
      if (reach_.twisting) twist[k] = was == none ? 0.0 : old_.twist[was];  // of either order
      slip[k] = was == none ? Tangent<D>{} : (turned_round ? swapped(old_.slip[was]) : old_.slip[was]);
      if (reach_.rolling) roll[k] = was == none ? Tangent<D>{} : (turned_round ? -old_.roll[was] : old_.roll[was]);
      if (reach_.bonds) bonded[k] = was == none ? std::uint8_t{0} : old_.bonded[was];
      if (j - i <= far) part.bandwidth = std::max(part.bandwidth, j - i);
    }
  }
}

template <int D>
const std::vector<std::uint32_t>& PairList<D>::build(Grains<D>& grains, const Box<D>& box, Team& team) {
  sort_grains(grains, box);
  wide_.clear();
  if (any_fast_ || any_large_) wide_.find(spots_, allowance_, 0.5 * reach_.skin, grid_, box);

  old_.row_start.swap(row_start);
  old_.partner.swap(partner);
  old_.slip.swap(slip);
  old_.roll.swap(roll);
  old_.twist.swap(twist);
  old_.bonded.swap(bonded);
  row_start.resize(grains.size() + 1);
  row_start[0] = 0;
  parts_.resize(static_cast<std::size_t>(team.size()));
  team.run([&](int member) {
    list_rows(grains, box, range_of(grains.size(), member, team.size()), parts_[static_cast<std::size_t>(member)]);
  });
  for (std::size_t i = 0; i < grains.size(); ++i) row_start[i + 1] += row_start[i];
  const std::size_t pairs = row_start.back();
  partner.resize(pairs);
  slip.resize(pairs);
  if (reach_.rolling) roll.resize(pairs);
  if (reach_.twisting) twist.resize(pairs);
  if (reach_.bonds) bonded.resize(pairs);
  team.run([&](int member) {
    const Range rows = range_of(grains.size(), member, team.size());
    auto& part = parts_[static_cast<std::size_t>(member)];
    std::copy_n(part.partner.begin(), part.pairs, partner.begin() + row_start[rows.begin]);
    keep_displacements(rows, part);
  });
  bandwidth = 0;
  for (const auto& part : parts_) bandwidth = std::max(bandwidth, part.bandwidth);
  any_far = has_far_pairs();

  valid_ = true;
  travelled_ = 0.0;
  slack_ = 0.5 * reach_.skin;
  ++builds_;
  return order_;
}

template <int D>
bool PairList<D>::stale(const Grains<D>& grains, double wall_displacement, double ahead) {
  const auto then = [&](std::size_t k) { return grains.line[k].position + grains.line[k].velocity * ahead; };
  return stale_at(then, wall_displacement);
}

template class PairList<2>;
template class PairList<3>;

}  // namespace repose
