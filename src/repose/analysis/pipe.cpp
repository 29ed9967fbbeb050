// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/pipe.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/analysis/solid_fraction.hpp"
#include "repose/analysis/sphere_packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace repose {

namespace {

template <int D>
struct Ball {
  Vec<D> position;
  double y, radius, mass;  // y above the floor
  std::int64_t id;
};

double area_of(const Ball<2>& disc) { return std::numbers::pi * disc.radius * disc.radius; }
double area_of(const Ball<3>& sphere) { return sphere_volume_below(sphere.radius, sphere.radius); }
double area_below(const Ball<2>& disc, double height) { return disc_area_below(disc.radius, height); }
double area_below(const Ball<3>& sphere, double height) { return sphere_volume_below(sphere.radius, height); }

bool between_walls(const Pipe& pipe, const Vec<2>& position) {
  return position[0] > pipe.left && position[0] < pipe.right;
}
bool between_walls(const CylinderPipe& pipe, const Vec<3>& position) {
  return magnitude(Vec<2>{{position[0], position[1]}} - pipe.axis) < pipe.radius;
}
bool is_side(const Pipe& pipe, std::int64_t partner) {
  return partner == wall_partner(pipe.left_wall) || partner == wall_partner(pipe.right_wall);
}
bool is_side(const CylinderPipe& pipe, std::int64_t partner) { return partner == wall_partner(pipe.wall); }

/// The discs of the column, from the lowest centre up.
template <int D, class Vessel>
std::vector<Ball<D>> column_discs(const Vessel& pipe, const Grains<D>& grains, const Contacts<D>& contacts) {
  const auto touching = supported(grains, contacts);
  std::vector<Ball<D>> discs;
  double top = 0.0;  // of the discs that touch something
  const auto add = [&](bool that_touch) {
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const auto& grain = grains.line[k];
      const double y = grain.position[up<D>] - pipe.floor;
      if (touching[k] != that_touch || grain.fixed()) continue;
      if (!(between_walls(pipe, grain.position) && y >= 0.0)) continue;
      if (that_touch) {
        top = std::max(top, y + grain.radius);
      } else if (!(y - grain.radius < top)) {
        continue;  // falls towards the column
      }
      discs.push_back({grain.position, y, grain.radius, grain.mass, grains.id[k]});
    }
  };
  add(true);
  add(false);
  std::sort(discs.begin(), discs.end(),
            [](const auto& a, const auto& b) { return a.y != b.y ? a.y < b.y : a.id < b.id; });
  return discs;
}

/// Disc area, in 3D sphere volume, below a level, and the level below which there is a given area.
template <int D>
class AreaBelow {
 public:
  explicit AreaBelow(const std::vector<Ball<D>>& discs) : discs_(discs) {
    sums_.push_back(0.0);
    for (const auto& disc : discs) {
      sums_.push_back(sums_.back() + area_of(disc));
      largest_ = std::max(largest_, disc.radius);
      top_ = std::max(top_, disc.y + disc.radius);
    }
  }

  double all() const { return sums_.back(); }
  double top() const { return top_; }

  double operator()(double level) const {
    const auto first = std::lower_bound(discs_.begin(), discs_.end(), level - largest_,
                                        [](const Ball<D>& disc, double y) { return disc.y < y; });
    double area = sums_[static_cast<std::size_t>(first - discs_.begin())];
    for (auto disc = first; disc != discs_.end() && disc->y < level + largest_; ++disc) {
      area += area_below(*disc, level - disc->y);
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

  const std::vector<Ball<D>>& discs_;
  std::vector<double> sums_;  // area of the first k discs
  double largest_ = 0.0;      // radius
  double top_ = 0.0;
};

template <int D>
double mean_diameter_of(const std::vector<Ball<D>>& discs) {
  double sum = 0.0;
  for (const auto& disc : discs) sum += 2.0 * disc.radius;
  return sum / static_cast<double>(discs.size());
}

/// The mean height of the highest discs in strips of the width of a mean disc.
double surface_height(const Pipe& pipe, const std::vector<Ball<2>>& discs) {
  const double mean_diameter = mean_diameter_of(discs);
  const auto strips = std::max<std::size_t>(1, static_cast<std::size_t>(pipe.width() / mean_diameter));
  std::vector<double> highest(strips, 0.0);
  for (const auto& disc : discs) {
    const double place = (disc.position[0] - pipe.left) / pipe.width() * static_cast<double>(strips);
    auto& top = highest[std::min(strips - 1, static_cast<std::size_t>(place))];
    top = std::max(top, disc.y + disc.radius);
  }
  double height = 0.0;
  for (const double top : highest) height += top / static_cast<double>(strips);
  return height;
}

/// The mean height of the highest spheres in patches of equal area, about as wide as a mean sphere: rings about the
/// axis cut along the azimuth, or a single patch in a pipe narrower than two spheres. A patch without a sphere has the
/// height 0 of the floor.
double surface_height(const CylinderPipe& pipe, const std::vector<Ball<3>>& spheres) {
  const double diameter = mean_diameter_of(spheres);
  if (pipe.radius < diameter) {
    double top = 0.0;
    for (const auto& sphere : spheres) top = std::max(top, sphere.y + sphere.radius);
    return top;
  }
  const auto rings = static_cast<std::size_t>(pipe.radius / diameter);
  std::vector<double> highest(3 * rings * rings, 0.0);  // ring k has 3 (2 k + 1) patches, from patch 3 k^2 on
  for (const auto& sphere : spheres) {
    const double x = sphere.position[0] - pipe.axis[0];
    const double y = sphere.position[1] - pipe.axis[1];
    const double place = std::hypot(x, y) / pipe.radius * static_cast<double>(rings);
    const auto ring = std::min(rings - 1, static_cast<std::size_t>(place));
    const double turn = 0.5 + std::atan2(y, x) / (2.0 * std::numbers::pi);
    const std::size_t patches = 3 * (2 * ring + 1);
    const auto patch = std::min(patches - 1, static_cast<std::size_t>(turn * static_cast<double>(patches)));
    auto& top = highest[3 * ring * ring + patch];
    top = std::max(top, sphere.y + sphere.radius);
  }
  double height = 0.0;
  for (const double top : highest) height += top / static_cast<double>(highest.size());
  return height;
}

/// Adds the forces of the contacts to the slices: `slice` gives that of each grain of the column by its id.
template <int D, class Vessel>
void add_forces(const Vessel& pipe, const Contacts<D>& contacts,
                const std::unordered_map<std::int64_t, std::size_t>& slice, std::vector<ColumnSlice>& slices) {
  const auto slice_of = [&](std::int64_t partner) {
    const auto found = slice.find(partner);
    return found == slice.end() ? -1L : static_cast<long>(found->second);
  };
  for (const auto& contact : contacts.list) {
    const auto first = slice_of(contact.first);
    const auto second = slice_of(contact.second);
    const bool at_side = is_side(pipe, contact.second);
    const double upwards = force_of(contact)[up<D>];  // on the first
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

template <int D, class Vessel>
MeasuredColumn measure(const Vessel& pipe, const Grains<D>& grains, const Contacts<D>& contacts, std::size_t slices) {
  MeasuredColumn measured;
  measured.slices.resize(slices);
  measured.row.solid_fraction = std::numeric_limits<double>::quiet_NaN();
  const auto discs = column_discs(pipe, grains, contacts);
  if (discs.empty()) return measured;
  const AreaBelow<D> area(discs);
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
    measured.row.solid_fraction = part * area.all() / (between * pipe.cross_section());
  }
  add_forces(pipe, contacts, slice, measured.slices);
  for (std::size_t s = 0; s < slices; ++s) {
    const double all_walls = pipe.perimeter() * (measured.slices[s].top - (s > 0 ? measured.slices[s - 1].top : 0.0));
    measured.slices[s].pressure /= all_walls;
    measured.slices[s].shear /= all_walls;
  }
  return measured;
}

}  // namespace

MeasuredColumn measure_column(const Pipe& pipe, const Grains<2>& grains, const Contacts<2>& contacts,
                              std::size_t slices) {
  return measure(pipe, grains, contacts, slices);
}

MeasuredColumn measure_column(const CylinderPipe& pipe, const Grains<3>& grains, const Contacts<3>& contacts,
                              std::size_t slices) {
  return measure(pipe, grains, contacts, slices);
}

}  // namespace repose
