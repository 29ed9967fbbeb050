// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace repose {

/// Grains as a record holds them: by ascending id, with positions inside the periodic box. Sorting and wrapping are the
/// only way to make one, so a function that takes one does neither. Reads like a pointer: `grains->line[k]`.
template <int D>
class OrderedGrains {
 public:
  OrderedGrains() = default;
  OrderedGrains(Grains<D> grains, const Box<D>& box) : grains_(std::move(grains)) {
    if (!std::is_sorted(grains_.id.begin(), grains_.id.end())) grains_.reorder(by_id(grains_));
    for (auto& grain : grains_.line) grain.position = box.wrapped(grain.position);
  }

  const Grains<D>& operator*() const { return grains_; }
  const Grains<D>* operator->() const { return &grains_; }
  std::size_t size() const { return grains_.size(); }

  /// Place of the grain with this id; none if it is not there.
  std::optional<std::size_t> find(std::int64_t id) const {
    const auto found = std::lower_bound(grains_.id.begin(), grains_.id.end(), id);
    if (found == grains_.id.end() || *found != id) return std::nullopt;
    return static_cast<std::size_t>(found - grains_.id.begin());
  }

 private:
  Grains<D> grains_;
};

}  // namespace repose
