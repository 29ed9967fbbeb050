// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/axial_fields.hpp"

#include "repose/analysis/sphere_columns.hpp"
#include "repose/analysis/sphere_packing.hpp"
#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr double most_cells = 4e6;
constexpr double straight = 1e-12;  // [lengths of a branch]
constexpr double inwards = 1e-9;    // [branches] of a support, so that rounding does not put it beyond the floor

enum Component : std::size_t { rr, tt, zz, rz, zr };

/// The line along which a force acts, relative to the axis and the base.
struct Branch {
  Vec<3> start{};
  Vec<3> along{};
  Vec<3> force{};
};

/// A force on the heap from outside it.
struct Support {
  Vec<3> point{};
  Vec<3> force{};
};

struct Sources {
  std::vector<std::size_t> grains;  // places of those in the heap
  std::vector<Branch> branches;
  std::vector<Support> supports;
};

double radius_of(const Vec<3>& point) { return std::hypot(point[0], point[1]); }

Sources find_sources(const OrderedGrains<3>& grains, const Contacts<3>& contacts, const std::vector<bool>& in_heap,
                     const Box<3>& box, const Vec<3>& origin) {
  Sources sources;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) sources.grains.push_back(k);
  }
  for (const auto& contact : contacts.list) {
    const auto first = grains.find(contact.first).value();
    const Vec<3> force = force_of(contact);
    const Vec<3> lever = contact.normal * contact.first_lever;  // from the contact point to the first
    const Vec<3> to_first = grains->line[first].position - origin;
    if (contact.second < 0) {
      if (!in_heap[first]) continue;
      sources.branches.push_back({to_first - lever, lever, force});
      sources.supports.push_back({to_first - lever * (1.0 - inwards), force});
      continue;
    }
    const auto second = grains.find(contact.second).value();
    const Vec<3> branch = separation(grains->line[first].position, grains->line[second].position, box);
    if (in_heap[first] && in_heap[second]) {
      sources.branches.push_back({to_first - branch, branch, force});
    } else if (in_heap[first]) {
      sources.branches.push_back({to_first - lever, lever, force});
      sources.supports.push_back({to_first - lever * (1.0 - inwards), force});
    } else if (in_heap[second]) {
      const Vec<3> to_second = grains->line[second].position - origin;
      const Vec<3> rest = lever - branch;  // from the contact point to the second
      sources.branches.push_back({to_second - rest, rest, -force});
      sources.supports.push_back({to_second - rest * (1.0 - inwards), -force});
    }
  }
  return sources;
}

/// The grid, and sums over its rings.
class Rings {
 public:
  Rings(double ring, double layer, const OrderedGrains<3>& grains, const Sources& sources, const Vec<3>& origin)
      : ring_(ring), layer_(layer) {
    double farthest = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto reach = [&](const Vec<3>& point, double around) {
      farthest = std::max(farthest, radius_of(point) + around);
      low = std::min(low, point[2] - around);
      high = std::max(high, point[2] + around);
    };
    for (const auto k : sources.grains) reach(grains->line[k].position - origin, grains->line[k].radius);
    for (const auto& branch : sources.branches) {
      reach(branch.start, 0.0);
      reach(branch.start + branch.along, 0.0);
    }
    const double cells = (farthest / ring_ + 1.0) * ((high - low) / layer_ + 2.0);
    if (cells > most_cells) {
      ring_ *= std::sqrt(cells / most_cells);
      layer_ *= std::sqrt(cells / most_cells);
    }
    rings_ = static_cast<long>(farthest / ring_) + 1;
    first_layer_ = static_cast<long>(std::floor(low / layer_));
    layers_ = static_cast<long>(std::floor(high / layer_)) - first_layer_ + 1;
  }

  double ring() const { return ring_; }
  double layer() const { return layer_; }
  long rings() const { return rings_; }
  long first_layer() const { return first_layer_; }
  long layers() const { return layers_; }

  long ring_at(double radius) const { return std::clamp(static_cast<long>(radius / ring_), 0L, rings_ - 1); }
  long layer_at(double z) const {
    return std::clamp(static_cast<long>(std::floor(z / layer_)) - first_layer_, 0L, layers_ - 1);
  }
  std::size_t cell(long in_r, long in_z) const { return static_cast<std::size_t>(in_z * rings_ + in_r); }
  std::size_t cell_at(const Vec<3>& point) const { return cell(ring_at(radius_of(point)), layer_at(point[2])); }

 private:
  double ring_;
  double layer_;
  long rings_ = 0;
  long first_layer_ = 0;
  long layers_ = 0;
};

/// The level part of a branch, in the frame along it: u along, h the distance of the axis to its left.
struct LevelLine {
  double length = 0.0;
  double u = 0.0;  // of the start
  double h = 0.0;
  double force_along = 0.0;
  double force_left = 0.0;

  explicit LevelLine(const Branch& branch) {
    length = std::hypot(branch.along[0], branch.along[1]);
    if (!(length > straight * magnitude(branch.along))) {
      length = 0.0;
      return;
    }
    const double x = branch.along[0] / length;
    const double y = branch.along[1] / length;
    u = branch.start[0] * x + branch.start[1] * y;
    h = branch.start[1] * x - branch.start[0] * y;
    if (std::fabs(h) < straight * length) h = 0.0;
    force_along = branch.force[0] * x + branch.force[1] * y;
    force_left = branch.force[1] * x - branch.force[0] * y;
  }
};

/// The integrals of the five components of f ds along the part [from, to] of a branch, 0 its start and 1 its end.
std::array<double, 5> integrals(const Branch& branch, const LevelLine& line, double from, double to) {
  std::array<double, 5> sum{};
  const double part = to - from;
  sum[zz] = branch.force[2] * branch.along[2] * part;
  if (line.length == 0.0) {  // upright, without a level branch
    const double radius = radius_of(branch.start);
    if (radius > 0.0) {
      const double radial = (branch.force[0] * branch.start[0] + branch.force[1] * branch.start[1]) / radius;
      sum[rz] = radial * branch.along[2] * part;
    }
    return sum;
  }
  const double u0 = line.u + from * line.length;
  const double u1 = line.u + to * line.length;
  const double h = line.h;
  const double out = std::hypot(u1, h) - std::hypot(u0, h);  // change of the radius
  double square = 0.0;                                       // of h^2/r^2
  double mixed = 0.0;                                        // of u h/r^2
  double left = 0.0;                                         // of h/r
  if (h != 0.0) {
    square = h * (std::atan(u1 / h) - std::atan(u0 / h));
    mixed = h * std::log(std::hypot(u1, h) / std::hypot(u0, h));
    left = h * (std::asinh(u1 / std::fabs(h)) - std::asinh(u0 / std::fabs(h)));
  }
  sum[rr] = line.force_along * (u1 - u0 - square) + line.force_left * mixed;
  sum[tt] = line.force_along * square - line.force_left * mixed;
  sum[rz] = (line.force_along * out + line.force_left * left) * branch.along[2] / line.length;
  sum[zr] = branch.force[2] * out;
  return sum;
}

/// Where a branch crosses the cylinders and planes of the grid, with its ends: ascending, from 0 to 1.
void find_crossings(const Branch& branch, const LevelLine& line, const Rings& rings, std::vector<double>& crossings) {
  crossings.assign({0.0, 1.0});
  const auto add = [&](double place) {
    if (place > 0.0 && place < 1.0) crossings.push_back(place);
  };
  const double low = std::min(branch.start[2], branch.start[2] + branch.along[2]);
  const double high = std::max(branch.start[2], branch.start[2] + branch.along[2]);
  for (double k = std::ceil(low / rings.layer()); k * rings.layer() < high; k += 1.0) {
    add((k * rings.layer() - branch.start[2]) / branch.along[2]);
  }
  if (line.length > 0.0) {
    const double end = line.u + line.length;
    const double nearest =
        line.u * end < 0.0 ? std::fabs(line.h) : std::hypot(std::min(std::fabs(line.u), std::fabs(end)), line.h);
    const double farthest = std::hypot(std::max(std::fabs(line.u), std::fabs(end)), line.h);
    for (double k = std::max(1.0, std::ceil(nearest / rings.ring())); k * rings.ring() < farthest; k += 1.0) {
      const double radius = k * rings.ring();
      const double reach = std::sqrt(std::max(0.0, (radius - line.h) * (radius + line.h)));
      add((-reach - line.u) / line.length);
      add((reach - line.u) / line.length);
    }
  }
  std::sort(crossings.begin(), crossings.end());
}

void add_solid(const OrderedGrains<3>& grains, const Sources& sources, const Vec<3>& origin, const Rings& rings,
               std::vector<double>& solid) {
  static const auto columns = columns_of_sphere();
  double unit_sum = 0.0;
  for (const auto& column : columns) unit_sum += 2.0 * column.half;
  for (const auto k : sources.grains) {
    const auto& grain = grains->line[k];
    const Vec<3> centre = grain.position - origin;
    const double radius = grain.radius;
    const double per_length = sphere_volume_below(radius, radius) / (unit_sum * radius);
    for (const auto& column : columns) {
      const long in_r = rings.ring_at(std::hypot(centre[0] + column.x * radius, centre[1] + column.y * radius));
      const double low = centre[2] - column.half * radius;
      const double high = centre[2] + column.half * radius;
      const long last = rings.layer_at(high);
      double from = low;
      for (long in_z = rings.layer_at(low); in_z <= last; ++in_z) {
        const double to = in_z == last ? high : static_cast<double>(rings.first_layer() + in_z + 1) * rings.layer();
        solid[rings.cell(in_r, in_z)] += per_length * (to - from);
        from = to;
      }
    }
  }
}

}  // namespace

AxialFields axial_fields(const OrderedGrains<3>& grains, const Contacts<3>& contacts, const std::vector<bool>& in_heap,
                         const Box<3>& box, const AxialSettings& settings) {
  REPOSE_ASSERT(in_heap.size() == grains.size());
  REPOSE_ASSERT(settings.ring > 0.0 && settings.layer > 0.0);
  AxialFields fields;
  const Vec<3> origin{{settings.axis[0], settings.axis[1], settings.base}};
  const auto sources = find_sources(grains, contacts, in_heap, box, origin);
  if (sources.grains.empty()) return fields;
  const Rings rings(settings.ring, settings.layer, grains, sources, origin);
  fields.ring = rings.ring();
  fields.layer = rings.layer();
  for (long k = 0; k < rings.rings(); ++k) fields.r.push_back((static_cast<double>(k) + 0.5) * rings.ring());
  for (long k = 0; k < rings.layers(); ++k) {
    fields.z.push_back(settings.base + (static_cast<double>(rings.first_layer() + k) + 0.5) * rings.layer());
  }
  const auto cells = static_cast<std::size_t>(rings.rings() * rings.layers());
  for (auto* field : {&fields.density, &fields.solid_fraction, &fields.support[0], &fields.support[1]}) {
    field->assign(cells, 0.0);
  }
  for (auto& component : fields.stress) component.assign(cells, 0.0);

  for (const auto k : sources.grains) {
    fields.density[rings.cell_at(grains->line[k].position - origin)] += grains->line[k].mass;
  }
  add_solid(grains, sources, origin, rings, fields.solid_fraction);
  std::vector<double> crossings;
  for (const auto& branch : sources.branches) {
    const LevelLine line(branch);
    find_crossings(branch, line, rings, crossings);
    for (std::size_t k = 1; k < crossings.size(); ++k) {
      const double middle = 0.5 * (crossings[k - 1] + crossings[k]);
      const auto cell = rings.cell_at(branch.start + branch.along * middle);
      const auto sum = integrals(branch, line, crossings[k - 1], crossings[k]);
      for (std::size_t c = 0; c < sum.size(); ++c) fields.stress[c][cell] += sum[c];
    }
  }
  for (const auto& support : sources.supports) {
    const auto cell = rings.cell_at(support.point);
    const double radius = radius_of(support.point);
    if (radius > 0.0) {
      fields.support[0][cell] += (support.force[0] * support.point[0] + support.force[1] * support.point[1]) / radius;
    }
    fields.support[1][cell] += support.force[2];
  }
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto in_r = static_cast<double>(cell % fields.r.size());
    const double volume = std::numbers::pi * squared(rings.ring()) * (2.0 * in_r + 1.0) * rings.layer();
    fields.volume.push_back(volume);
    for (auto* field : {&fields.density, &fields.solid_fraction, &fields.support[0], &fields.support[1]}) {
      (*field)[cell] /= volume;
    }
    for (auto& component : fields.stress) component[cell] /= volume;
  }
  return fields;
}

}  // namespace repose
