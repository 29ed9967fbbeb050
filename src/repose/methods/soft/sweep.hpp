// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/soft/audit.hpp"
#include "repose/methods/soft/laws_of_materials.hpp"
#include "repose/methods/soft/partition.hpp"
#include "repose/methods/soft/settings.hpp"
#include "repose/methods/soft/wall_list.hpp"

#include <algorithm>
#include <vector>

/// The step of the soft method over one member's grains.
///
/// Grains are taken in memory order. Every pair (i, j) has j > i, so when the sweep comes to grain i all its pairs with
/// earlier grains are done and their forces wait in its slot of the ring; its own pairs follow, and then nothing else
/// needs its old state: it is kicked and drifts at once, in place. Forces that cross to another member's range (or lie
/// too far apart in memory for the ring) come from the edge pairs, computed beforehand. The sum on each grain is taken
/// in one order, ascending by partner, whatever the number of members: the results are the same to the bit.
namespace repose::soft {

/// What one sweep works on.
template <int D, class Law>
struct SweepInput {
  const LawsOfMaterials<Law>& laws;
  const SoftSettings<D>& settings;
  PairList<D>& pairs;
  WallList<D>& walls;
  std::vector<GrainWork>& work;               ///< per grain; empty unless the energy is audited
  const std::vector<LoadedGrain<D>>& loaded;  ///< ascending
  std::vector<double>& load_work;             ///< [M L^2/T^2] per load
  double kick;                                ///< [T] half a step at the start of time, else a step
  long step;                                  ///< number of this step
  double speed_limit2;                        ///< [L^2/T^2] beyond this a grain cannot be followed
};

template <bool Periodic, bool Full, int D, class Law>
void push_edges(const SweepInput<D, Law>& in, const Grains<D>& grains, Share<D, Full>& share) {
  Tangent<D> no_roll{};
  for (std::size_t e = 0; e < share.edges.size(); ++e) {
    const auto [i, k] = share.edges[e];
    const auto j = in.pairs.partner[k];
    share.edge_push[e] = {};
    pair_force<Periodic>(in.laws.of(grains.material[i], grains.material[j]), grains.line[i], grains.line[j],
                         in.settings.box, in.settings.time_step, in.pairs.history[k], Full ? in.pairs.roll[k] : no_roll,
                         share.edge_push[e]);
  }
}

/// Moves one grain by leapfrog under its total push. Source: Baxter et al. (1997), (9)-(12). Returns the mean
/// velocities over the kick.
template <bool Synchronised, bool Full, int D, class Law>
REPOSE_FN HalfStep<D> kick_and_drift(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i,
                                     const Slot<D, Full>& sum) {
  auto& grain = grains.line[i];
  const double dt = in.settings.time_step;
  const double per_mass = in.kick * grain.inverse_mass;
  const Vec<D> kick = (sum.force + in.settings.gravity * grain.mass) * per_mass;
  const Spin<D> rim_kick = sum.rim_torque * (per_mass * inverse_inertia_factor<D>);
  if constexpr (Synchronised) {
    auto& half = grains.half_step[i];
    half.velocity += kick;
    half.rim_velocity += rim_kick;
    grain.position += half.velocity * dt;
    grain.velocity = half.velocity + kick * 0.5;
    grain.rim_velocity = half.rim_velocity + rim_kick * 0.5;
    return {half.velocity - kick * 0.5, half.rim_velocity - rim_kick * 0.5};
  } else {
    grain.velocity += kick;
    grain.rim_velocity += rim_kick;
    grain.position += grain.velocity * dt;
    return {grain.velocity - kick * 0.5, grain.rim_velocity - rim_kick * 0.5};
  }
}

/// Forces of the walls on grain i, kept with each pair, and added to its sum; in a full kernel, what of them dissipates
/// goes to `dissipative` instead of the sum's own parts.
template <bool Full, int D, class Law>
void push_walls(const SweepInput<D, Law>& in, const Grains<D>& grains, std::size_t i, const Share<D, Full>& mine,
                Slot<D, Full>& sum, Push<D, Full>& dissipative) {
  const auto& grain = grains.line[i];
  const double dt = in.settings.time_step;
  for (auto k = in.walls.row_start[i]; k < in.walls.row_start[i + 1]; ++k) {
    auto& contact = in.walls.pairs[k];
    const auto& wall = in.settings.walls[contact.wall];
    const auto& law = in.laws.of(grains.material[i], wall.material);
    PairGeometry<D> pair;
    if (!wall_geometry(law, grain, wall, mine.walls_now[contact.wall], in.settings.box, pair)) {
      contact.slip = {};
      contact.roll = {};
      contact.force = {};
      contact.dissipative = {};
      continue;
    }
    ContactHistory<Tangent<D>> history{turned(contact.slip, pair.normal), turned(contact.roll, pair.normal)};
    const auto force = wall_contact(law, wall, pair, dt, history);
    contact.slip = history.slip;
    contact.roll = history.roll;
    Push<D, Full> push;
    set_push(pair, force, grain.radius, grain.radius, push);
    contact.force = push.force;
    contact.impulse += push.force * dt;
    sum.force += push.force;
    sum.rim_torque += push.rim_torque;
    if constexpr (Full) {
      contact.dissipative = push.damping + push.friction;
      dissipative.force += contact.dissipative;
      dissipative.rim_torque += push.rim_torque;
    }
  }
}

/// Moves the walls under the push of the grains in this step. Every member does it for itself, after all have swept.
template <bool Full, int D, class Law>
void move_walls(const SweepInput<D, Law>& in, Share<D, Full>& mine) {
  const double dt = in.settings.time_step;
  for (std::size_t w = 0; w < in.settings.walls.size(); ++w) {
    const auto& wall = in.settings.walls[w];
    auto& state = mine.walls[w];
    const bool moves = wall.motion.kind != WallMotion<D>::Kind::none;
    if (moves) {
      Vec<D> force{};
      Vec<D> dissipative{};
      for (const auto k : in.walls.of_wall[w]) {
        force += in.walls.pairs[k].force;
        dissipative += in.walls.pairs[k].dissipative;
      }
      const double before = state.speed;
      move_wall(wall.motion, state, static_cast<double>(in.step) * dt, in.kick, dt, -force);
      const Vec<D> way = wall.motion.direction * (0.5 * (before + state.speed) * in.kick);
      state.work += dot(force, way);
      state.dissipated += dot(dissipative, way);
    }
    mine.walls_now[w] = wall_now(wall, state, static_cast<double>(in.step + 1) * dt);
  }
}

template <bool Periodic, bool Synchronised, bool OneMaterial, bool Full, int D, class Law>
void sweep_rows(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Share<D, Full>>& shares,
                Share<D, Full>& mine) {
  const Law law = in.laws.first();
  const Box<D> box = in.settings.box;
  const double dt = in.settings.time_step;
  const std::uint32_t* const row_start = in.pairs.row_start.data();
  const std::uint32_t* const partner = in.pairs.partner.data();
  Tangent<D>* const history = in.pairs.history.data();
  Tangent<D>* const roll = in.pairs.roll.data();
  Grain<D>* const line = grains.line.data();
  Slot<D, Full>* const ring = mine.ring.data();
  const std::size_t mask = mine.ring.size() - 1;
  const bool walls = in.walls.any();
  const bool audit = !in.work.empty();

  auto arrival = mine.arrivals.begin();
  const auto receive_up_to = [&](std::size_t last) {
    for (; arrival != mine.arrivals.end() && arrival->j <= last; ++arrival) {
      ring[arrival->j & mask].add_back(shares[arrival->member].edge_push[arrival->edge]);
    }
  };
  if (mine.rows.begin < mine.rows.end) receive_up_to(mine.rows.begin + mask);

  auto loaded = std::lower_bound(in.loaded.begin(), in.loaded.end(), mine.rows.begin,
                                 [](const LoadedGrain<D>& grain, std::size_t row) { return grain.i < row; });
  double fastest2 = 0.0;
  bool trouble = false;
  std::size_t edge = 0;
  Tangent<D> no_roll{};
  for (std::size_t row = mine.rows.begin; row < mine.rows.end; ++row) {
    const auto i = static_cast<std::uint32_t>(row);
    Slot<D, Full> sum = ring[i & mask];
    ring[i & mask] = {};
    const Grain<D>& grain = line[i];
    const auto ring_stop = ring_end(mine.rows, i, PairList<D>::far);
    const auto row_stop = row_start[i + 1];
    auto k = row_start[i];
    for (; k < row_stop && partner[k] < ring_stop; ++k) {
      const auto j = partner[k];
      Push<D, Full> push;
      const Law& pair_law = OneMaterial ? law : in.laws.of(grains.material[i], grains.material[j]);
      if (!pair_force<Periodic>(pair_law, grain, line[j], box, dt, history[k], Full ? roll[k] : no_roll, push)) {
        continue;
      }
      sum.add(push);
      ring[j & mask].add_back(push);
    }
    for (; k < row_stop; ++k, ++edge) sum.add(mine.edge_push[edge]);
    Push<D, Full> at_walls;
    if (walls && in.walls.row_start[i] != in.walls.row_start[i + 1]) {
      push_walls(in, grains, i, mine, sum, at_walls);
    }
    if (grain.fixed()) [[unlikely]] {
      grains.reaction[i] += sum.force * dt;
    } else {
      const auto first_load = loaded;
      for (; loaded != in.loaded.end() && loaded->i == i; ++loaded) sum.force += loaded->force;
      const auto mean = kick_and_drift<Synchronised>(in, grains, i, sum);
      const double speed2 = dot(line[i].velocity, line[i].velocity);
      trouble |= !(speed2 < in.speed_limit2);  // also true for what is not a number
      fastest2 = std::max(fastest2, speed2);
      for (auto load = first_load; load != loaded; ++load) {
        in.load_work[load->load] += dot(load->force, mean.velocity) * in.kick;
      }
      if constexpr (Full) {
        if (audit) {
          auto& work = in.work[i];
          const auto power = [&](const Vec<D>& force) { return dot(force, mean.velocity); };
          const auto turning = [&](const Spin<D>& rim_torque) { return inner(rim_torque, mean.rim_velocity); };
          work.damping -= power(sum.damping) * in.kick;
          work.friction -= (power(sum.friction) + turning(sum.rim_torque) - turning(at_walls.rim_torque)) * in.kick;
          work.walls -= (power(at_walls.force) + turning(at_walls.rim_torque)) * in.kick;
        }
      }
    }
    receive_up_to(row + 1 + mask);
  }
  mine.fastest2 = fastest2;
  mine.trouble = trouble;
}

/// One step of one member over its grains; the walls have yet to be moved.
template <int D, class Law, bool Full>
void sweep(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Share<D, Full>>& shares, Team& team,
           int member) {
  auto& mine = shares[static_cast<std::size_t>(member)];
  const auto with_flag = [](bool flag, const auto& use) { flag ? use(std::true_type{}) : use(std::false_type{}); };
  with_flag(in.settings.box.periodic, [&](auto periodic) {
    push_edges<periodic>(in, grains, mine);
    team.wait();
    with_flag(in.settings.synchronised, [&](auto synchronised) {
      if constexpr (Full) {
        sweep_rows<periodic, synchronised, false>(in, grains, shares, mine);
      } else {
        with_flag(in.laws.single(), [&](auto one_material) {
          sweep_rows<periodic, synchronised, one_material>(in, grains, shares, mine);
        });
      }
    });
  });
  team.wait();
}

}  // namespace repose::soft
