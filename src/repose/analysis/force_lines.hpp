// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The strongest and the weakest contact of a moving grain.
struct ForceLine {
  std::int64_t id = 0;           ///< of the grain
  std::int64_t strongest = 0;    ///< place in the list of contacts
  std::int64_t weakest = 0;      ///< likewise; the same where the grain has one contact
  double strongest_force = 0.0;  ///< [M L/T^2] normal force of that contact
  double weakest_force = 0.0;    ///< [M L/T^2]
};

/// A contact between two grains is horizontal if its normal lies within this angle of the horizontal [deg]. It is half
/// of the way from the rows of a triangular lattice to halfway to its diagonals.
inline constexpr double horizontal_within = 15.0;

struct ForceLines {
  std::vector<ForceLine> grains;         ///< by ascending id: the moving grains with a contact that counts
  std::size_t contacts = 0;              ///< contacts between two grains that count
  std::size_t horizontal = 0;            ///< horizontal ones among them
  double largest_horizontal = 0.0;       ///< [M L/T^2] normal force of a horizontal contact; 0 without any
  std::size_t strongest_horizontal = 0;  ///< grains whose strongest contact is horizontal
  std::size_t weakest_horizontal = 0;    ///< grains whose weakest contact is horizontal
};

/// Lines of force: contacts with a normal force above `threshold` [M L/T^2] count, those with walls too. Of contacts
/// whose forces are equal to 1e-6, the one that comes first in the list is taken.
/// Source: Liffman et al. (1992), Figs. 10 and 16. Validated by tests/unit/force_lines_test.cpp.
ForceLines find_force_lines(const OrderedGrains<2>& grains, const Contacts<2>& contacts, double threshold);

}  // namespace repose
