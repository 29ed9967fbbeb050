// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/start_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

template <int D, class Value>
Range range_of(const StartState<D>& state, const Value& value) {
  Range range;
  bool first = true;
  for (const auto& row : state.grains) {
    const double x = value(row);
    range = first ? Range{x, x} : Range{std::min(range.low, x), std::max(range.high, x)};
    first = false;
  }
  return range;
}

std::string ends_of(const Range& range) { return fmt::format("{:.6g} to {:.6g}", range.low, range.high); }

template <int D>
bool of_run(const StartState<D>& state) {
  return !state.scene.empty();
}

std::string side_text(const std::string& side) { return side.empty() ? "sides not told" : side; }

/// "0.5 to 1", or the one value that all have.
std::string extent_of(const Range& range) {
  return range.low == range.high ? fmt::format("{:.6g}", range.low) : ends_of(range);
}

template <int D>
Range diameters(const StartState<D>& state) {
  return range_of(state, [](const auto& row) { return 2.0 * row.radius; });
}

/// How far the centres lie along an axis.
template <int D>
Range places(const StartState<D>& state, int axis) {
  return range_of(state, [axis](const auto& row) { return row.position[axis]; });
}

/// Whether no grain is within a factor of 30 of the nominal size.
template <int D>
bool far_from_nominal(const StartState<D>& state, const Scene& scene) {
  constexpr double far = 30.0;
  const auto sizes = diameters(state);
  return sizes.low > far * scene.grains.diameter || far * sizes.high < scene.grains.diameter;
}

}  // namespace

template <int D>
void check_units(const StartState<D>& state, const Scene& scene, Problems& problems,
                 std::vector<std::string>& warnings) {
  const auto& units = state.units;
  const bool si = scene.units == "SI";
  const bool given = !units.name.empty() || units.reduced;
  const bool known = units.length > 0.0 || units.mass > 0.0 || units.reduced;
  if (!given || scene.start.scale != 1.0 || (known && units.reduced == !si)) return;
  const auto text = fmt::format("the file has units {}, the scene {}", units.reduced ? "reduced" : units.name,
                                si ? "SI (m, kg, s)" : "reduced (d, m and g are 1)");
  if (far_from_nominal(state, scene) || !known) {
    return problems.problem(
        "start.from",
        fmt::format(" = \"{}\": {}: {}: set start.scale to relate their lengths{}", scene.start.from, scene.start.path,
                    text, known ? fmt::format(", or units = \"{}\"", si ? "reduced" : "SI") : ""));
  }
  warnings.push_back(text + ": its numbers are taken as they are; start.scale relates lengths");
}

namespace {

/// A level axis of the scene's box.
struct LevelAxis {
  int axis;
  char letter;
  bool periodic;
  double width;      // [L]
  const char* wide;  // what its width is called: "wide"
  const char* key;   // of half its width
};

template <int D>
std::vector<LevelAxis> level_axes(const Scene& scene) {
  const auto& box = scene.box;
  std::vector<LevelAxis> axes{{0, 'x', box.periodic(), 2.0 * box.half_width, "wide", "box.half_width"}};
  if (D == 3) axes.push_back({1, 'y', box.periodic_y(), 2.0 * box.half_depth, "deep", "box.half_depth"});
  return axes;
}

/// The sides of a file's box that are not those of the scene.
template <int D>
void warn_of_sides(const StartState<D>& state, const LevelAxis& level, std::vector<std::string>& warnings) {
  if (!state.box) return;
  const double own = state.box->high[level.axis] - state.box->low[level.axis];
  const auto& sides = state.box->sides[static_cast<std::size_t>(level.axis)];
  if (sides == "periodic" && !level.periodic) {
    warnings.push_back(
        fmt::format("the file's box is periodic along {0}, {1:.6g} {2}, the scene's is not: contacts through its sides "
                    "are lost; set box.{0} = \"periodic\" and {3} = {4:.6g}",
                    level.letter, own, level.wide, level.key, 0.5 * own));
  }
  if (sides == "open" && level.periodic) {
    warnings.push_back(fmt::format("the scene's box is periodic along {}, the file's is open", level.letter));
  }
}

/// A width that does not fit into the scene's.
template <int D>
void warn_of_width(const StartState<D>& state, const LevelAxis& level, std::vector<std::string>& warnings) {
  if (!level.periodic) return;
  const auto range = places(state, level.axis);
  if (!state.box && range.high - range.low > level.width) {
    warnings.push_back(fmt::format("the grains lie at {} = {}, the periodic box is {:.6g} {}", level.letter,
                                   ends_of(range), level.width, level.wide));
  }
  if (!state.box) return;
  const double own = state.box->high[level.axis] - state.box->low[level.axis];
  if (std::fabs(own - level.width) > 1e-6 * level.width) {
    warnings.push_back(fmt::format("the file's box is {:.6g} {}, the scene's {:.6g}", own, level.wide, level.width));
  }
}

}  // namespace

template <int D>
void add_warnings(const StartState<D>& state, const Scene& scene, const std::optional<DeepestOverlap>& deepest,
                  std::vector<std::string>& warnings) {
  if (of_run(state) || state.grains.empty()) return;
  const auto warn = [&](const std::string& text) { warnings.push_back(text); };
  for (const auto& axis : level_axes<D>(scene)) warn_of_sides(state, axis, warnings);
  if (state.box && state.box->sides[up<D>] == "periodic") {
    warn("the file's box is periodic along its height: a scene has no such sides, so contacts through them are lost");
  }
  for (const auto& axis : level_axes<D>(scene)) warn_of_width(state, axis, warnings);
  if (state.box && state.box->tilted) warn("the file's box is tilted, the scene's is not");
  if (deepest && deepest->relative > usual_overlap_at_start) {
    warn(fmt::format("{} overlap by {:.3g} of their mean diameter", deepest->grains, deepest->relative));
  }
  if (far_from_nominal(state, scene)) {
    warn(fmt::format(
        "diameters of {} are far from grains.diameter = {:.6g}: are the units others? start.scale multiplies "
        "lengths",
        extent_of(diameters(state)), scene.grains.diameter));
  }
  const auto names = scene.material_names();
  const auto ratio = range_of(state, [&](const auto& row) {
    const double usual =
        scene.mass_of(2.0 * row.radius, row.material < names.size() ? names[row.material] : names.front());
    return row.mass.value_or(usual) / usual;
  });
  constexpr double much = 2.0;
  if (ratio.low * much < 1.0 || ratio.high > much) {
    warn(fmt::format("masses in the file are {} times those that the scene gives to grains of their sizes",
                     extent_of(Range{std::round(ratio.low * 1e4) / 1e4, std::round(ratio.high * 1e4) / 1e4})));
  }
}

template <int D>
std::string describe_start(const StartState<D>& state, const Scene& scene,
                           const std::optional<DeepestOverlap>& deepest) {
  if (state.grains.empty()) return "";
  std::string text;
  const auto line = [&](const std::string& what) { text += fmt::format("                 {}\n", what); };
  line(fmt::format("{}{}", state.format,
                   state.snapshot
                       ? fmt::format(", snapshot {}{}", *state.snapshot,
                                     state.snapshots > 1 ? fmt::format(" of {} in the file", state.snapshots) : "")
                       : ""));
  if (!state.used.empty()) line(fmt::format("columns used: {}", fmt::join(state.used, ", ")));
  if (!state.left_out.empty()) line(fmt::format("columns left out: {}", fmt::join(state.left_out, ", ")));
  if (!of_run(state)) {
    const auto units = state.units.reduced ? std::string("reduced") : state.units.name;
    line(units.empty() ? fmt::format("units: the file gives none, taken as those of the scene, {}", scene.units)
                       : fmt::format("units: {}, those of the scene {}", units, scene.units));
  }
  if (!state.types.empty()) line(fmt::format("types: {}", fmt::join(state.types, ", ")));
  if (state.box) {
    const auto& box = *state.box;
    std::string axes;
    for (int k = 0; k < D; ++k) {
      axes += fmt::format(
          "{}{} {:.6g} to {:.6g} ({})", k == 0 ? "" : ", ", "xyz" [k], double { box.low[k] }, double{box.high[k]},
          side_text(box.sides[static_cast<std::size_t>(k)]));
    }
    line("box of the file: " + axes);
  }
  std::string centres;
  for (int k = 0; k < D; ++k) {
    centres += fmt::format("{}{} {}", k == 0 ? "" : ", ", "xyz"[k], ends_of(places(state, k)));
  }
  line("centres: " + centres);
  const auto with_mass =
      std::count_if(state.grains.begin(), state.grains.end(), [](const auto& row) { return row.mass; });
  const auto names = scene.material_names();
  const auto masses = range_of(state, [&](const auto& row) {
    return row.mass.value_or(
        scene.mass_of(2.0 * row.radius, row.material < names.size() ? names[row.material] : names.front()));
  });
  line(fmt::format("diameters: {}; masses: {}, by the {}", extent_of(diameters(state)), extent_of(masses),
                   with_mass > 0 ? "file" : "scene"));
  line(deepest ? fmt::format("deepest overlap: {:.3g} of the mean diameter, {}", deepest->relative, deepest->grains)
               : std::string("deepest overlap: none"));
  return text;
}

template void check_units(const StartState<2>&, const Scene&, Problems&, std::vector<std::string>&);
template void add_warnings(const StartState<2>&, const Scene&, const std::optional<DeepestOverlap>&,
                           std::vector<std::string>&);
template std::string describe_start(const StartState<2>&, const Scene&, const std::optional<DeepestOverlap>&);
template void check_units(const StartState<3>&, const Scene&, Problems&, std::vector<std::string>&);
template void add_warnings(const StartState<3>&, const Scene&, const std::optional<DeepestOverlap>&,
                           std::vector<std::string>&);
template std::string describe_start(const StartState<3>&, const Scene&, const std::optional<DeepestOverlap>&);

}  // namespace repose
