// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/core/box.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// Whether each disc of a deposited packing rests by the critical-angle rule on what was there before it: on the floor,
/// or by a contact less than the critical angle off upright, or between two contacts (walls too) that together carry
/// its weight. 1: it does not. Base discs rest. Looks at places alone and shares no code with the method.
/// `slack_deg` [deg] is what the angle may err by: touches are found to the gap of the graph only.
/// Source: Bratberg (2003), paper one, Fig. 3. Validated by tests/unit/deposition_test.cpp.
std::vector<std::uint8_t> breaks_sticking_rule(const Discs& discs, const Box<2>& box, const ContactGraph& graph,
                                               const Planes& planes, double gap, double critical_angle_deg,
                                               double slack_deg = 1e-4);

/// The deepest overlap of any two discs, over their mean diameter; 0 if none overlap. `graph` is of their contacts, to
/// any gap >= 0.
double deepest_overlap(const Discs& discs, const Box<2>& box, const ContactGraph& graph);

}  // namespace repose
