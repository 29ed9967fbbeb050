// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/instruction_set.hpp"
#include "repose/methods/soft/fused_laws.hpp"
#include "repose/methods/soft/rows/row_sweep.hpp"
#include "repose/methods/soft/step.hpp"

#include <algorithm>
#include <limits>
#include <vector>

/// The fused kernels: laws chosen when they are compiled, several pairs at a time. A block of rows is computed in two
/// loops, the pushes of its pairs and then their sums, since sums depend on each other and pairs do not.
namespace repose::soft {

/// The working memory of one member.
template <int D>
struct RowSpace : Part<D> {
  std::vector<Edge<D>> edge_pairs;
  std::vector<RowArrival<D>> received;
  std::vector<RowSum<D>> window;
  std::vector<RowSum<D>> push;
  std::vector<RowSum<D>> special_sum;
  bool numbered = false;  ///< the pairs of these rows have their grains in the arrays of the kernel
};

template <int D, class Law>
class FusedKernel {
 public:
  using Space = RowSpace<D>;

  explicit FusedKernel(const SoftSettings<D>&) : set_(chosen_instruction_set()) {}

  /// Makes room after the parts have their edges and special grains.
  void prepare(std::vector<Space>& spaces, const MaterialTable<Law>& laws, const PairList<D>& pairs,
               const Grains<D>& grains) {
    line_.resize(grains.size());
    first_.resize(pairs.pairs());
    second_.resize(pairs.pairs());
    const std::uint16_t first = grains.size() > 0 ? grains.material.front() : std::uint16_t{0};
    one_material_ = laws.single() || std::all_of(grains.material.begin(), grains.material.end(),
                                                 [&](auto material) { return material == first; });
    const auto& law = laws.single() ? laws.first() : laws.of(first, first);
    law_ = one_material_ ? &law : laws.all().data();
    const bool packs =
        std::all_of(laws.all().begin(), laws.all().end(), [](const Law& each) { return goes_in_packs(each); });
    sweep_ = packs ? sweep_of(set_) : &sweep_rows_scalar<D, Law>;
    for (auto& space : spaces) make_room(space, spaces, pairs);
  }

  /// Takes the state of the grains of a member, or gives it back.
  void take(const Grains<D>& grains, Space& mine, const PairList<D>& pairs) {
    for (auto i = mine.rows.begin; i < mine.rows.end; ++i) line_[i] = line_of(grains.line[i]);
    if (!mine.numbered) number_pairs(mine, pairs);
  }
  void give(Grains<D>& grains, const Space& mine) const {
    for (auto i = mine.rows.begin; i < mine.rows.end; ++i) soft::take(line_[i], grains.line[i]);
  }

  Vec<D> position(const Grains<D>&, std::size_t i) const {
    Vec<D> position;
    for (int k = 0; k < D; ++k) position[k] = line_[i].position[k];
    return position;
  }

  /// One step of one member over its grains. The walls are moved later.
  void step(const SweepInput<D, Law>& in, Grains<D>& grains, std::vector<Space>& spaces, Team& team, int member) {
    auto& mine = spaces[static_cast<std::size_t>(member)];
    auto sweep = sweep_over(in, grains, mine);
    compute_edges(sweep);
    team.wait();
    sweep_(sweep);
    for (int k = 0; k < D; ++k) mine.fastest[k] = sweep.fastest[k];
    mine.trouble = sweep.trouble;
    for (std::size_t s = 0; s + 1 < mine.special.size(); ++s) finish(in, grains, mine, s);
    team.wait();
  }

 private:
  using Sweep = void (*)(RowSweep<D, Law>&);

  static Sweep sweep_of(InstructionSet set) {
    switch (set) {
      case InstructionSet::scalar:
        return &sweep_rows_scalar<D, Law>;
      case InstructionSet::baseline:
        return &sweep_rows_baseline<D, Law>;
#if defined(__x86_64__)
      case InstructionSet::avx2:
        return &sweep_rows_avx2<D, Law>;
      case InstructionSet::avx512:
        return &sweep_rows_avx512<D, Law>;
#else
      default:
        break;
#endif
    }
    return &sweep_rows_scalar<D, Law>;
  }

  void number_pairs(Space& space, const PairList<D>& pairs) {
    for (auto i = static_cast<std::uint32_t>(space.rows.begin); i < space.rows.end; ++i) {
      for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) {
        first_[k] = i;
        second_[k] = pairs.partner[k];
      }
    }
    for (const auto& edge : space.edges) second_[edge.k] = edge.i;
    space.numbered = true;
  }

  static void make_room(Space& space, const std::vector<Space>& spaces, const PairList<D>& pairs) {
    constexpr auto after_all = std::numeric_limits<std::size_t>::max();
    space.edge_pairs.clear();
    for (const auto& [i, k] : space.edges) space.edge_pairs.push_back({k, i, pairs.partner[k], {}, {}});
    space.edge_pairs.push_back({after_all, 0, 0, {}, {}});
    const auto rows = space.rows.end - space.rows.begin;
    const auto needed = pairs.bandwidth + rows_of_block<D> + 1;
    space.window.assign(std::min(4 * needed, rows + needed), {});
    std::size_t most = 0;
    for (auto row = space.rows.begin; row < space.rows.end; row += rows_of_block<D>) {
      const auto end = std::min(row + rows_of_block<D>, space.rows.end);
      most = std::max<std::size_t>(most, pairs.row_start[end] - pairs.row_start[row]);
    }
    space.push.resize(most + 2 * widest_pack);
    space.special_sum.assign(space.special.size(), {});
    space.received.clear();
    for (const auto& arrival : space.arrivals) {
      space.received.push_back({arrival.j, &spaces[arrival.member].edge_pairs[arrival.edge].push});
    }
    space.received.push_back({after_all, nullptr});
  }

  RowSweep<D, Law> sweep_over(const SweepInput<D, Law>& in, Grains<D>& grains, Space& mine) {
    const auto& box = in.settings.box;
    RowSweep<D, Law> sweep{};
    sweep.laws = law_;
    sweep.material = one_material_ ? nullptr : grains.material.data();
    sweep.materials = in.laws.materials();
    for (int axis = 0; axis < D - 1; ++axis) {
      const bool wraps = wraps_along(box, axis);
      sweep.periods.length[axis] = wraps ? length_along(box, axis) : 0.0;
      sweep.periods.half[axis] = wraps ? 0.5 * length_along(box, axis) : std::numeric_limits<double>::infinity();
    }
    sweep.time_step = in.settings.time_step;
    sweep.kick = in.kick;
    sweep.before = in.step > 0 ? 0.5 * in.settings.time_step : 0.0;
    for (int k = 0; k < D; ++k) sweep.gravity[k] = in.settings.gravity[k];
    sweep.speed_limit = in.speed_limit;
    sweep.synchronised = in.settings.synchronised;
    sweep.line = line_.data();
    sweep.half_step = grains.half_step.data();
    sweep.row_start = in.pairs.row_start.data();
    sweep.first = first_.data();
    sweep.second = second_.data();
    sweep.slip = in.pairs.slip.data();
    sweep.begin = mine.rows.begin;
    sweep.end = mine.rows.end;
    sweep.bandwidth = in.pairs.bandwidth;
    sweep.window = mine.window.data();
    sweep.capacity = mine.window.size();
    sweep.push = mine.push.data();
    sweep.edges = mine.edge_pairs.data();
    sweep.edge_count = mine.edges.size();
    sweep.arrivals = mine.received.data();
    sweep.special = mine.special.data();
    sweep.special_sum = mine.special_sum.data();
    return sweep;
  }

  /// Finishes a special row, which the sweep has left out.
  void finish(const SweepInput<D, Law>& in, Grains<D>& grains, Space& mine, std::size_t s) {
    const auto i = mine.special[s];
    const auto& from = mine.special_sum[s].value;
    Slot<D> sum;
    for (int k = 0; k < D; ++k) {
      sum.force[k] = from[k];
      if constexpr (D == 3) sum.rim_torque[k] = from[4 + k];
    }
    if constexpr (D == 2) sum.rim_torque = from[2];
    if (line_[i].inverse_mass == 0.0) {  // a base has many of them
      grains.reaction[i] += sum.force * in.settings.time_step;
      return;
    }
    auto& grain = grains.line[i];
    soft::take(line_[i], grain);
    if (in.settings.synchronised) {
      finish_special_row<true, false>(in, grains, i, mine, sum);
    } else {
      finish_special_row<false, false>(in, grains, i, mine, sum);
    }
    follow(grain, line_[i]);
    watch(grain.velocity, in.speed_limit, mine);
  }

  InstructionSet set_;
  Sweep sweep_ = nullptr;
  const Law* law_ = nullptr;
  bool one_material_ = true;
  std::vector<Line<D>> line_;
  std::vector<std::uint32_t> first_;   // of each pair
  std::vector<std::uint32_t> second_;  // of each pair; of an edge pair the first grain again
};

}  // namespace repose::soft
