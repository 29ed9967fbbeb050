// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/room.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace repose {

template <int D>
Room<D>::Room(const Grains<D>& grains, const Box<D>& box, double height, double largest, double reach)
    : box_(box), reach_(reach) {
  double widest = largest;
  std::vector<const Grain<D>*> near;
  for (const auto& grain : grains.line) {
    if (std::fabs(grain.position[up<D>] - height) >= reach * (grain.radius + largest)) continue;
    near.push_back(&grain);
    widest = std::max(widest, grain.radius);
  }
  cell_ = reach * (largest + widest);
  for (const auto* grain : near) add(*grain);
}

template <int D>
typename Room<D>::Cell Room<D>::cell_of(const Vec<D>& place) const {
  Cell cell;
  for (int axis = 0; axis < D - 1; ++axis) {
    cell[static_cast<std::size_t>(axis)] = static_cast<long>(std::floor(place[axis] / cell_));
  }
  return cell;
}

template <int D>
void Room<D>::put(const Grain<D>& grain) {
  cells_[cell_of(grain.position)].push_back(grain);
}

template <int D>
void Room<D>::add(const Grain<D>& grain) {
  auto image = grain;
  image.position = box_.wrapped(grain.position);
  std::vector<Grain<D>> images{image};
  // What lies near one end is also beyond the other.
  const auto repeat = [&](int axis, double low, double high) {
    for (std::size_t k = 0, count = images.size(); k < count; ++k) {
      const double place = images[k].position[axis];
      for (const double shift : {high - low, low - high}) {
        const bool near = shift > 0.0 ? place - low < cell_ : high - place < cell_;
        if (!near) continue;
        images.push_back(images[k]);
        images.back().position[axis] = place + shift;
      }
    }
  };
  if (box_.periodic) repeat(0, box_.x_min, box_.x_max);
  if constexpr (D == 3) {
    if (box_.periodic_y) repeat(1, box_.y_min, box_.y_max);
  }
  for (const auto& one : images) put(one);
}

template <int D>
bool Room<D>::is_free(const Grain<D>& grain) const {
  const auto place = box_.wrapped(grain.position);
  const auto middle = cell_of(place);
  const auto free_in = [&](const Cell& cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return true;
    return std::none_of(found->second.begin(), found->second.end(), [&](const auto& other) {
      const Vec<D> d = place - other.position;
      const double near = reach_ * (grain.radius + other.radius);
      return dot(d, d) < near * near;
    });
  };
  for (long x = middle[0] - 1; x <= middle[0] + 1; ++x) {
    if constexpr (D == 2) {
      if (!free_in({x})) return false;
    } else {
      for (long y = middle[1] - 1; y <= middle[1] + 1; ++y) {
        if (!free_in({x, y})) return false;
      }
    }
  }
  return true;
}

template class Room<2>;
template class Room<3>;

}  // namespace repose
