// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pipe.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/analysis/solid_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace repose {

namespace {

struct Disc {
  double x, y, radius, mass;  // y above the floor
  std::int64_t id;
};

/// The discs of the column, from the lowest centre up.
std::vector<Disc> column_discs(const Pipe& pipe, const Grains<2>& grains, const Contacts<2>& contacts) {
  const auto touching = supported(grains, contacts);
  std::vector<Disc> discs;
  double top = 0.0;  // of the discs that touch something
  const auto add = [&](bool that_touch) {
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const auto& grain = grains.line[k];
      const double x = grain.position[0];
      const double y = grain.position[1] - pipe.floor;
      if (touching[k] != that_touch || grain.fixed()) continue;
      if (!(x > pipe.left && x < pipe.right && y >= 0.0)) continue;
      if (that_touch) {
        top = std::max(top, y + grain.radius);
      } else if (!(y - grain.radius < top)) {
        continue;  // falls towards the column
      }
      discs.push_back({x, y, grain.radius, grain.mass, grains.id[k]});
    }
  };
  add(true);
  add(false);
  std::sort(discs.begin(), discs.end(),
            [](const Disc& a, const Disc& b) { return a.y != b.y ? a.y < b.y : a.id < b.id; });
  return discs;
}

/// Disc area below a level, and the level below which there is a given area.
class AreaBelow {
 public:
  explicit AreaBelow(const std::vector<Disc>& discs) : discs_(discs) {
    sums_.push_back(0.0);
    for (const auto& disc : discs) {
      sums_.push_back(sums_.back() + std::numbers::pi * disc.radius * disc.radius);
      largest_ = std::max(largest_, disc.radius);
      top_ = std::max(top_, disc.y + disc.radius);
    }
  }

  double all() const { return sums_.back(); }
  double top() const { return top_; }

  double operator()(double level) const {
    const auto first = std::lower_bound(discs_.begin(), discs_.end(), level - largest_,
                                        [](const Disc& disc, double y) { return disc.y < y; });
    double area = sums_[static_cast<std::size_t>(first - discs_.begin())];
    for (auto disc = first; disc != discs_.end() && disc->y < level + largest_; ++disc) {
      area += disc_area_below(disc->radius, level - disc->y);
    }
    return area;
  }

  /// By bisection, to the last bits.
  double level_of(double area, double low) const {
    double high = top_;
    for (int step = 0; step < most_steps && high - low > rounding * top_; ++step) {
      const double middle = 0.5 * (low + high);
      ((*this)(middle) < area ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  static constexpr int most_steps = 60;
  static constexpr double rounding = 1e-13;

  const std::vector<Disc>& discs_;
  std::vector<double> sums_;  // area of the first k discs
  double largest_ = 0.0;      // radius
  double top_ = 0.0;
};

/// The mean height of the highest discs in strips of the width of a mean disc.
double surface_height(const Pipe& pipe, const std::vector<Disc>& discs) {
  double sum = 0.0;
  for (const auto& disc : discs) sum += 2.0 * disc.radius;
  const double mean_diameter = sum / static_cast<double>(discs.size());
  const auto strips = std::max<std::size_t>(1, static_cast<std::size_t>(pipe.width() / mean_diameter));
  std::vector<double> highest(strips, 0.0);
  for (const auto& disc : discs) {
    const double place = (disc.x - pipe.left) / pipe.width() * static_cast<double>(strips);
    auto& top = highest[std::min(strips - 1, static_cast<std::size_t>(place))];
    top = std::max(top, disc.y + disc.radius);
  }
  double height = 0.0;
  for (const double top : highest) height += top / static_cast<double>(strips);
  return height;
}

/// Adds the forces of the contacts to the slices: `slice` gives that of each grain of the column by its id.
void add_forces(const Pipe& pipe, const Contacts<2>& contacts,
                const std::unordered_map<std::int64_t, std::size_t>& slice, std::vector<ColumnSlice>& slices) {
  const auto slice_of = [&](std::int64_t partner) {
    const auto found = slice.find(partner);
    return found == slice.end() ? -1L : static_cast<long>(found->second);
  };
  for (const auto& contact : contacts.list) {
    const auto first = slice_of(contact.first);
    const auto second = slice_of(contact.second);
    const bool at_side =
        contact.second == wall_partner(pipe.left_wall) || contact.second == wall_partner(pipe.right_wall);
    const double upwards = force_of(contact)[1];  // on the first
    if (at_side) {
      if (first < 0) continue;
      slices[static_cast<std::size_t>(first)].pressure += contact.normal_force;
      slices[static_cast<std::size_t>(first)].shear += upwards;
      continue;
    }
    // Through every level between the two centres; partners outside the column are below all of it.
    const double on_upper = first > second ? upwards : -upwards;
    for (auto level = std::min(first, second) + 1; level <= std::max(first, second); ++level) {
      slices[static_cast<std::size_t>(level)].load += on_upper;
    }
  }
}

}  // namespace

MeasuredColumn measure_column(const Pipe& pipe, const Grains<2>& grains, const Contacts<2>& contacts,
                              std::size_t slices) {
  MeasuredColumn measured;
  measured.slices.resize(slices);
  measured.row.solid_fraction = std::numeric_limits<double>::quiet_NaN();
  const auto discs = column_discs(pipe, grains, contacts);
  if (discs.empty()) return measured;
  const AreaBelow area(discs);
  double level = 0.0;
  for (std::size_t k = 0; k < slices; ++k) {
    const double part = static_cast<double>(k + 1) / static_cast<double>(slices);
    level = k + 1 == slices ? area.top() : area.level_of(part * area.all(), level);
    measured.slices[k].top = level;
  }
  std::unordered_map<std::int64_t, std::size_t> slice;
  double mass = 0.0;
  std::size_t k = 0;
  for (const auto& disc : discs) {
    while (k + 1 < slices && disc.y >= measured.slices[k].top) ++k;
    slice.emplace(disc.id, k);
    measured.slices[k].mass += disc.mass;
    measured.row.centre += disc.mass * disc.y;
    mass += disc.mass;
  }
  measured.row.centre /= mass;
  measured.row.height = surface_height(pipe, discs);
  const auto tenth = std::max<std::size_t>(1, (slices + 5) / 10);
  if (slices > 2 * tenth) {
    const double between = measured.slices[slices - tenth - 1].top - measured.slices[tenth - 1].top;
    const double part = static_cast<double>(slices - 2 * tenth) / static_cast<double>(slices);
    measured.row.solid_fraction = part * area.all() / (between * pipe.width());
  }
  add_forces(pipe, contacts, slice, measured.slices);
  for (std::size_t s = 0; s < slices; ++s) {
    const double both = 2.0 * (measured.slices[s].top - (s > 0 ? measured.slices[s - 1].top : 0.0));
    measured.slices[s].pressure /= both;
    measured.slices[s].shear /= both;
  }
  return measured;
}

}  // namespace repose
