// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/motion.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

/// A grain that moved in an interval.
struct Move {
  std::int64_t id = 0;
  double depth = 0.0;
  bool left = false;
};

HeapShape shape_of(const TrackMoment<2>& moment, const MotionSettings& settings) {
  Grains<2> grains;
  std::vector<bool> in_heap;
  for (const auto& tracked : moment.grains) {
    Grain<2> grain;
    grain.position = {{tracked.position[0], tracked.position[1]}};
    grain.radius = tracked.radius;
    grain.mass = 1.0;
    grain.inverse_mass = 1.0;
    grains.add(grain, tracked.id);
    in_heap.push_back(tracked.in_heap);
  }
  return measure_heap(grains, in_heap, settings.base_height, settings.bin_width);
}

/// The depth of a layer: the move of rank ceil(0.9 n) by depth; NaN without moves.
double layer_depth(const std::vector<Move>& moves) {
  if (moves.empty()) return no_number;
  std::vector<double> depths;
  for (const auto& move : moves) depths.push_back(move.depth);
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.9 * static_cast<double>(depths.size()))) - 1;
  std::nth_element(depths.begin(), depths.begin() + rank, depths.end());
  return depths[static_cast<std::size_t>(rank)];
}

/// The row of one interval. Adds the grains that moved to `moves`.
MotionRow compare(const TrackMoment<2>& before, const TrackMoment<2>& after, const HeapShape& shape, const Box<2>& box,
                  const MotionSettings& settings, std::vector<Move>& moves) {
  MotionRow row;
  row.start = before.time;
  row.end = after.time;
  auto partner = before.grains.begin();
  for (const auto& now : after.grains) {
    while (partner != before.grains.end() && partner->id < now.id) ++partner;
    if (partner == before.grains.end()) break;
    if (partner->id != now.id || !partner->in_heap || !now.in_heap) continue;
    ++row.grains;
    row.kinetic_energy += now.kinetic_energy;
    const Vec<2> from{{partner->position[0], partner->position[1]}};
    const Vec<2> to{{now.position[0], now.position[1]}};
    if (!(magnitude(separation(to, from, box)) > settings.moved)) continue;
    const double lowest = from[1] - partner->radius - settings.base_height;
    const bool left = from[0] < shape.apex_x;
    moves.push_back({now.id, std::max(0.0, depth_below_surface(shape, from[0], lowest)), left});
    if (left) ++row.moved_left;
  }
  row.moved = moves.size();
  row.depth = layer_depth(moves);
  return row;
}

Avalanche avalanche_of(const std::vector<MotionRow>& rows, const std::vector<std::vector<Move>>& moves,
                       std::size_t first, std::size_t last) {
  std::vector<Move> all;
  for (auto k = first; k < last; ++k) all.insert(all.end(), moves[k].begin(), moves[k].end());
  std::vector<std::int64_t> ids;
  double left = 0.0;
  for (const auto& move : all) {
    ids.push_back(move.id);
    if (move.left) left += 1.0;
  }
  std::sort(ids.begin(), ids.end());
  Avalanche avalanche;
  avalanche.start = rows[first].start;
  avalanche.end = rows[last - 1].end;
  avalanche.duration = avalanche.end - avalanche.start;
  avalanche.size = static_cast<std::size_t>(std::unique(ids.begin(), ids.end()) - ids.begin());
  avalanche.depth = layer_depth(all);
  avalanche.left = left / static_cast<double>(all.size());
  return avalanche;
}

/// Calls each(first, end) for every maximal sequence of consecutive rows for which `belongs` is true.
template <class Belongs, class Each>
void for_each_sequence(const std::vector<MotionRow>& rows, const Belongs& belongs, const Each& each) {
  for (std::size_t first = 0; first < rows.size();) {
    auto last = first;
    while (last < rows.size() && belongs(rows[last])) ++last;
    if (last > first) each(first, last);
    first = last + 1;
  }
}

template <class Event>
void add(std::vector<Event>& events, Event event) {
  event.waiting = events.empty() ? no_number : event.start - events.back().end;
  events.push_back(event);
}

}  // namespace

Motion measure_motion(const Track<2>& track, const Box<2>& box, const MotionSettings& settings) {
  Motion motion;
  if (track.size() < 2) return motion;
  std::vector<std::vector<Move>> moves(track.size() - 1);
  auto shape = shape_of(track.front(), settings);
  for (std::size_t k = 0; k + 1 < track.size(); ++k) {
    auto row = compare(track[k], track[k + 1], shape, box, settings, moves[k]);
    shape = shape_of(track[k + 1], settings);
    row.angle_left_deg = shape.left ? shape.left->angle_deg : no_number;
    row.angle_right_deg = shape.right ? shape.right->angle_deg : no_number;
    motion.rows.push_back(row);
  }
  for_each_sequence(
      motion.rows, [&](const MotionRow& row) { return row.moved >= settings.least; },
      [&](std::size_t first, std::size_t last) {
        add(motion.avalanches, avalanche_of(motion.rows, moves, first, last));
      });
  for_each_sequence(
      motion.rows, [&](const MotionRow& row) { return row.kinetic_energy > settings.burst; },
      [&](std::size_t first, std::size_t last) {
        Burst burst;
        burst.start = motion.rows[first].start;
        burst.end = motion.rows[last - 1].end;
        burst.duration = burst.end - burst.start;
        for (auto k = first; k < last; ++k) burst.peak = std::max(burst.peak, motion.rows[k].kinetic_energy);
        add(motion.bursts, burst);
      });
  return motion;
}

}  // namespace repose
