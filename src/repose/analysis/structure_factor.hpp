// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/packing_slab.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <vector>

namespace repose {

/// The weight of a point as a function of its relative position t between two ends.
enum class Window {
  none,  ///< 1: Bragg peaks have S = N, but sharp ends scatter (as 1/q^2) at wave vectors that do not fit the slab
  hann   ///< sin^2(pi t): ends hardly scatter; Bragg peaks have S = 2/3 N, (sum w)^2 / sum w^2
};

/// S(q) = |sum_j w_j exp(-i q . r_j)|^2 / sum_j w_j^2 at each wave vector [1/L], over points in the slab, by direct
/// sums. w is the window across the height and, if the box is not periodic, across the width. In a periodic box only
/// multiples of 2 pi / width are meaningful as q_x. Independent points give 1 away from q = 0. Source: thesis (2.1), as
/// the Fourier transform of equation 7. Validated by tests/unit/structure_factor_test.cpp.
std::vector<double> structure_factor(const std::vector<Vec<2>>& points, const std::vector<Vec<2>>& wave_vectors,
                                     const Slab& slab, Window window);

struct StructureFactorOptions {
  double largest = 0.0;               ///< [1/L] largest |q|; for 0, analyse_packing uses 4 pi over the mean diameter
  std::size_t shells = 60;            ///< bins of |q|
  std::size_t most_vectors = 20'000;  ///< with more, only every second, third ... multiple in both directions is used
  Window window = Window::hann;
};

/// S averaged over directions, in shells of |q|; empty shells are left out.
struct IsotropicStructureFactor {
  std::vector<double> wave_number;   ///< [1/L] mean |q| of the shell
  std::vector<double> value;         ///< mean S
  std::vector<double> error;         ///< standard error of the mean, from the scatter in the shell; NaN for one vector
  std::vector<std::size_t> vectors;  ///< number in the shell; q and -q count once
};

/// Averages S over the wave vectors (2 pi k / width, 2 pi m / height). The vectors nearest to 0, over which the window
/// smears the mean density, are left out. The window also correlates neighbouring vectors; the error accounts for that.
/// Cost: about 1 ns per point and vector.
IsotropicStructureFactor isotropic_structure_factor(const std::vector<Vec<2>>& points, const Slab& slab,
                                                    const StructureFactorOptions& options);

}  // namespace repose
