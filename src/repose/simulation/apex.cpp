// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/apex.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/analysis/standing.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

template <int D>
Apex<D>::Apex(const Scene& scene) {
  if (D == 3 && scene.gravity > 0.0) interval_ = 0.25 * std::sqrt(scene.grains.diameter / scene.gravity);
}

template <int D>
double Apex<D>::height(double time, const Grains<D>& grains, const std::function<const Contacts<D>&()>& contacts) {
  if (time < due_) return height_;
  due_ = time + interval_;
  const auto in_heap = D == 2 ? supported(grains, contacts()) : standing(grains, contacts());
  height_ = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (in_heap[k]) height_ = std::max(height_, grain.position[up<D>] + grain.radius);
  }
  return height_;
}

template <int D>
void Apex<D>::exchange(Archive& archive) {
  if (interval_ == 0.0) return;
  archive.value("source/apex", height_);
  archive.value("source/apex_due", due_);
}

template class Apex<2>;
template class Apex<3>;

}  // namespace repose
