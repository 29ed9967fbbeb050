// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/analysis/statistics.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// The fabric tensor phi = <n n> of contact normals n = (sin theta, cos theta). theta is measured from the vertical and
/// is positive if the upper disc lies to the right. The trace of phi is 1.
struct FabricTensor {
  double xx = 0.0;         ///< <sin^2 theta>
  double yy = 0.0;         ///< <cos^2 theta>
  double xy = 0.0;         ///< <sin theta cos theta>
  Estimate anisotropy;     ///< a = 2 (phi_1 - phi_2), in [0, 2]: the a of p = (1/pi) {1 + a cos 2(theta - theta_f)}
  Estimate direction_deg;  ///< theta_f of the larger eigenvalue, in (-90, 90]; undetermined if a = 0
};

/// Fourier coefficients of p(theta) = (1/pi) {1 + sum_m [cosine cos(m theta) + sine sin(m theta)]}.
struct Harmonic {
  int order = 0;        ///< m
  double cosine = 0.0;  ///< 2 <cos(m theta)>
  double sine = 0.0;    ///< 2 <sin(m theta)>
};

/// Directions of the contacts between discs whose contact point lies in a slab. Contacts with walls do not count, since
/// their normals are imposed.
struct Fabric {
  std::size_t contacts = 0;
  FabricTensor all;                     ///< over theta; vertical by symmetry in a deposition without bias
  FabricTensor folded;                  ///< over |theta|: both sides folded together; its direction_deg is in [0, 90]
  std::array<Harmonic, 3> harmonics{};  ///< m = 2, 4, 6; the first has the amplitude all.anisotropy

  double bin_width = 0.0;             ///< [deg]
  std::vector<double> direction_deg;  ///< theta at the centres of the bins, in (-90, 90]; the last is 90, horizontal
  std::vector<std::size_t> count;     ///< contacts in each bin
  std::vector<double> density;        ///< [1/deg] p(theta); its sum times bin_width is 1
  std::vector<double> error;          ///< [1/deg] of the density, from the square root of the count
};

/// Measures the fabric. Bins are 180/bins degrees wide and centred on multiples of that width from the horizontal, so
/// that horizontal contacts, whose sign is arbitrary, share the last bin. Errors of the tensors are the jackknife over
/// `blocks` blocks along x. The error of an anisotropy near 0 is of little use, because a is never negative. None
/// without a contact in the slab.
///
/// The contact point divides the line of centres in proportion to the radii. Source: paper one (Bratberg et al. 2002),
/// equations 8 and 9; |theta| after its III B. The thesis (2.1) measures angles from the horizontal instead.
/// Validated by tests/unit/fabric_test.cpp.
std::optional<Fabric> measure_fabric(const Discs& discs, const ContactGraph& graph, const Slab& slab, std::size_t bins,
                                     std::size_t blocks);

}  // namespace repose
