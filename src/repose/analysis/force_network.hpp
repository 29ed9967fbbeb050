// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// The largest number of contacts that connectivity counts by itself: that of a triangular, or of a face-centred cubic,
/// lattice.
template <int D>
inline constexpr std::size_t most_contacts = D == 2 ? 6 : 12;

/// The network of contacts above a force threshold.
template <int D>
struct NetworkOfForces {
  std::size_t contacts = 0;            ///< number of these contacts
  std::optional<double> coordination;  ///< mean number per grain of the heap; base grains and walls are partners too
  /// fraction of the grains with 0, 1, ... contacts; the last is for most_contacts or more
  std::array<double, most_contacts<D> + 1> connectivity{};
  /// Anisotropy of the fabric tensor <n n>, whose trace is 1; 0 if it is isotropic. In 2D 2 (l1 - l2), in [0, 2]: the
  /// amplitude of the second harmonic. In 3D the deviator (analysis/principal_axes.hpp), in [0, 1]: l1 - l3 if it is
  /// axisymmetric.
  std::optional<double> anisotropy;
  std::optional<double> direction_deg;  ///< axis of l1 from the horizontal, in (-90, 90]; in 3D above it, in [0, 90]
};
using ForceNetwork = NetworkOfForces<2>;

/// Measures the network of contacts with a normal force, push or pull, above `threshold` [M L/T^2]. Coordination and
/// connectivity are those of the grains flagged `in_heap`; the other numbers are over all these contacts. Validated by
/// tests/unit/analysis_test.cpp and, in 3D, tests/unit/sphere_forces_test.cpp.
template <int D>
NetworkOfForces<D> measure_force_network(const Grains<D>& grains, const Contacts<D>& contacts,
                                         const std::vector<bool>& in_heap, double threshold);

/// The net force on each grain [M L/T^2]: its weight and the forces of its contacts, in the order of the grains.
template <int D>
std::vector<Vec<D>> net_forces(const Grains<D>& grains, const Contacts<D>& contacts, const Vec<D>& gravity);

/// The mean magnitude [M L/T^2] of the normal forces that are not zero; 0 without any.
template <int D>
double mean_normal_force(const Contacts<D>& contacts);

/// The mean over moving grains of the net force (magnitude) divided by the grain's weight: 0 at rest, 1 in free fall.
/// Without gravity it is divided by the mean normal force of the contacts, and NaN where these carry none. It is
/// computed from the contacts alone, independently of the method that moved the grains.
template <int D>
double force_residual(const Grains<D>& grains, const Contacts<D>& contacts, const Vec<D>& gravity);

/// The largest overlap divided by the mean diameter of its pair; 0 without contacts.
template <int D>
double max_overlap(const Contacts<D>& contacts);

}  // namespace repose
