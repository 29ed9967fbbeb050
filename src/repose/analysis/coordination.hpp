// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/analysis/statistics.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The coordination of the deposited discs whose centre lies in a slab. All their neighbours count: in the slab or
/// outside, base discs and walls.
struct Coordination {
  std::size_t discs = 0;                       ///< number of these discs
  Estimate mean;                               ///< z, the mean number of contacts
  std::array<double, 7> connectivity{};        ///< P_q, fraction of discs with q = 0, 1, ... 5 contacts, and 6 or more
  std::array<double, 7> connectivity_error{};  ///< standard errors for one packing
  double rattlers = 0.0;                       ///< fraction of discs that are rattlers
  Estimate without_rattlers;  ///< z of the other discs without contacts to rattlers; NaN if all are rattlers
};

/// Measures the coordination. `rattler` and `on_walls` have one entry per disc (see rattlers, wall_contacts). Errors
/// are the jackknife over `blocks` blocks along x. They are too large, about threefold for a forest of 1000 sticking
/// discs: contacts across the edges of blocks scatter, while over the whole slab nearly every contact counts at both
/// ends. Source: paper one (Bratberg et al. 2002), III B and IV B. Validated by tests/unit/coordination_test.cpp.
Coordination measure_coordination(const Discs& discs, const ContactGraph& graph,
                                  const std::vector<std::uint8_t>& on_walls, const std::vector<std::uint8_t>& rattler,
                                  const Slab& slab, std::size_t blocks);

}  // namespace repose
