// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/overlaps.hpp"

#include "repose/neighbours/near_pairs.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/start_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace repose {

// Not without a name: the templates below are seen by other files.
namespace overlaps {

enum class Origin { base, start, lattice, placed };

/// Grains at the start, with where they come from.
struct Present {
  Origin origin = Origin::base;
  std::size_t number = 0;  ///< row of the start, or number of the placed grain
  double radius = 0.0;
  bool fixed = false;
};

template <int D>
struct Everything {
  std::vector<Vec<D>> positions;
  std::vector<Present> grains;

  void add(const Vec<D>& position, const Present& grain) {
    positions.push_back(position);
    grains.push_back(grain);
  }
};

struct Pair {
  std::uint32_t first;
  std::uint32_t second;
  double relative;  ///< overlap over the mean diameter
};

/// Calls use(pair) for every two grains that overlap by more than `least` of their mean diameter, unless both are
/// fixed.
template <int D, class Use>
void for_overlaps(const Everything<D>& all, const Box<D>& box, double least, const Use& use) {
  double largest = 0.0;
  for (const auto& grain : all.grains) largest = std::max(largest, grain.radius);
  auto wrapped = all.positions;
  for (auto& position : wrapped) position = box.wrapped(position);
  for_near_pairs(wrapped, box, 2.0 * largest, [&](std::uint32_t i, std::uint32_t j) {
    const auto& a = all.grains[i];
    const auto& b = all.grains[j];
    if (a.fixed && b.fixed) return;
    const double mean = a.radius + b.radius;
    const auto apart = separation(wrapped[i], wrapped[j], box);
    if (dot(apart, apart) >= mean * mean) return;
    const double relative = (mean - magnitude(apart)) / mean;
    if (relative > least) use(Pair{std::min(i, j), std::max(i, j), relative});
  });
}

/// "grains 3 and 7 (lines 4 and 8)"; without ids "the grains of lines 4 and 8".
template <int D>
std::string names_in_file(const GrainRow<D>& a, const GrainRow<D>& b) {
  const bool lines = a.line > 0 && b.line > 0;
  if (!a.id || !b.id) return fmt::format("the grains of lines {} and {}", a.line, b.line);
  return fmt::format("grains {} and {}{}", *a.id, *b.id,
                     lines ? fmt::format(" (lines {} and {})", a.line, b.line) : "");
}

template <int D>
std::string name_of(const Present& grain, const std::optional<StartState<D>>& start) {
  switch (grain.origin) {
    case Origin::start: {
      const auto& row = start->grains[grain.number];
      const auto line = row.line > 0 ? fmt::format(" of line {}", row.line) : "";
      return row.id ? fmt::format("grain {}{} of start.from", *row.id, line)
                    : fmt::format("the grain{} of start.from", line);
    }
    case Origin::placed:
      return fmt::format("grain[{}]", grain.number);
    case Origin::base:
      return "a grain of the base";
    default:
      return "a grain of the lattice";
  }
}

std::string how_deep(double relative) {
  return relative >= 1.0 - 1e-9 ? std::string("lie at the same place")
                                : fmt::format("overlap by {:.3g} of their mean diameter", relative);
}

template <int D>
void add_all(const Grains<D>& grains, Origin origin, Everything<D>& all) {
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    all.add(grain.position, {origin, k, grain.radius, grain.fixed()});
  }
}

template <int D>
void add_rows(const StartState<D>& start, Everything<D>& all) {
  for (std::size_t k = 0; k < start.grains.size(); ++k) {
    const auto& row = start.grains[k];
    all.add(row.position, {Origin::start, k, row.radius, row.fixed});
  }
}

template <int D>
Everything<D> everything_in(const Scene& scene, const std::optional<StartState<D>>& start) {
  Everything<D> all;
  std::int64_t id = 0;
  Grains<D> base;
  Grains<D> lattice;
  scene.base->add_grains(scene, base, id);
  if (scene.source->placed() > 0) scene.source->add_grains(scene, lattice, id);
  add_all(base, Origin::base, all);
  if (start) add_rows(*start, all);
  add_all(lattice, Origin::lattice, all);
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto& grain = scene.placed[k];
    all.add(vec<D>(grain.position), {Origin::placed, k, 0.5 * grain.diameter, grain.fixed});
  }
  return all;
}

/// "[1, 2]" or "[1, 2, 3]".
template <int D>
std::string place_text(const Coordinates& place) {
  return fmt::format("[{}]", fmt::join(place.begin(), place.begin() + D, ", "));
}

/// The key that a pair is reported with, and the message.
template <int D>
std::pair<std::string, std::string> complaint(const Present& a, const Present& b, double relative, const Scene& scene,
                                              const std::optional<StartState<D>>& start) {
  const auto allowed = fmt::format("; at most {} is allowed at the start", largest_overlap_at_start);
  if (b.origin == Origin::placed) {
    const auto& place = scene.placed[b.number].position;
    return {fmt::format("grain[{}].position", b.number),
            fmt::format(" = {}: it and {} {}{}", place_text<D>(place), name_of(a, start), how_deep(relative), allowed)};
  }
  const auto from = fmt::format(" = \"{}\": ", scene.start.from);
  if (a.origin == Origin::start && b.origin == Origin::start) {
    const auto& first = start->grains[a.number];
    const auto& second = start->grains[b.number];
    return {"start.from", fmt::format("{}{}: {} {}{}", from, scene.start.path, names_in_file(first, second),
                                      how_deep(relative), allowed)};
  }
  return {"start.from", fmt::format("{}{}: {} and {} {}{}", from, scene.start.path, name_of(a, start),
                                    name_of(b, start), how_deep(relative), allowed)};
}

}  // namespace overlaps

using namespace overlaps;

template <int D>
void check_overlaps(const Scene& scene, const std::optional<StartState<D>>& start, Problems& problems) {
  if (!problems.none() || !scene.method->traits().follows_time || (scene.placed.empty() && !start)) return;
  const bool of_run = start && !start->scene.empty();
  const auto all = everything_in(scene, start);
  constexpr std::size_t most = 8;
  std::vector<Pair> found;
  std::size_t count = 0;
  for_overlaps(all, make_box<D>(scene), largest_overlap_at_start, [&](const Pair& pair) {
    const auto& a = all.grains[pair.first];
    const auto& b = all.grains[pair.second];
    const bool kept = of_run && a.origin == Origin::start && b.origin == Origin::start;
    const bool own = (a.origin == Origin::base || a.origin == Origin::lattice) &&
                     (b.origin == Origin::base || b.origin == Origin::lattice);
    if (kept || own) return;
    ++count;
    if (found.size() < 1000) found.push_back(pair);
  });
  std::sort(found.begin(), found.end(),
            [](const Pair& a, const Pair& b) { return std::pair(a.first, a.second) < std::pair(b.first, b.second); });
  for (std::size_t k = 0; k < std::min(most, found.size()); ++k) {
    const auto [key, what] =
        complaint(all.grains[found[k].first], all.grains[found[k].second], found[k].relative, scene, start);
    problems.problem(key, what);
  }
  if (count > most) {
    problems.problem(start ? "start.from" : "grain",
                     fmt::format(": and {} more pairs of grains overlap", count - most));
  }
}

template <int D>
std::optional<DeepestOverlap> deepest_overlap(const StartState<D>& start, const Scene& scene) {
  Everything<D> all;
  add_rows(start, all);
  const auto box = wrapping_box<D>(scene);
  std::optional<Pair> deepest;
  for_overlaps(all, box, 0.0, [&](const Pair& pair) {
    const bool deeper = !deepest || pair.relative > deepest->relative ||
                        (pair.relative == deepest->relative && pair.first < deepest->first);
    if (deeper) deepest = pair;
  });
  if (!deepest) return std::nullopt;
  const auto& a = start.grains[all.grains[deepest->first].number];
  const auto& b = start.grains[all.grains[deepest->second].number];
  return DeepestOverlap{deepest->relative, names_in_file(a, b)};
}

template void check_overlaps(const Scene&, const std::optional<StartState<2>>&, Problems&);
template std::optional<DeepestOverlap> deepest_overlap(const StartState<2>&, const Scene&);
template void check_overlaps(const Scene&, const std::optional<StartState<3>>&, Problems&);
template std::optional<DeepestOverlap> deepest_overlap(const StartState<3>&, const Scene&);

}  // namespace repose
