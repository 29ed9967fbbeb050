// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/soft/laws_of_materials.hpp"
#include "repose/methods/soft/partition.hpp"
#include "repose/methods/soft/settings.hpp"

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
  std::vector<std::vector<Tangent<D>>>& plane_history;  ///< per plane and grain
  double kick;                                          ///< [T] half a step at the start of time, else a step
  double speed_limit2;                                  ///< [L^2/T^2] beyond this a grain cannot be followed
};

template <bool Periodic, int D, class Law>
void push_edges(const SweepInput<D, Law>& in, const Grains<D>& grains, Share<D>& share) {
  for (std::size_t e = 0; e < share.edges.size(); ++e) {
    const auto [i, k] = share.edges[e];
    const auto j = in.pairs.partner[k];
    share.edge_push[e] = {};
    pair_force<Periodic>(in.laws.of(grains.material[i], grains.material[j]), grains.line[i], grains.line[j],
                         in.settings.box, in.settings.time_step, in.pairs.history[k], share.edge_push[e]);
  }
}

/// Moves one grain by leapfrog under its total push. Source: Baxter et al. (1997), (9)-(12).
template <bool Synchronised, int D, class Law>
REPOSE_FN void kick_and_drift(const SweepInput<D, Law>& in, Grains<D>& grains, std::size_t i, const Slot<D>& sum) {
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
  } else {
    grain.velocity += kick;
    grain.rim_velocity += rim_kick;
    grain.position += grain.velocity * dt;
  }
}

template <bool Periodic, bool Synchronised, bool OneMaterial, int D, class Law>
void sweep_rows(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Share<D>>& shares, Share<D>& mine) {
  const Law law = in.laws.first();
  const Box<D> box = in.settings.box;
  const double dt = in.settings.time_step;
  const std::uint32_t* const row_start = in.pairs.row_start.data();
  const std::uint32_t* const partner = in.pairs.partner.data();
  Tangent<D>* const history = in.pairs.history.data();
  Grain<D>* const line = grains.line.data();
  Slot<D>* const ring = mine.ring.data();
  const std::size_t mask = mine.ring.size() - 1;

  auto arrival = mine.arrivals.begin();
  const auto receive_up_to = [&](std::size_t last) {
    for (; arrival != mine.arrivals.end() && arrival->j <= last; ++arrival) {
      const auto& push = shares[arrival->member].edge_push[arrival->edge];
      auto& slot = ring[arrival->j & mask];
      slot.force -= push.force;
      slot.rim_torque += push.rim_torque;
    }
  };
  if (mine.rows.begin < mine.rows.end) receive_up_to(mine.rows.begin + mask);

  double fastest2 = 0.0;
  bool trouble = false;
  std::size_t edge = 0;
  for (std::size_t row = mine.rows.begin; row < mine.rows.end; ++row) {
    const auto i = static_cast<std::uint32_t>(row);
    Slot<D> sum = ring[i & mask];
    ring[i & mask] = {};
    const Grain<D>& grain = line[i];
    const auto ring_stop = ring_end(mine.rows, i, PairList<D>::far);
    const auto row_stop = row_start[i + 1];
    auto k = row_start[i];
    for (; k < row_stop && partner[k] < ring_stop; ++k) {
      const auto j = partner[k];
      Push<D> push;
      const Law& pair_law = OneMaterial ? law : in.laws.of(grains.material[i], grains.material[j]);
      if (!pair_force<Periodic>(pair_law, grain, line[j], box, dt, history[k], push)) continue;
      sum.force += push.force;
      sum.rim_torque += push.rim_torque;
      ring[j & mask].force -= push.force;
      ring[j & mask].rim_torque += push.rim_torque;
    }
    for (; k < row_stop; ++k, ++edge) {
      sum.force += mine.edge_push[edge].force;
      sum.rim_torque += mine.edge_push[edge].rim_torque;
    }
    for (std::size_t p = 0; p < in.settings.planes.size(); ++p) {
      Push<D> push;
      const Law& own_law = OneMaterial ? law : in.laws.of(grains.material[i], grains.material[i]);
      if (!grain.fixed() && plane_force(own_law, grain, in.settings.planes[p], dt, in.plane_history[p][i], push)) {
        sum.force += push.force;
        sum.rim_torque += push.rim_torque;
      }
    }
    if (grain.fixed()) [[unlikely]] {
      grains.reaction[i] += sum.force * dt;
    } else {
      kick_and_drift<Synchronised>(in, grains, i, sum);
      const double speed2 = dot(line[i].velocity, line[i].velocity);
      trouble |= !(speed2 < in.speed_limit2);  // also true for what is not a number
      fastest2 = std::max(fastest2, speed2);
    }
    receive_up_to(row + 1 + mask);
  }
  mine.fastest2 = fastest2;
  mine.trouble = trouble;
}

template <int D, class Law>
void sweep(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Share<D>>& shares, Team& team, int member) {
  auto& mine = shares[static_cast<std::size_t>(member)];
  const auto with_flag = [](bool flag, const auto& use) { flag ? use(std::true_type{}) : use(std::false_type{}); };
  with_flag(in.settings.box.periodic, [&](auto periodic) {
    push_edges<periodic>(in, grains, mine);
    team.wait();
    with_flag(in.settings.synchronised, [&](auto synchronised) {
      with_flag(in.laws.single(),
                [&](auto one_material) { sweep_rows<periodic, synchronised, one_material>(in, grains, shares, mine); });
    });
  });
  team.wait();
}

}  // namespace repose::soft
