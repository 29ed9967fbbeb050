// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// What collided and turned soft in the whole run.
void add_collisions(Registry& to) {
  const auto account = [](auto member) {
    return [=](const Measured& run) { return collision_account(run.record.series).*member; };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure(
      "collisions", "", "over the whole run", [](const Measured&) { return Object{}; }, Needs::collisions));
  add(measure("collisions.steps", "", "time steps, each part of a divided one counted",
              account(&CollisionAccount::steps)));
  add(measure("collisions.hard", "", "hard collisions", account(&CollisionAccount::hard)));
  add(measure("collisions.softened", "", "contacts that turned soft", account(&CollisionAccount::softened)));
  add(measure("collisions.hardened", "", "soft contacts that ended", account(&CollisionAccount::hardened)));
  add(measure("collisions.iterations", "", "steps of Newton's method, or sweeps, in implicit steps",
              account(&CollisionAccount::iterations)));
  add(measure("collisions.halved", "", "implicit steps without a solution, repeated as two halves",
              account(&CollisionAccount::halved)));
  add(measure("collisions.worst_residual", "grain weights", "worst residual force of a grain",
              account(&CollisionAccount::worst_residual)));
}

}  // namespace repose
