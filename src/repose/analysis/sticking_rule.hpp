// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/core/box.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// One flag per disc of a deposited packing, 1 if it breaks the critical-angle rule. A disc obeys the rule if discs
/// deposited before it and the walls support it: it lies on the floor, or has a contact at less than the critical angle
/// from the vertical, or lies between two contacts (walls included) that together carry its weight. Base discs obey it.
/// The function uses positions alone and shares no code with the method. `slack_deg` [deg] is the tolerance of the
/// angle, since contacts are known to the gap of the graph only.
/// Source: Bratberg (2003), paper one, Fig. 3. Validated by tests/unit/deposition_test.cpp.
std::vector<std::uint8_t> breaks_sticking_rule(const Discs& discs, const Box<2>& box, const ContactGraph& graph,
                                               const PackingWalls& walls, double gap, double critical_angle_deg,
                                               double slack_deg = 1e-4);

/// The largest overlap of two discs, divided by their mean diameter; 0 if none overlap. `graph` holds their contacts,
/// for any gap >= 0.
double deepest_overlap(const Discs& discs, const Box<2>& box, const ContactGraph& graph);

}  // namespace repose
