// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/plan.hpp"
#include "repose/sweep/table.hpp"

namespace repose {

/// Whether the members of a claim's points determine its statistic. The places of rigid grains do not determine the
/// forces on their base (docs/physics/force_range.md): a claim about them stands only if the band that equilibrium
/// allows, as `repose analyse DIR --force-range` found it for every member, lies within the bounds of the claim. The
/// same holds for what floor and walls of a column carry, unless a wall moves.
bool is_determined(const Claim& claim, const SweepPlan& plan, const SweepTable& table);

}  // namespace repose
