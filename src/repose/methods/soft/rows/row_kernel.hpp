// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The sweep over the rows of a member, for the instruction set that the including source is compiled for. Everything is
// local to that source, and it calls only functions that are always inlined: the linker keeps one copy of any other
// inline function, and that copy must not contain instructions that the machine lacks.
#pragma once

#include "repose/methods/soft/pair_geometry.hpp"
#include "repose/methods/soft/rows/row_sweep.hpp"
#include "repose/methods/soft/rows/transposes.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace repose::soft {
namespace {

template <int D>
constexpr std::size_t numbers_of_line = sizeof(Line<D>) / sizeof(double);
template <int D>
constexpr std::size_t numbers_of_sum = sizeof(RowSum<D>) / sizeof(double);

/// Sums and differences of the lines of each pair.
template <int D>
REPOSE_FN PairMotion<D, Numbers> motion_of(const Line<D>* line, const std::uint32_t* first,
                                           const std::uint32_t* second) {
  PairMotion<D, Numbers> pair;
  if constexpr (D == 2) {
    Numbers sum[8];
    constexpr Four signs{-1.0, -1.0, 1.0, 1.0};
    sum_eights(line, first, second, signs, signs, sum);
    pair.velocity = {{sum[0], sum[1]}};
    pair.rim_velocity = sum[2];
    pair.nominal_inverse_mass = sum[3];
    pair.separation = {{sum[4], sum[5]}};
    pair.radii = sum[6];
    pair.inverse_mass = sum[7];
  } else {
    Numbers a[4];
    Numbers b[4];
    Numbers c[4];
    constexpr Four difference{-1.0, -1.0, -1.0, 1.0};
    sum_fours(line, first, second, 0, difference, a);
    sum_fours(line, first, second, 4, Four{1.0, 1.0, 1.0, 1.0}, b);
    sum_fours(line, first, second, 8, difference, c);
    pair.velocity = {{a[0], a[1], a[2]}};
    pair.nominal_inverse_mass = a[3];
    pair.rim_velocity = {{b[0], b[1], b[2]}};
    pair.inverse_mass = b[3];
    pair.separation = {{c[0], c[1], c[2]}};
    pair.radii = c[3];
  }
  return pair;
}

/// 2 R_i R_j / (R_i + R_j), which is no sum over the two grains; laws of a whole sweep use it or do not.
template <int D, class Law>
REPOSE_FN Numbers roll_radius(const Law&, const Line<D>* line, const std::uint32_t* first, const std::uint32_t* second,
                              const Numbers& radii) {
  if constexpr (std::is_same_v<decltype(Law::normal), ElasticHertz>) {
    double a[width];
    double b[width];
    for (std::size_t k = 0; k < width; ++k) {
      a[k] = line[std::size_t{first[k]}].radius;
      b[k] = line[std::size_t{second[k]}].radius;
    }
    return 2.0 * load(a) * load(b) / radii;
  } else {
    return Numbers(0.0);
  }
}

template <int D>
REPOSE_FN Tangent<D, Numbers> load_tangents(const Tangent<D>* from) {
  if constexpr (D == 2) {
    return load(from);
  } else {
    Numbers each[3];
    load_threes(&from[0][0], each);
    return {{each[0], each[1], each[2]}};
  }
}

template <int D>
REPOSE_FN void store_tangents(const Tangent<D, Numbers>& tangents, Tangent<D>* to) {
  if constexpr (D == 2) {
    store(tangents, to);
  } else {
    const Numbers each[3] = {tangents[0], tangents[1], tangents[2]};
    store_threes(each, &to[0][0]);
  }
}

/// The pushes of as many pairs as fit into a pack, each on its first grain. Their slip displacements advance. A pair
/// out of reach has neither. `Times` is the step [T], or HalfSteps where velocities are those of the time of the force.
template <int D, class Law, class Times>
REPOSE_FN void push_pairs(const Law& law, const Line<D>* line, const std::uint32_t* first, const std::uint32_t* second,
                          const Periods<D>& periods, const Times& times, Tangent<D>* slip, RowSum<D>* push) {
  auto motion = motion_of<D>(line, first, second);
  for (int axis = 0; axis < D - 1; ++axis) {
    const double length = periods.length[axis];
    const double half = periods.half[axis];
    if (length > 0.0) {
      auto& x = motion.separation[axis];
      x = choose(x > Numbers(half), x - length, x);
      x = choose(x < Numbers(-half), x + length, x);
    }
  }
  const Numbers distance2 = dot(motion.separation, motion.separation);
  const Numbers within = reach(law.normal) * motion.radii;
  const auto near = distance2 < within * within;
#if defined(REPOSE_SCALAR_ROWS)
  if (!near) {  // a pack computes such pairs too
    *slip = Tangent<D>{};
    *push = RowSum<D>{};
    return;
  }
#endif
  const auto pair = pair_geometry(motion, distance2, within, roll_radius(law, line, first, second, motion.radii));
  ContactHistory<Tangent<D, Numbers>> history{turned(load_tangents<D>(slip), pair.normal), {}};
  const auto force = contact_force(law, pair.touch, pair.slip_velocity, pair.roll_velocity, times, history);
  store_tangents<D>(choose(near, history.slip, Tangent<D, Numbers>{}), slip);
  Vec<D, Numbers> on_first;
  Spin<D, Numbers> rim_torque;
  to_push(pair, force, on_first, rim_torque);
  const Numbers zero(0.0);
  double* const to = push->value;
  if constexpr (D == 2) {
    const Numbers all[4] = {choose(near, on_first[0], zero), choose(near, on_first[1], zero),
                            choose(near, rim_torque, zero), zero};
    store_fours(all, to, numbers_of_sum<D>);
  } else {
    const Numbers forces[4] = {choose(near, on_first[0], zero), choose(near, on_first[1], zero),
                               choose(near, on_first[2], zero), zero};
    const Numbers torques[4] = {choose(near, rim_torque[0], zero), choose(near, rim_torque[1], zero),
                                choose(near, rim_torque[2], zero), zero};
    store_fours(forces, to, numbers_of_sum<D>);
    store_fours(torques, to + 4, numbers_of_sum<D>);
  }
}

/// The same where pairs of different materials have different laws: each law computes all pairs of the pack, and those
/// that are its own are kept.
template <int D, class Law, class Times>
REPOSE_FN void push_materials(const RowSweep<D, Law>& sweep, const std::uint32_t* first, const std::uint32_t* second,
                              const Times& times, Tangent<D>* slip, RowSum<D>* push) {
  std::size_t law[width];
  bool done[width];
  for (std::size_t k = 0; k < width; ++k) {
    law[k] = sweep.material[first[k]] * sweep.materials + sweep.material[second[k]];
    done[k] = false;
  }
  Tangent<D> before[width];
  for (std::size_t k = 0; k < width; ++k) before[k] = slip[k];
  for (std::size_t k = 0; k < width; ++k) {
    if (done[k]) continue;
    Tangent<D> slip_by_law[width];
    RowSum<D> push_by_law[width];
    for (std::size_t n = 0; n < width; ++n) slip_by_law[n] = before[n];
    push_pairs<D>(sweep.laws[law[k]], sweep.line, first, second, sweep.periods, times, slip_by_law, push_by_law);
    for (std::size_t n = k; n < width; ++n) {
      if (law[n] != law[k]) continue;
      slip[n] = slip_by_law[n];
      push[n] = push_by_law[n];
      done[n] = true;
    }
  }
}

/// Calls use(times) with the times by which contacts advance.
template <int D, class Law, class Use>
REPOSE_FN void with_times(const RowSweep<D, Law>& sweep, const Use& use) {
  if (sweep.synchronised) return use(HalfSteps{.before = sweep.before, .after = 0.5 * sweep.time_step});
  use(sweep.time_step);
}

/// Packs from `pair` on, with pushes from `push` on.
template <int D, class Law>
void push_packs(const RowSweep<D, Law>& sweep, std::size_t pair, std::size_t packs, RowSum<D>* push) {
  const Law law = sweep.laws[0];
  const Periods<D> periods = sweep.periods;
  const Line<D>* const line = sweep.line;
  const std::uint32_t* first = sweep.first + pair;
  const std::uint32_t* second = sweep.second + pair;
  Tangent<D>* slip = sweep.slip + pair;
  with_times(
      sweep, [&](const auto times) __attribute__((always_inline)) {
        for (std::size_t p = 0; p < packs; ++p) {
          if (sweep.material == nullptr) {
            push_pairs<D>(law, line, first, second, periods, times, slip, push);
          } else {
            push_materials(sweep, first, second, times, slip, push);
          }
          first += width;
          second += width;
          slip += width;
          push += width;
        }
      });
}

/// Fewer pairs than a pack has. The rest of the pack is a grain with itself, and is not stored.
template <int D, class Law>
void push_last(const RowSweep<D, Law>& sweep, std::size_t pair, std::size_t count, RowSum<D>* push) {
  std::uint32_t first[width];
  std::uint32_t second[width];
  Tangent<D> slip[width];
  for (std::size_t k = 0; k < width; ++k) {
    first[k] = sweep.first[k < count ? pair + k : pair];
    second[k] = k < count ? sweep.second[pair + k] : first[k];
    slip[k] = k < count ? sweep.slip[pair + k] : Tangent<D>{};
  }
  RowSweep<D, Law> last = sweep;
  last.first = first;
  last.second = second;
  last.slip = slip;
  push_packs(last, 0, 1, push);
  for (std::size_t k = 0; k < count; ++k) sweep.slip[pair + k] = slip[k];
}

/// The kick and drift of a row by leapfrog. Source: Baxter et al. (1997), (9)-(12).
template <int D>
struct Kick {
  Four inertia[D - 1];  // NOLINT: factors of the sum
  Four weight;
  Four step;
  double kick;
};

template <int D, class Law>
REPOSE_FN Kick<D> kick_of(const RowSweep<D, Law>& sweep) {
  const double kick = sweep.kick;
  const double dt = sweep.time_step;
  constexpr double spin = inverse_inertia_factor<D>;
  if constexpr (D == 2) {
    return {{Four{1.0, 1.0, spin, 0.0}},
            Four{sweep.gravity[0] * kick, sweep.gravity[1] * kick, 0.0, 0.0},
            Four{dt, dt, 0.0, 0.0},
            kick};
  } else {
    return {{Four{1.0, 1.0, 1.0, 0.0}, Four{spin, spin, spin, 0.0}},
            Four{sweep.gravity[0] * kick, sweep.gravity[1] * kick, sweep.gravity[2] * kick, 0.0},
            Four{dt, dt, dt, 0.0},
            kick};
  }
}

template <int D>
REPOSE_FN void kick_and_drift(const Kick<D>& by, const Four (&sum)[D - 1], Line<D>& line) {
  double* const numbers = reinterpret_cast<double*>(&line);
  const double per_mass = by.kick * line.inverse_mass;
  const Four velocity = four(numbers) + (sum[0] * (by.inertia[0] * per_mass) + by.weight);
  four(numbers) = velocity;
  if constexpr (D == 3) four(numbers + 4) += sum[1] * (by.inertia[1] * per_mass);
  four(numbers + numbers_of_line<D> - 4) += velocity * by.step;
}

/// The same where the line has velocities predicted for the full step.
template <int D, class Law>
[[gnu::noinline]] void kick_synchronised(const RowSweep<D, Law>& sweep, std::size_t row, const double* sum) {
  auto& line = sweep.line[row];
  auto& half = sweep.half_step[row];
  const double per_mass = sweep.kick * line.inverse_mass;
  const auto move = [&](double& before, double& predicted, double change) {
    before += change;
    predicted = before + change * 0.5;
  };
  for (int k = 0; k < D; ++k) {
    move(half.velocity[k], line.velocity[k], sum[k] * per_mass + sweep.gravity[k] * sweep.kick);
    line.position[k] += half.velocity[k] * sweep.time_step;
  }
  const double per_inertia = per_mass * inverse_inertia_factor<D>;
  if constexpr (D == 2) {
    move(half.rim_velocity, line.rim_velocity, sum[2] * per_inertia);
  } else {
    for (int k = 0; k < D; ++k) move(half.rim_velocity[k], line.rim_velocity[k], sum[4 + k] * per_inertia);
  }
}

/// The window: sums of the grains from `start` on, at most `capacity` of them.
template <int D>
struct Window {
  RowSum<D>* sums;
  std::size_t start;
  std::size_t end;
  const RowArrival<D>* arrival;
};

/// Adds the negative of a push. The torques of both grains are equal.
template <int D>
REPOSE_FN void add_back(const double* push, double* sum) {
  if constexpr (D == 2) {
    add_signed(four(push), Four{-1.0, -1.0, 1.0, 1.0}, four(sum));
  } else {
    four(sum) -= four(push);
    four(sum + 4) += four(push + 4);
  }
}

/// Opens the window up to its capacity. Grains receive what other members push first, since its partners come first.
template <int D, class Law>
void open_window(const RowSweep<D, Law>& sweep, Window<D>& window) {
  window.end = window.start + sweep.capacity;
  for (; window.arrival->row < window.end; ++window.arrival) {
    add_back<D>(window.arrival->push->value, window.sums[window.arrival->row - window.start].value);
  }
}

/// Moves the window so that it begins at this row.
template <int D, class Law>
void slide_window(const RowSweep<D, Law>& sweep, std::size_t row, Window<D>& window) {
  const std::size_t done = row - window.start;
  const std::size_t open = sweep.capacity - done;
  for (std::size_t k = 0; k < open; ++k) window.sums[k] = window.sums[k + done];
  for (std::size_t k = open; k < sweep.capacity; ++k) window.sums[k] = RowSum<D>{};
  window.start = row;
  open_window(sweep, window);
}

/// Adds the pushes of pairs to their grains, in the order of the list. One loop over pairs is faster than one over rows
/// and their pairs, whose ends a processor cannot predict.
template <int D>
REPOSE_FN void add_pushes(const std::uint32_t* first, const std::uint32_t* second, std::size_t count,
                          const RowSum<D>* push, RowSum<D>* sums) {
  for (std::size_t k = 0; k < count; ++k) {
    const double* const by = push[k].value;
    double* const sum = sums[std::size_t{first[k]}].value;
    four(sum) += four(by);
    if constexpr (D == 3) four(sum + 4) += four(by + 4);
    add_back<D>(by, sums[std::size_t{second[k]}].value);
  }
}

/// Restores what the packs have done to the edge pairs before `end`, which are computed apart.
template <int D>
REPOSE_FN void leave_edges_out(const Edge<D>* edge, std::size_t base, std::size_t end, Tangent<D>* slip,
                               RowSum<D>* push) {
  for (; edge->pair < end; ++edge) {
    slip[edge->pair] = edge->slip;
    push[edge->pair - base] = RowSum<D>{};
  }
}

/// The partners of edge pairs come last in a row, so their pushes are added after those of the other pairs.
template <int D>
REPOSE_FN void add_edges(const Edge<D>*& edge, std::size_t end, RowSum<D>* sums) {
  for (; edge->pair < end; ++edge) {
    double* const sum = sums[std::size_t{edge->first}].value;
    four(sum) += four(edge->push.value);
    if constexpr (D == 3) four(sum + 4) += four(edge->push.value + 4);
  }
}

template <int D, class Law>
void sweep_member(RowSweep<D, Law>& sweep) {
  const std::uint32_t* const row_start = sweep.row_start;
  const std::size_t pairs_end = row_start[sweep.end];
  const std::size_t prefetched = sweep.bandwidth + 2 * rows_of_block<D>;  // rows ahead
  const auto by = kick_of(sweep);
  Line<D>* const line = sweep.line;
  const Four limit = sweep.speed_limit - Four{};
  Four fastest{};
  FourBits slow = ~FourBits{};
  Window<D> window{sweep.window, sweep.begin, sweep.begin, sweep.arrivals};
  open_window(sweep, window);
  const Edge<D>* edge = sweep.edges;
  const std::uint32_t* special = sweep.special;
  RowSum<D>* special_sum = sweep.special_sum;
  std::size_t computed = row_start[sweep.begin];  // pairs whose push is known
  std::size_t base = computed;                    // the pair of the first push
  for (std::size_t row = sweep.begin; row < sweep.end;) {
    const std::size_t block_end = row + rows_of_block<D> < sweep.end ? row + rows_of_block<D> : sweep.end;
    const std::size_t furthest = block_end + sweep.bandwidth < sweep.end ? block_end + sweep.bandwidth : sweep.end;
    if (furthest > window.end) slide_window(sweep, row, window);
    // Pushes of pairs of this block, which shared a pack with some of the last one.
    for (std::size_t k = 0; k < computed - row_start[row]; ++k) sweep.push[k] = sweep.push[row_start[row] - base + k];
    base = row_start[row];
    const std::size_t block_pairs = row_start[block_end];
    if (block_pairs > computed) {
      const std::size_t wanted = (block_pairs - computed + width - 1) / width;
      const std::size_t whole = (pairs_end - computed) / width;
      const std::size_t packs = wanted < whole ? wanted : whole;
      push_packs(sweep, computed, packs, sweep.push + (computed - base));
      computed += packs * width;
      if (computed < block_pairs) {
        push_last(sweep, computed, pairs_end - computed, sweep.push + (computed - base));
        computed = pairs_end;
      }
      leave_edges_out<D>(edge, base, computed, sweep.slip, sweep.push);
    }
    RowSum<D>* const sums = window.sums - window.start;
    add_pushes<D>(sweep.first + base, sweep.second + base, block_pairs - base, sweep.push, sums);
    add_edges<D>(edge, block_pairs, sums);
    for (; row < block_end; ++row) {
      double* const own = sums[row].value;
      Four sum[D - 1] = {four(own)};
      if constexpr (D == 3) sum[1] = four(own + 4);
      four(own) = Four{};
      if constexpr (D == 3) four(own + 4) = Four{};
      __builtin_prefetch(line + row + prefetched, 1);
      if (row == *special) [[unlikely]] {
        four(special_sum->value) = sum[0];
        if constexpr (D == 3) four(special_sum->value + 4) = sum[1];
        ++special;
        ++special_sum;
        continue;
      }
      if (sweep.synchronised) {
        double pushes[4 * (D - 1)];  // NOLINT: plain numbers, for a function that is not inlined
        for (int k = 0; k < 4 * (D - 1); ++k) pushes[k] = sum[k / 4][k % 4];
        kick_synchronised(sweep, row, pushes);
      } else {
        kick_and_drift<D>(by, sum, line[row]);
      }
      Four speed = four(line[row].velocity);
      drop_signs(speed);
      slow &= speed < limit;
      fastest = speed > fastest ? speed : fastest;
    }
  }
  sweep.trouble = false;
  for (int k = 0; k < D; ++k) {
    sweep.fastest[k] = fastest[k];
    sweep.trouble |= slow[k] == 0;
  }
}

}  // namespace
}  // namespace repose::soft
