// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/methods/contact_dynamics/problem.hpp"
#include "repose/methods/contact_dynamics/settings.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <cstdint>
#include <vector>

namespace repose::contact_dynamics {

/// What the search for contacts looks at.
template <int D>
struct Scenery {
  const ImpulseLaws& laws;
  const ContactDynamicsSettings<D>& settings;
  const std::vector<WallNow<D>>& walls;  ///< where they are at the start of the step
};

/// Fills in the contacts of a step: pairs that touch, overlap or may meet within the step, grain with grain by rows of
/// the pair list and grain with wall (body number of grains + wall) at the end of each row. `problem` holds the free
/// velocities; velocities of `grains` are those before the step. Impulses are taken over from `before`, contacts of
/// the step before in the same order of bodies.
template <int D>
void gather(const Scenery<D>& scenery, const Grains<D>& grains, const PairList<D>& pairs,
            const std::vector<ContactLine<D>>& before, Problem<D>& problem);

/// Gives contacts the new numbers of their bodies after grains were reordered or dropped, and brings them into the
/// order in which they are gathered. `order` is what PairList::build returned, `grains_before` how many there were.
template <int D>
void renumber(const std::vector<std::uint32_t>& order, std::size_t grains_before,
              std::vector<ContactLine<D>>& contacts);

}  // namespace repose::contact_dynamics
