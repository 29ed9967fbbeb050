// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/material_table.hpp"
#include "repose/methods/soft/audit.hpp"
#include "repose/methods/soft/global_damping.hpp"
#include "repose/methods/soft/pair_force.hpp"
#include "repose/methods/soft/partition.hpp"
#include "repose/methods/soft/settings.hpp"
#include "repose/methods/wall_list.hpp"

#include <algorithm>
#include <vector>

/// The step of the soft method over the grains of a member: what the general kernel and the fused ones have in common.
///
/// The sweep visits grains in memory order. Every pair (i, j) has j > i. So when the sweep reaches grain i, its pairs
/// with earlier grains are done, and their forces are in its slot of the ring. The sweep then computes the other pairs
/// of i. After that nothing needs the old state of i, so it is kicked and drifts immediately, in place. Forces on
/// another member's grains (or too far apart in memory for the ring) come from the edge pairs, which are computed
/// before the sweep. The forces on each grain are always summed in ascending order of the partner, so the results are
/// the same to the bit for any number of members.
namespace repose::soft {

/// The input of one sweep by the general kernel, and of what a fused one leaves to it: walls, loads, fixed grains.
template <int D, class Law>
struct SweepInput {
  const MaterialTable<Law>& laws;
  const SoftSettings<D>& settings;
  PairList<D>& pairs;
  WallList<D>& walls;
  std::vector<GrainWork>& work;               ///< per grain; empty unless the energy is audited
  const std::vector<LoadedGrain<D>>& loaded;  ///< ascending by i
  std::vector<double>& load_work;             ///< [M L^2/T^2] work of each load
  double kick;                                ///< [T] half a step in the first step, then a step
  long step;                                  ///< number of this step
  double speed_limit;                         ///< [L/T] of each component, above which a grain cannot be followed
};

/// The times by which contacts advance in this step: the step itself for velocities of the half step, whose sum is the
/// midpoint rule, and both its halves for velocities at the time of the force.
template <bool Synchronised, int D, class Law>
REPOSE_FN auto contact_times(const SweepInput<D, Law>& in) {
  const double dt = in.settings.time_step;
  if constexpr (Synchronised) {
    return HalfSteps{.before = in.step > 0 ? 0.5 * dt : 0.0, .after = 0.5 * dt};
  } else {
    return dt;
  }
}

/// The change of velocity and rim velocity by a total push.
template <int D, bool Full, class Law>
REPOSE_FN HalfStep<D> kick_of(const SweepInput<D, Law>& in, const Grain<D>& grain, const Slot<D, Full>& sum) {
  const double per_mass = in.kick * grain.inverse_mass;
  return {sum.force * per_mass + in.settings.gravity * in.kick,
          sum.rim_torque * (per_mass * inverse_inertia_factor<D>)};
}

/// Moves one grain by leapfrog under its total push. Returns the mean velocities over the kick: times the force they
/// are the exact change of its kinetic energy. `change` is that of its velocities. Source: Baxter et al. (1997),
/// (9)-(12).
template <bool Synchronised, int D, class Law>
REPOSE_FN HalfStep<D> drift(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i, const HalfStep<D>& change) {
  auto& grain = grains.line[i];
  const double dt = in.settings.time_step;
  if constexpr (Synchronised) {
    auto& half = grains.half_step[i];
    half.velocity += change.velocity;
    half.rim_velocity += change.rim_velocity;
    grain.position += half.velocity * dt;
    grain.velocity = half.velocity + change.velocity * 0.5;
    grain.rim_velocity = half.rim_velocity + change.rim_velocity * 0.5;
    return {half.velocity - change.velocity * 0.5, half.rim_velocity - change.rim_velocity * 0.5};
  } else {
    grain.velocity += change.velocity;
    grain.rim_velocity += change.rim_velocity;
    grain.position += grain.velocity * dt;
    return {grain.velocity - change.velocity * 0.5, grain.rim_velocity - change.rim_velocity * 0.5};
  }
}

/// Lets the total push act on a grain and moves it. Returns the mean velocities over the kick.
template <bool Synchronised, bool Full, int D, class Law>
REPOSE_FN HalfStep<D> kick_and_drift(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i,
                                     const Slot<D, Full>& sum) {
  auto& grain = grains.line[i];
  const auto change = kick_of(in, grain, sum);
  if constexpr (Full) {
    if (in.settings.damping.any()) {
      HalfStep<D> before{grain.velocity, grain.rim_velocity};
      if constexpr (Synchronised) before = grains.half_step[i];
      const auto less = damped(in.settings.damping, in.kick, before, change);
      const auto mean = drift<Synchronised>(in, grains, i, less);
      if (!in.work.empty()) {
        const double moved = dot(Vec<D>(change.velocity - less.velocity), mean.velocity);
        const Spin<D> turned = change.rim_velocity - less.rim_velocity;
        in.work[i].drag += grain.mass * (moved + inner(turned, mean.rim_velocity) / inverse_inertia_factor<D>);
      }
      return mean;
    }
  }
  return drift<Synchronised>(in, grains, i, change);
}

/// The push of the walls on a grain.
template <int D, bool Full>
struct WallPush {
  Push<D, Full> all;
  Vec<D> dissipative{};  ///< [M L/T^2] part of the force by dashpot and friction; in a full kernel only
};

/// Adds the work of dissipative forces on a grain that moved with the `mean` velocity.
template <int D>
void add_work(GrainWork& work, const Slot<D, true>& sum, const WallPush<D, true>& at_walls, const HalfStep<D>& mean,
              double kick) {
  const auto power = [&](const Vec<D>& force) { return dot(force, mean.velocity); };
  const auto turning = [&](const Spin<D>& rim_torque) { return inner(rim_torque, mean.rim_velocity); };
  work.damping -= power(sum.damping) * kick;
  work.friction -= (power(sum.friction) + turning(sum.rim_torque) - turning(at_walls.all.rim_torque)) * kick;
  work.walls -= (power(at_walls.dissipative) + turning(at_walls.all.rim_torque)) * kick;
  work.damping += sum.lost;
  work.walls += at_walls.all.lost;
}

/// The push of the walls on grain i. The force of each wall is also stored with its pair.
template <bool Synchronised, bool Full, int D, class Law>
WallPush<D, Full> push_of_walls(const SweepInput<D, Law>& in, const Grains<D>& grains, std::size_t i, Part<D>& mine) {
  WallPush<D, Full> sum;
  const auto& grain = grains.line[i];
  const auto& walls = in.settings.walls;
  const double dt = in.settings.time_step;
  auto* const row = in.walls.pairs.data() + in.walls.row_start[i];
  const auto pairs = in.walls.row_start[i + 1] - in.walls.row_start[i];
  auto& contacts = mine.at_walls;
  find_wall_contacts(in.laws, grain, grains.material[i], row, pairs, walls, mine.walls_now, in.settings.box, contacts);
  pass_on_displacements(contacts, row);
  auto next = contacts.all().begin();
  for (std::uint32_t k = 0; k < pairs; ++k) {
    auto& contact = row[k];
    const bool in_reach = next != contacts.all().end() && next->entry == k;
    const auto* const touch = in_reach ? &*next++ : nullptr;
    if (!in_reach || !contacts.acts(*touch)) {
      forget(contact);
      contact.force = {};
      contact.dissipative = {};
      continue;
    }
    const auto& wall = walls[contact.wall];
    const auto& law = in.laws.of(grains.material[i], wall.material);
    const auto& now = mine.walls_now[contact.wall];
    contact.surface = surface_velocity(now, *touch);
    const auto pair = wall_geometry(law, grain, wall, now, touch->place, contact.surface);
    auto history = history_of(contact, pair.normal);
    const auto force = wall_contact(law, wall, pair, contact_times<Synchronised>(in), history);
    keep(history, contact);
    Push<D, Full> push;
    to_push(pair, force, grain.radius, grain.radius, push);
    contact.force = push.force;
    contact.impulse += push.force * dt;
    sum.all.force += push.force;
    sum.all.rim_torque += push.rim_torque;
    if constexpr (Full) {
      contact.dissipative = push.damping + push.friction;
      sum.dissipative += contact.dissipative;
      if (contact.bonded != 0 && !history.bonded) sum.all.lost += energy_of_break(law.cohesion, pair.touch);
      contact.bonded = history.bonded ? 1 : 0;
    }
  }
  return sum;
}

/// Moves a grain and adds the work done on it. Returns its mean velocities over the kick.
template <bool Synchronised, bool Full, int D, class Law>
REPOSE_FN HalfStep<D> finish_row(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i,
                                 const Slot<D, Full>& sum, const WallPush<D, Full>& at_walls) {
  const auto mean = kick_and_drift<Synchronised>(in, grains, i, sum);
  if constexpr (Full) {
    if (!in.work.empty()) add_work(in.work[i], sum, at_walls, mean, in.kick);
  }
  return mean;
}

/// Finishes the row of a grain that is fixed, near a wall or loaded.
template <bool Synchronised, bool Full, int D, class Law>
void finish_special_row(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i, Part<D>& mine,
                        const Slot<D, Full>& of_pairs) {
  if (grains.line[i].fixed()) {
    grains.reaction[i] += of_pairs.force * in.settings.time_step;
    return;
  }
  Slot<D, Full> sum = of_pairs;
  WallPush<D, Full> at_walls;
  if (in.walls.any()) {
    at_walls = push_of_walls<Synchronised, Full>(in, grains, i, mine);
    sum.force += at_walls.all.force;
    sum.rim_torque += at_walls.all.rim_torque;
  }
  auto load = std::lower_bound(in.loaded.begin(), in.loaded.end(), i,
                               [](const LoadedGrain<D>& grain, std::size_t row) { return grain.i < row; });
  const auto first_load = load;
  for (; load != in.loaded.end() && load->i == i; ++load) sum.force += load->force;
  const auto velocity = finish_row<Synchronised>(in, grains, i, sum, at_walls).velocity;
  for (auto done = first_load; done != load; ++done) in.load_work[done->load] += dot(done->force, velocity) * in.kick;
}

/// Moves the walls under the push of the grains in this step. Every member does it for itself, after all sweeps.
template <int D, class Law>
void move_walls(const SweepInput<D, Law>& in, Part<D>& mine) {
  const double dt = in.settings.time_step;
  for (std::size_t w = 0; w < in.settings.walls.size(); ++w) {
    const auto& wall = in.settings.walls[w];
    auto& state = mine.walls[w];
    const bool moves = wall.motion.kind != WallMotion<D>::Kind::none;
    if (moves) {
      Vec<D> force{};
      Vec<D> dissipative{};
      for (const auto k : in.walls.of_wall[w]) {
        const auto& contact = in.walls.pairs[k];
        force += contact.force;
        dissipative += contact.dissipative;
        state.work += dot(contact.force, contact.surface) * in.kick;
        state.dissipated += dot(contact.dissipative, contact.surface) * in.kick;
      }
      const double before = state.speed;
      kick_wall(wall.motion, state, static_cast<double>(in.step) * dt, in.kick, dt, Vec<D>(-force));
      state.displacement += state.speed * dt;
      const Vec<D> displacement = wall.motion.direction * (0.5 * (before + state.speed) * in.kick);
      state.work += dot(force, displacement);
      state.dissipated += dot(dissipative, displacement);
    }
    mine.walls_now[w] = wall_now(wall, state, static_cast<double>(in.step + 1) * dt);
  }
}

}  // namespace repose::soft
