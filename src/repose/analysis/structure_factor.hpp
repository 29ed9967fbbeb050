// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/packing_slab.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <vector>

namespace repose {

/// Weight of a point by its place between two ends.
enum class Window {
  none,  ///< 1: Bragg peaks have S = N, but sharp ends scatter (as 1/q^2) at wave vectors that do not fit
  hann   ///< sin^2(pi place): hardly scatters; peaks have S = 2/3 N, (sum w)^2 / sum w^2
};

/// S(q) = |sum_j w_j exp(-i q . r_j)|^2 / sum_j w_j^2 at each wave vector [1/L], over points in the slab; w is the
/// window across the height and, where the box is not periodic, across the width. Direct sums. In a periodic box only
/// multiples of 2 pi / width make sense as q_x. Independent points give 1 away from q = 0. Source: thesis (2.1), as the
/// Fourier transform of equation 7. Validated by tests/unit/structure_factor_test.cpp.
std::vector<double> structure_factor(const std::vector<Vec<2>>& points, const std::vector<Vec<2>>& wave_vectors,
                                     const Slab& slab, Window window);

struct StructureFactorOptions {
  double largest = 0.0;               ///< [1/L] largest |q|; 0 makes analyse_packing take 4 pi over the mean diameter
  std::size_t shells = 60;            ///< bins of |q|
  std::size_t most_vectors = 20'000;  ///< beyond that only every second, third ... multiple is taken, both ways
  Window window = Window::hann;
};

/// S averaged over directions, in shells of |q|; empty shells are left out.
struct IsotropicStructureFactor {
  std::vector<double> wave_number;   ///< [1/L] mean |q| of the shell
  std::vector<double> value;         ///< mean S
  std::vector<double> error;         ///< of the mean, from the scatter in the shell; NaN for one vector
  std::vector<std::size_t> vectors;  ///< in the shell, of q and -q only one
};

/// Wave vectors (2 pi k / width, 2 pi m / height), those nearest to 0 left out where the window smears the mean density
/// over them. The window also makes neighbours on this grid depend on each other; the error allows for that. Cost:
/// points times vectors, about 1 ns each.
IsotropicStructureFactor isotropic_structure_factor(const std::vector<Vec<2>>& points, const Slab& slab,
                                                    const StructureFactorOptions& options);

}  // namespace repose
