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

template <class Value>
Range range_of(const StartState& state, const Value& value) {
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

bool of_run(const StartState& state) { return !state.scene.empty(); }

std::string side_text(const std::string& side) { return side.empty() ? "sides not told" : side; }

/// "0.5 to 1", or the one value that all have.
std::string extent_of(const Range& range) {
  return range.low == range.high ? fmt::format("{:.6g}", range.low) : ends_of(range);
}

Range diameters(const StartState& state) {
  return range_of(state, [](const auto& row) { return 2.0 * row.radius; });
}

/// Whether no grain is within a factor of 30 of the nominal size.
bool far_from_nominal(const StartState& state, const Scene& scene) {
  constexpr double far = 30.0;
  const auto sizes = diameters(state);
  return sizes.low > far * scene.grains.diameter || far * sizes.high < scene.grains.diameter;
}

}  // namespace

void check_units(const StartState& state, const Scene& scene, Problems& problems, std::vector<std::string>& warnings) {
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

void add_warnings(const StartState& state, const Scene& scene, const std::optional<DeepestOverlap>& deepest,
                  std::vector<std::string>& warnings) {
  if (of_run(state) || state.grains.empty()) return;
  const auto warn = [&](const std::string& text) { warnings.push_back(text); };
  const double width = 2.0 * scene.box.half_width;
  const auto x = range_of(state, [](const auto& row) { return row.position[0]; });
  if (state.box) {
    const auto& box = *state.box;
    const double own = box.high[0] - box.low[0];
    const bool periodic = box.sides[0] == "periodic";
    if (periodic && !scene.box.periodic()) {
      warn(fmt::format(
          "the file's box is periodic along x, {:.6g} wide, the scene's is not: contacts through its sides are "
          "lost; set box.x = \"periodic\" and box.half_width = {:.6g}",
          own, 0.5 * own));
    }
    if (box.sides[0] == "open" && scene.box.periodic()) {
      warn("the scene's box is periodic along x, the file's is open");
    }
    if (box.sides[1] == "periodic") {
      warn("the file's box is periodic along its height: a scene has no such sides, so contacts through them are lost");
    }
    if (scene.box.periodic() && std::fabs(own - width) > 1e-6 * width) {
      warn(fmt::format("the file's box is {:.6g} wide, the scene's {:.6g}", own, width));
    }
    if (box.tilted) warn("the file's box is tilted, the scene's is not");
  } else if (scene.box.periodic() && x.high - x.low > width) {
    warn(fmt::format("the grains lie at x = {}, the periodic box is {:.6g} wide", ends_of(x), width));
  }
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

std::string describe_start(const StartState& state, const Scene& scene, const std::optional<DeepestOverlap>& deepest) {
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
    line(fmt::format("box of the file: x {:.6g} to {:.6g} ({}), y {:.6g} to {:.6g} ({})", box.low[0], box.high[0],
                     side_text(box.sides[0]), box.low[1], box.high[1], side_text(box.sides[1])));
  }
  const auto x = range_of(state, [](const auto& row) { return row.position[0]; });
  const auto y = range_of(state, [](const auto& row) { return row.position[1]; });
  line(fmt::format("centres: x {}, y {}", ends_of(x), ends_of(y)));
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

}  // namespace repose
