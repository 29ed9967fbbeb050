// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"

#include "repose/analysis/local_motion.hpp"
#include "repose/analysis/smear.hpp"
#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr double most_cells = 4e6;

/// A contact of the heap: a force and the branch that it acts along.
struct Branch {
  Vec<2> start{};   // [L]
  Vec<2> branch{};  // [L] from `start` to the centre of the grain on which the force acts
  Vec<2> force{};   // [M L/T^2]
  Vec<2> normal{};
  bool support = false;
  bool counts = false;  // above the threshold

  /// A point from which walls are seen, on the side of the grains.
  Vec<2> eye() const { return start + branch * (support ? 1.0 : 0.5); }
};

/// The contacts of the heap, in the order of the list.
std::vector<Branch> find_branches(const OrderedGrains<2>& grains, const Contacts<2>& contacts,
                                  const std::vector<bool>& in_heap, const Box<2>& box, double threshold) {
  std::vector<Branch> branches;
  for (const auto& contact : contacts.list) {
    const auto first = grains.find(contact.first).value();
    const Vec<2>& at_first = grains->line[first].position;
    const Vec<2> force = force_of(contact);
    const bool counts = std::fabs(contact.normal_force) > threshold;
    const auto add = [&](const Vec<2>& start, const Vec<2>& branch, const Vec<2>& acting, bool support) {
      branches.push_back({start, branch, acting, contact.normal, support, counts});
    };
    if (contact.second < 0) {
      const Vec<2> branch = contact.normal * contact.first_lever;
      if (in_heap[first]) add(at_first - branch, branch, force, true);
      continue;
    }
    const auto second = grains.find(contact.second).value();
    const Vec<2>& at_second = grains->line[second].position;
    const Vec<2> between = separation(at_first, at_second, box);
    const Vec<2> lever = contact.normal * contact.first_lever;
    if (in_heap[first] && in_heap[second]) {
      add(at_first - between, between, force, false);
    } else if (in_heap[first]) {
      add(at_first - lever, lever, force, true);
    } else if (in_heap[second]) {
      add(at_second + (between - lever), lever - between, -force, true);
    }
  }
  return branches;
}

/// A grid with cells of about `cell` [L] that covers the points from `low` to `high` and a margin that Gaussians reach.
FieldGrid make_grid(const Vec<2>& low, const Vec<2>& high, const Box<2>& box, double width, double cell) {
  FieldGrid grid;
  grid.cell = cell;
  if (box.periodic) {
    const double columns = std::max(1.0, std::ceil(box.width() / cell * (1.0 - 1e-12)));
    grid.cell = box.width() / columns;
    grid.axis[0] = {box.x_min, static_cast<long>(columns), true};
  }
  for (int k = box.periodic ? 1 : 0; k < 2; ++k) {
    const double first = std::floor((low[k] - Smear::reach * width) / grid.cell);
    const double last = std::floor((high[k] + Smear::reach * width) / grid.cell);
    grid.axis[static_cast<std::size_t>(k)] = {first * grid.cell, static_cast<long>(last - first) + 1, false};
  }
  return grid;
}

/// The grid around the heap and its branches; without cells where it would need too many of them.
FieldGrid grid_around(const OrderedGrains<2>& grains, const std::vector<bool>& in_heap,
                      const std::vector<Branch>& branches, const Box<2>& box, double width) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vec<2> low{{infinite, infinite}};
  Vec<2> high{{-infinite, -infinite}};
  const auto cover = [&](const Vec<2>& point) {
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  };
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (in_heap[k]) cover(grains->line[k].position);
  if (!(low[0] <= high[0])) return {};
  for (const auto& branch : branches) {
    cover(branch.start);
    cover(branch.start + branch.branch);
  }
  // Cells are no wider than a periodic box, so a grain far above would need too many of them.
  if (box.periodic && high[1] - low[1] + 2.0 * Smear::reach * width > 0.5 * most_cells * box.width()) return {};
  FieldGrid grid = make_grid(low, high, box, width, 0.5 * width);
  for (double cell = 0.5 * width; grid.cells() > most_cells; grid = make_grid(low, high, box, width, cell))
    cell *= 1.25;
  return grid;
}

/// Contacts that count of each grain.
std::vector<double> partners_of(const OrderedGrains<2>& grains, const Contacts<2>& contacts, double threshold) {
  std::vector<double> partners(grains.size(), 0.0);
  for (const auto& contact : contacts.list) {
    if (!(std::fabs(contact.normal_force) > threshold)) continue;
    partners[grains.find(contact.first).value()] += 1.0;
    if (contact.second >= 0) partners[grains.find(contact.second).value()] += 1.0;
  }
  return partners;
}

Vec<2> mean_velocity(const OrderedGrains<2>& grains, const std::vector<bool>& in_heap) {
  Vec<2> momentum;
  double mass = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    momentum += grains->line[k].velocity * grains->line[k].mass;
    mass += grains->line[k].mass;
  }
  return mass > 0.0 ? momentum * (1.0 / mass) : Vec<2>{};
}

void divide(std::vector<double>& values, const std::vector<double>& by) {
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = by[k] > 0.0 ? values[k] / by[k] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Fields coarse_grained(const OrderedGrains<2>& grains, const Contacts<2>& contacts, const std::vector<bool>& in_heap,
                      const Box<2>& box, const FieldSettings& settings) {
  const double width = settings.width;
  REPOSE_ASSERT(width > 0.0 && in_heap.size() == grains.size());
  Fields fields;
  fields.width = width;
  fields.cell = 0.5 * width;
  const auto branches = find_branches(grains, contacts, in_heap, box, settings.threshold);
  const auto grid = grid_around(grains, in_heap, branches, box, width);
  if (!(grid.cells() > 0.0)) return fields;
  fields.cell = grid.cell;
  fields.x = grid.centres(0);
  fields.y = grid.centres(1);
  const auto cells = fields.x.size() * fields.y.size();
  for (auto* field : {&fields.density, &fields.solid_fraction, &fields.contacts, &fields.coordination})
    field->assign(cells, 0.0);
  for (auto& component : fields.stress) component.assign(cells, 0.0);
  for (auto& component : fields.support) component.assign(cells, 0.0);
  for (auto& component : fields.fabric) component.assign(cells, 0.0);

  Smear smear(grid, width, settings.walls, box);
  LocalMotion motion(cells, mean_velocity(grains, in_heap));
  const auto partners = partners_of(grains, contacts, settings.threshold);
  std::vector<double> number(cells, 0.0);  // of grains per area
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    const auto& grain = grains->line[k];
    smear.at(grain.position, grain.position);
    smear.add(fields.density, grain.mass);
    smear.add(fields.solid_fraction, std::numbers::pi * squared(grain.radius));
    smear.add(number, 1.0);
    smear.add(fields.coordination, partners[k]);
    motion.add(smear, grain.mass, grain.position, grain.velocity);
  }
  for (const auto& contact : branches) {
    smear.along(contact.start, contact.branch, contact.eye());
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        smear.add(fields.stress[static_cast<std::size_t>(2 * a + b)], contact.force[a] * contact.branch[b]);
    if (contact.counts) {
      const auto& n = contact.normal;
      smear.add(fields.contacts, 1.0);
      smear.add(fields.fabric[0], n[0] * n[0]);
      smear.add(fields.fabric[1], n[0] * n[1]);
      smear.add(fields.fabric[2], n[1] * n[1]);
    }
    if (!contact.support) continue;
    smear.at(contact.start, contact.eye());
    for (int a = 0; a < 2; ++a) smear.add(fields.support[static_cast<std::size_t>(a)], contact.force[a]);
  }
  divide(fields.coordination, number);
  for (auto& component : fields.fabric) divide(component, fields.contacts);
  fields.velocity = motion.velocity();
  fields.temperature = motion.temperature();
  fields.room = smear.room();
  return fields;
}

}  // namespace repose
