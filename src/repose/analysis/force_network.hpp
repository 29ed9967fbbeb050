// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <optional>
#include <vector>

namespace repose {

/// The network of contacts above a force threshold.
struct ForceNetwork {
  std::size_t contacts = 0;              ///< number of these contacts
  std::optional<double> coordination;    ///< mean number per grain of the heap; base grains and walls are partners too
  std::array<double, 7> connectivity{};  ///< fraction of the grains with 0, 1, ... 5 contacts, and 6 or more
  std::optional<double> anisotropy;      ///< 2 (l1 - l2) of the fabric tensor <n n>, in [0, 2]: 0 isotropic
  std::optional<double> direction_deg;   ///< axis of l1 from the horizontal, in (-90, 90]
};

/// Measures the network of contacts with a normal force, push or pull, above `threshold` [M L/T^2]. Coordination and
/// connectivity are those of the grains flagged `in_heap`; the other numbers are over all these contacts.
ForceNetwork measure_force_network(const Grains<2>& grains, const Contacts<2>& contacts,
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
