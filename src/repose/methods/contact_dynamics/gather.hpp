// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/methods/contact_dynamics/near_walls.hpp"
#include "repose/methods/contact_dynamics/problem.hpp"
#include "repose/methods/contact_dynamics/settings.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <cstdint>
#include <vector>

namespace repose::contact_dynamics {

/// The fixed input of the search for contacts.
template <int D>
struct GatherInput {
  const ImpulseLaws& laws;
  const ContactDynamicsSettings<D>& settings;
  const std::vector<WallNow<D>>& walls;  ///< the walls at the start of the step
  const NearWalls<D>& near_walls;
};

/// Two bodies are in contact if their gap, at the start of the step or at its end by the free velocities, is below a
/// margin: a fraction of the roll radius, so that all collisions of a step are solved together, or the distance that
/// gravity may add, if that is larger: this many times g dt^2.
inline constexpr double margin_of_radius = 0.05;
inline constexpr double margin_of_fall = 2.5;

/// A contact with restitution that closes within the step.
struct Closing {
  std::uint32_t contact = 0;            ///< its place among the contacts of the problem
  double gap = 0.0;                     ///< [L] at the start of the step; negative: an overlap
  double restitution = 0.0;             ///< normal, 0 to 1
  double tangential_restitution = 0.0;  ///< -1 to 1
};

/// A contact with restitution that opens. It is no obstacle to a body that an impact throws back at it, but the next
/// impact.
struct Opening {
  std::uint32_t contact = 0;
  double restitution = 0.0;
};

/// The contacts with restitution of a step.
struct Collisions {
  std::vector<Closing> closing;
  std::vector<Opening> opening;
};

/// Sets the contacts of a step: pairs that touch, overlap or may touch within the step. They are ordered by the rows of
/// the pair list; contacts of a grain with walls (wall w is body number of grains + w) follow at the end of its row.
/// `problem` holds the free velocities; `grains` has the velocities before the step. Impulses start from those of
/// `before`, the contacts of the previous step, in the same order of bodies. Biases are those of gaps and
/// overlaps; `collisions` lists those with restitution.
template <int D>
void gather(const GatherInput<D>& input, const Grains<D>& grains, const PairList<D>& pairs,
            const std::vector<ContactLine<D>>& before, Problem<D>& problem, Collisions& collisions);

/// Renumbers the bodies of contacts after grains were reordered or dropped, and sorts the contacts into the order of
/// `gather`. `order` is the result of PairList::build, `grains_before` the number of grains before it.
template <int D>
void renumber(const std::vector<std::uint32_t>& order, std::size_t grains_before,
              std::vector<ContactLine<D>>& contacts);

}  // namespace repose::contact_dynamics
