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

/// Numbers of contacts of the deposited discs whose centre lies in a slab. All their neighbours count, wherever they
/// are: in the slab or not, of the base, planes.
struct Coordination {
  std::size_t discs = 0;                       ///< in the slab
  Estimate mean;                               ///< z
  std::array<double, 7> connectivity{};        ///< P_q, share of discs with q = 0, 1, ... 5 contacts, and 6 or more
  std::array<double, 7> connectivity_error{};  ///< of one packing, as for z
  double rattlers = 0.0;                       ///< share of discs that are rattlers
  Estimate without_rattlers;  ///< z of the others, contacts with rattlers left out; NaN where none is left
};

/// `rattler` has one flag per disc (see rattlers). Errors are the jackknife over `blocks` blocks along x. They
/// are too large, about threefold for a forest of 1000 sticking discs, because the contacts across the edges of blocks
/// scatter while over the whole slab nearly every link counts at both its ends. Source: paper
/// one (Bratberg et al. 2002), III B and IV B. Validated by tests/unit/coordination_test.cpp.
Coordination read_coordination(const Discs& discs, const ContactGraph& graph,
                               const std::vector<std::uint8_t>& on_planes, const std::vector<std::uint8_t>& rattler,
                               const Slab& slab, std::size_t blocks);

}  // namespace repose
