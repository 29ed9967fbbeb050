// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose::contact_dynamics {

/// Groups of contacts in colours. Groups of one colour share no moving body, so that they may be relaxed at the same
/// time; the result does not depend on whether they are.
struct PackGroups {
  std::vector<std::vector<std::uint32_t>> contacts;  ///< of each group, colour by colour
  std::vector<std::size_t> colour_start;             ///< (colours + 1) the first group of each colour
};

/// The number of parts into which a problem is divided: a function of the number of contacts alone, because the order
/// of the sweep depends on it. Small problems have one part.
std::size_t parts_of(std::size_t contacts);

/// Divides the bodies into `parts` that are contiguous in memory, hence in space. The first colour has a group for each
/// part, of its inner contacts; the other colours have the contacts between two parts.
PackGroups group_contacts(const Problem<2>& problem, std::size_t parts);

}  // namespace repose::contact_dynamics
