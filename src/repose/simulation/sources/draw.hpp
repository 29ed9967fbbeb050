// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/core/random.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// A grain that was drawn, and the number of its material.
template <int D>
struct DrawnGrain {
  Grain<D> grain;  ///< at rest at the origin
  std::uint16_t material = 0;
};

/// Draws grains from the species of a scene, or as its [grains] says. The k-th grain depends on the seed and k alone.
template <int D = 2>
class GrainDraw {
 public:
  /// `species` and `size` are what the random numbers are for.
  GrainDraw(const Scene& scene, Purpose species, Purpose size);

  DrawnGrain<D> operator()(std::uint64_t index) const;

 private:
  struct Kind {
    SizeDistribution sizes;
    std::uint16_t material;
    double mass;         // [M] of a grain of the reference diameter
    double below = 1.0;  // fraction by number of this and the kinds before
  };

  std::uint64_t seed_;
  Purpose species_;
  Purpose size_;
  double diameter_;
  double polydispersity_;
  std::vector<Kind> kinds_;
};

}  // namespace repose
