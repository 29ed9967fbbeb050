// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <vector>

namespace repose::hybrid {

/// Pairs of grains that may meet before the next build, each grain's partners by ascending index. Pairs of fixed grains
/// are left out.
class NearList {
 public:
  /// Builds the list of pairs whose gap is below `skin` [L].
  void build(const Grains<2>& grains, const Box<2>& box, double skin);

  /// Builds the same list as the last time, after its state has been read from a checkpoint.
  void restore(const Grains<2>& grains, const Box<2>& box);

  /// Whether the list holds all pairs that can meet while each grain k moves `reach(k)` [L] from where it is.
  template <class Reach>
  bool holds(const Grains<2>& grains, const Reach& reach) const {
    if (places_.size() != grains.size()) return false;
    for (std::uint32_t k = 0; k < grains.size(); ++k) {
      if (magnitude(grains.line[k].position - places_[k]) + reach(k) > 0.5 * skin_) return false;
    }
    return true;
  }

  struct Partners {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Partners of(std::uint32_t grain) const {
    return {partners_.data() + start_[grain], partners_.data() + start_[grain + 1]};
  }

  void exchange(Archive& archive);

 private:
  std::vector<Vec<2>> places_;  // [L] of the last build
  double skin_ = 0.0;           // [L]
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> partners_;
};

}  // namespace repose::hybrid
