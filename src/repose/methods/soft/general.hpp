// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/soft/step.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

/// The general kernel: any law, chosen at run time, with resistance to rolling and twisting, bonds, damping and the
/// energy budget. It computes one pair after the other, and is the reference that the fused kernels equal to the bit.
namespace repose::soft {

/// The working memory of one member.
template <int D>
struct GeneralSpace : Part<D> {
  std::vector<Push<D, true>> edge_push;    ///< forces of the edge pairs in this step
  std::vector<Slot<D, true>> ring;         ///< its size is a power of two above the bandwidth
  std::vector<Slot<D, true>> special_sum;  ///< sums of the pushes on special grains by other grains
};

template <int D, class Law>
class GeneralKernel {
 public:
  using Space = GeneralSpace<D>;

  explicit GeneralKernel(const SoftSettings<D>&) {}

  /// Makes room after the parts have their edges and special grains.
  void prepare(std::vector<Space>& spaces, const MaterialTable<Law>&, const PairList<D>& pairs, const Grains<D>&) {
    for (auto& space : spaces) {
      space.edge_push.resize(space.edges.size());
      space.ring.assign(std::bit_ceil(static_cast<std::size_t>(pairs.bandwidth) + 1), {});
      space.special_sum.assign(space.special.size(), {});
    }
  }

  // It moves the grains themselves.
  void take(const Grains<D>&, Space&, const PairList<D>&) {}
  void give(Grains<D>&, const Space&) const {}
  Vec<D> position(const Grains<D>& grains, std::size_t i) const { return grains.line[i].position; }

  void step(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Space>& spaces, Team& team, int member);
};

template <bool Periodic, bool Synchronised, int D, class Law>
void push_edges(const SweepInput<D, Law>& in, const Grains<D>& grains, GeneralSpace<D>& mine) {
  std::uint8_t no_bond = 0;
  double no_twist = 0.0;
  for (std::size_t e = 0; e < mine.edges.size(); ++e) {
    const auto [i, k] = mine.edges[e];
    const auto j = in.pairs.partner[k];
    mine.edge_push[e] = {};
    pair_force<Periodic>(in.laws.of(grains.material[i], grains.material[j]), grains.line[i], grains.line[j],
                         in.settings.box, contact_times<Synchronised>(in), in.pairs.slip[k], in.pairs.roll[k],
                         in.pairs.twist.empty() ? no_twist : in.pairs.twist[k],
                         in.pairs.bonded.empty() ? no_bond : in.pairs.bonded[k], mine.edge_push[e]);
  }
}

template <bool Periodic, bool Synchronised, int D, class Law>
void sweep_rows(const SweepInput<D, Law>& in, Grains<D>& grains, const std::vector<GeneralSpace<D>>& spaces,
                GeneralSpace<D>& mine) {
  const Box<D> box = in.settings.box;
  const auto times = contact_times<Synchronised>(in);
  const std::uint32_t* const row_start = in.pairs.row_start.data();
  const std::uint32_t* const partner = in.pairs.partner.data();
  Tangent<D>* const history = in.pairs.slip.data();
  Tangent<D>* const roll = in.pairs.roll.data();
  double* const twist = in.pairs.twist.empty() ? nullptr : in.pairs.twist.data();
  std::uint8_t* const bonded = in.pairs.bonded.empty() ? nullptr : in.pairs.bonded.data();
  std::uint8_t no_bond = 0;
  double no_twist = 0.0;
  Grain<D>* const line = grains.line.data();
  Slot<D, true>* const ring = mine.ring.data();
  const std::size_t mask = mine.ring.size() - 1;

  auto arrival = mine.arrivals.begin();
  const auto receive_up_to = [&](std::size_t last) {
    for (; arrival != mine.arrivals.end() && arrival->j <= last; ++arrival) {
      ring[arrival->j & mask].add_back(spaces[arrival->member].edge_push[arrival->edge]);
    }
  };
  if (mine.rows.begin < mine.rows.end) receive_up_to(mine.rows.begin + mask);

  const std::uint32_t* special = mine.special.data();
  Slot<D, true>* special_sum = mine.special_sum.data();
  mine.fastest = {};
  mine.trouble = false;
  std::size_t edge = 0;
  for (std::size_t row = mine.rows.begin; row < mine.rows.end; ++row) {
    const auto i = static_cast<std::uint32_t>(row);
    Slot<D, true> sum = ring[i & mask];
    ring[i & mask] = {};
    const Grain<D>& grain = line[i];
    const auto ring_stop = ring_end(mine.rows, i, PairList<D>::far);
    const auto row_stop = row_start[i + 1];
    auto k = row_start[i];
    for (; k < row_stop && partner[k] < ring_stop; ++k) {
      const auto j = partner[k];
      Push<D, true> push;
      const Law& law = in.laws.of(grains.material[i], grains.material[j]);
      auto& bond = bonded == nullptr ? no_bond : bonded[k];
      auto& about = twist == nullptr ? no_twist : twist[k];
      if (!pair_force<Periodic>(law, grain, line[j], box, times, history[k], roll[k], about, bond, push)) continue;
      sum.add(push);
      ring[j & mask].add_back(push);
    }
    for (; k < row_stop; ++k, ++edge) sum.add(mine.edge_push[edge]);
    if (i == *special) [[unlikely]] {
      ++special;
      *special_sum++ = sum;
    } else {
      finish_row<Synchronised>(in, grains, i, sum, WallPush<D, true>{});
      watch(line[i].velocity, in.speed_limit, mine);
    }
    receive_up_to(row + 1 + mask);
  }
  // Nothing needs the old state of a row after the sweep has passed it, so these rows can be finished last. A call in
  // the loop would slow all rows down, because it would spill their registers.
  for (std::size_t s = 0; s + 1 < mine.special.size(); ++s) {
    finish_special_row<Synchronised, true>(in, grains, mine.special[s], mine, mine.special_sum[s]);
    watch(line[mine.special[s]].velocity, in.speed_limit, mine);
  }
}

/// One step of one member over its grains. The walls are moved later.
template <int D, class Law>
void GeneralKernel<D, Law>::step(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Space>& spaces,
                                 Team& team, int member) {
  auto& mine = spaces[static_cast<std::size_t>(member)];
  const auto with_flag = [](bool flag, const auto& use) { flag ? use(std::true_type{}) : use(std::false_type{}); };
  with_flag(in.settings.box.wraps(), [&](auto periodic) {
    with_flag(in.settings.synchronised, [&](auto synchronised) {
      push_edges<periodic, synchronised>(in, grains, mine);
      team.wait();
      sweep_rows<periodic, synchronised>(in, grains, spaces, mine);
    });
  });
  team.wait();
}

}  // namespace repose::soft
