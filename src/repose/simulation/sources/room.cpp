// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/room.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

Room::Room(const Grains<2>& grains, const Box<2>& box, double height, double largest, double reach)
    : box_(box), reach_(reach) {
  double widest = largest;
  std::vector<const Grain<2>*> near;
  for (const auto& grain : grains.line) {
    if (std::fabs(grain.position[1] - height) >= reach * (grain.radius + largest)) continue;
    near.push_back(&grain);
    widest = std::max(widest, grain.radius);
  }
  cell_ = reach * (largest + widest);
  for (const auto* grain : near) add(*grain);
}

long Room::cell_of(double x) const { return static_cast<long>(std::floor(x / cell_)); }

void Room::put(const Grain<2>& grain) { cells_[cell_of(grain.position[0])].push_back(grain); }

void Room::add(const Grain<2>& grain) {
  auto image = grain;
  image.position = box_.wrapped(grain.position);
  put(image);
  if (!box_.periodic) return;
  // What lies near one end is also beyond the other.
  const double x = image.position[0];
  if (x - box_.x_min < cell_) {
    image.position[0] = x + box_.width();
    put(image);
  }
  if (box_.x_max - x < cell_) {
    image.position[0] = x - box_.width();
    put(image);
  }
}

bool Room::is_free(const Grain<2>& grain) const {
  const auto place = box_.wrapped(grain.position);
  const long middle = cell_of(place[0]);
  for (long cell = middle - 1; cell <= middle + 1; ++cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) continue;
    for (const auto& other : found->second) {
      const Vec<2> d = place - other.position;
      const double near = reach_ * (grain.radius + other.radius);
      if (dot(d, d) < near * near) return false;
    }
  }
  return true;
}

}  // namespace repose
