// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/near_list.hpp"

#include "repose/neighbours/near_pairs.hpp"

#include <algorithm>

namespace repose::hybrid {

void NearList::build(const Grains<2>& grains, const Box<2>& box, double skin) {
  places_.clear();
  for (const auto& grain : grains.line) places_.push_back(grain.position);
  skin_ = skin;
  restore(grains, box);
}

void NearList::restore(const Grains<2>& grains, const Box<2>& box) {
  double largest = 0.0;
  for (const auto& grain : grains.line) largest = std::max(largest, grain.radius);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for_near_pairs(places_, box, 2.0 * largest + skin_, [&](std::uint32_t i, std::uint32_t j) {
    const auto& a = grains.line[i];
    const auto& b = grains.line[j];
    if (a.fixed() && b.fixed()) return;
    if (magnitude(separation(places_[i], places_[j], box)) >= a.radius + b.radius + skin_) return;
    found.emplace_back(i, j);
    found.emplace_back(j, i);
  });
  std::sort(found.begin(), found.end());
  start_.assign(grains.size() + 1, 0);
  partners_.clear();
  for (const auto& [i, j] : found) {
    ++start_[i + 1];
    partners_.push_back(j);
  }
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
}

void NearList::exchange(Archive& archive) {
  archive.array("hybrid/near_places", places_);
  archive.value("hybrid/near_skin", skin_);
}

}  // namespace repose::hybrid
