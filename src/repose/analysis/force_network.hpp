// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <optional>
#include <vector>

namespace repose {

/// Who touches whom, among contacts that carry more than a stated force.
struct ForceNetwork {
  std::size_t contacts = 0;              ///< that count
  std::optional<double> coordination;    ///< mean number per grain of the heap, base and planes included as partners
  std::array<double, 7> connectivity{};  ///< share of those grains with 0, 1, ... 5, and 6 or more
  std::optional<double> anisotropy;      ///< 2 (l1 - l2) of the fabric tensor <n n>, in [0, 2]: 0 isotropic
  std::optional<double> direction_deg;   ///< of l1's axis from the horizontal, in (-90, 90]
};

/// Contacts with normal force above `threshold` [M L/T^2] among the grains flagged `in_heap` and their surroundings.
ForceNetwork measure_force_network(const Grains<2>& grains, const Contacts<2>& contacts,
                                   const std::vector<bool>& in_heap, double threshold);

/// Mean magnitude of the net force on a moving grain over its own weight: 0 at rest, 1 in free fall. Computed from the
/// contacts alone, apart from the method that moved the grains. Not a number without gravity.
template <int D>
double force_residual(const Grains<D>& grains, const Contacts<D>& contacts, const Vec<D>& gravity);

/// Deepest overlap over the mean diameter of its pair; 0 without contacts.
template <int D>
double max_overlap(const Contacts<D>& contacts);

}  // namespace repose
