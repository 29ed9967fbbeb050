// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/pair_correlation.hpp"
#include "repose/analysis/structure_factor.hpp"
#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace repose {

/// A block of space with faces along the axes, in which the structure of a packing is measured.
struct Cuboid {
  Vec<3> low{};   ///< [L]
  Vec<3> high{};  ///< [L]
  std::array<bool, 3> periodic{};

  double side(int axis) const { return high[axis] - low[axis]; }
  double volume() const { return side(0) * side(1) * side(2); }
  bool holds(const Vec<3>& point) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!periodic[static_cast<std::size_t>(axis)] && (point[axis] < low[axis] || point[axis] >= high[axis])) {
        return false;
      }
    }
    return true;
  }
};

/// g(r) of the points that a cuboid holds, in bins up to `reach` [L], shifted as those in 2D (Correlation) by the
/// `diameter` [L]. The expected number of pairs is exact on average for independent uniform points: N (N - 1)/2 times
/// the integral over the bin of 4 pi r^2 c(r)/V^2, where c(r), the volume that stays in the cuboid when it is shifted
/// by r in a random direction, is a polynomial of third degree. The reach is at most half of a periodic side and the
/// whole of an open one. Errors are those of independent pairs. With open axes there is a further deviation, since
/// points near faces have fewer neighbours: up to about 1/(2 sqrt(N)) at distances of half a side, alike in all bins
/// there. Points on a periodic axis must be wrapped. Empty for fewer than two points. Cost: proportional to the number
/// of pairs within reach. Validated by tests/unit/sphere_structure_test.cpp.
Correlation sphere_pair_correlation(const std::vector<Vec<3>>& points, const Cuboid& cuboid, double reach,
                                    double bin_width, double diameter);

/// S(q) as in 2D (structure_factor): wave vectors [1/L] of any direction, with the window along the axes that are not
/// periodic, over the points that the cuboid holds.
std::vector<double> sphere_structure_factor(const std::vector<Vec<3>>& points, const std::vector<Vec<3>>& wave_vectors,
                                            const Cuboid& cuboid, Window window);

/// S averaged over directions, over the wave vectors 2 pi (k/a, l/b, m/c) of the cuboid, up to `options.largest`. With
/// more than `options.most_vectors` of them only every second, third ... multiple in all directions is used. Vectors
/// over which the window smears the mean density are left out. Errors are from the scatter in a shell, with the
/// correlation of neighbouring vectors by the window. Cost: about 5 ns per point and vector.
IsotropicStructureFactor sphere_isotropic_structure_factor(const std::vector<Vec<3>>& points, const Cuboid& cuboid,
                                                           const StructureFactorOptions& options);

}  // namespace repose
