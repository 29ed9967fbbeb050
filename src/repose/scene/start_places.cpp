// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/start_places.hpp"

#include "repose/core/box.hpp"
#include "repose/tables/file_problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace repose {

namespace {

Plane plane_of(const std::string& name) { return name == "xz" ? Plane::xz : name == "yz" ? Plane::yz : Plane::xy; }

/// Factors from the units of a file to those of the scene.
struct Factors {
  double length = 1.0;
  double velocity = 1.0;
  double spin = 1.0;
  double mass = 1.0;
};

Factors factors_for(const StartState& state, const Scene& scene) {
  Factors factors;
  const auto& units = state.units;
  if (scene.units == "SI" && units.length > 0.0) factors.length = units.length;
  if (scene.units == "SI" && units.mass > 0.0) factors.mass = units.mass;
  if (scene.units == "SI" && units.time > 0.0) factors.spin = 1.0 / units.time;
  factors.length *= scene.start.scale;
  factors.velocity = factors.length * factors.spin;
  return factors;
}

/// In a reduced scene a file with units of its own that is scaled gives places and sizes alone.
void leave_out_other_units(StartState& state, const Scene& scene) {
  const auto& units = state.units;
  if (scene.units == "SI" || scene.start.scale == 1.0 || (units.length == 0.0 && units.mass == 0.0)) return;
  bool any = false;
  for (auto& row : state.grains) {
    any |= row.mass.has_value() || row.spin != 0.0 || row.velocity != Vec<2>{};
    row.mass.reset();
    row.velocity = {};
    row.spin = 0.0;
  }
  if (any) {
    state.warnings.push_back(
        fmt::format("the scene is in reduced units, the file in {}: its masses, velocities and spins "
                    "are left out",
                    units.name));
  }
}

void place(StartState& state, const Scene& scene) {
  const auto& start = scene.start;
  const auto factors = factors_for(state, scene);
  const bool x = start.flip == "x" || start.flip == "both";
  const bool y = start.flip == "y" || start.flip == "both";
  const auto put = [&](Vec<2>& vector, double factor) {
    if (factor != 1.0) vector *= factor;
    if (x) vector[0] = -vector[0];
    if (y) vector[1] = -vector[1];
  };
  const auto move = [&](Vec<2>& position) {
    put(position, factors.length);
    for (int k = 0; k < 2; ++k) {
      const double shift = start.shift[static_cast<std::size_t>(k)];
      if (shift != 0.0) position[k] += shift;
    }
  };
  FileProblems problems(start.path);
  for (auto& row : state.grains) {
    move(row.position);
    put(row.velocity, factors.velocity);
    if (factors.spin != 1.0) row.spin *= factors.spin;
    if (x != y) row.spin = -row.spin;
    if (factors.length != 1.0) {
      row.radius *= factors.length;
      row.third *= factors.length;
    }
    if (row.mass && factors.mass != 1.0) *row.mass *= factors.mass;
    const bool sound = std::isfinite(magnitude(row.position)) && std::isfinite(magnitude(row.velocity)) &&
                       std::isfinite(row.spin) && std::isfinite(row.radius) && row.radius > 0.0 &&
                       (!row.mass || (std::isfinite(*row.mass) && *row.mass > 0.0));
    if (!sound) problems.add(row.line, "place, size, mass or velocity is out of range in the units of the scene");
  }
  problems.check();
  if (!state.box) return;
  move(state.box->low);
  move(state.box->high);
  for (int k = 0; k < 2; ++k) {
    if (state.box->low[k] > state.box->high[k]) std::swap(state.box->low[k], state.box->high[k]);
  }
}

/// Grains outside a periodic box lie at the same place of a neighbouring image. Others keep their bits.
void wrap(StartState& state, const Scene& scene) {
  if (!scene.box.periodic() || !(scene.box.half_width > 0.0)) return;
  Box<2> box;
  box.periodic = true;
  box.x_max = scene.box.half_width;
  box.x_min = -box.x_max;
  for (auto& row : state.grains) {
    if (std::fabs(row.position[0]) > box.x_max) row.position = box.wrapped(row.position);
  }
}

void check_plane(const StartState& state, const Scene& scene) {
  if (state.grains.empty()) return;
  FileProblems problems(scene.start.path);
  const auto& first = state.grains.front();
  const auto [low, high] = std::minmax_element(state.grains.begin(), state.grains.end(),
                                               [](const auto& a, const auto& b) { return a.third < b.third; });
  if (high->third - low->third <= scene.start.tolerance) return;
  const char axis = scene.start.plane == "xy" ? 'z' : scene.start.plane == "xz" ? 'y' : 'x';
  for (const auto& row : state.grains) {
    if (std::fabs(row.third - first.third) <= scene.start.tolerance) continue;
    problems.add(row.line,
                 fmt::format("{} = {}: must be the same for all grains within start.tolerance = {} ({} in line "
                             "{}): they are discs in a plane, which start.plane chooses",
                             axis, row.third, scene.start.tolerance, first.third, first.line));
  }
  problems.check();
}

void fix(StartState& state, const StartFrom& start) {
  if (start.fixed_types.empty()) return;
  std::set<std::int64_t> found;
  for (auto& row : state.grains) {
    const auto listed = std::find(start.fixed_types.begin(), start.fixed_types.end(), static_cast<double>(row.type));
    found.insert(row.type);
    if (listed != start.fixed_types.end()) row.fixed = true;
  }
  for (const double type : start.fixed_types) {
    if (std::any_of(found.begin(), found.end(), [&](auto one) { return static_cast<double>(one) == type; })) continue;
    FileProblems(start.path)
        .stop_without_line(fmt::format("no grain is of type {}, which start.fixed_types names; there are {}", type,
                                       fmt::join(found, ", ")));
  }
}

/// Names of types become materials of the same names. In a scene without a list of materials all are of its only one.
void name_materials(StartState& state, const Scene& scene) {
  const auto names = scene.material_names();
  const bool one = scene.materials.empty();
  if (!one && state.types.empty()) return;
  std::set<std::uint16_t> seen;
  std::vector<std::uint16_t> number(state.types.size(), 0);
  std::vector<std::string> unknown;
  for (std::size_t k = 0; k < state.types.size() && !one; ++k) {
    const auto found = std::find(names.begin(), names.end(), state.types[k]);
    if (found == names.end()) unknown.push_back(state.types[k]);
    number[k] = static_cast<std::uint16_t>(found == names.end() ? 0 : found - names.begin());
  }
  if (!unknown.empty() && state.types.size() > 1) {
    FileProblems(scene.start.path)
        .stop_without_line(fmt::format("has grains of {}, which is no [[material]] of the scene; they are {}",
                                       fmt::join(unknown, ", "), fmt::join(names, ", ")));
  }
  const bool of_run = !state.scene.empty();
  if (one && of_run) return;
  for (auto& row : state.grains) {
    seen.insert(row.material);
    row.material = one ? std::uint16_t{0} : number[row.material];
  }
  if (one && seen.size() > 1) {
    state.warnings.push_back(
        fmt::format("the file has grains of {} types, the scene one material: all are of that", seen.size()));
  }
}

}  // namespace

StartState state_at_start(const Scene& scene) {
  auto state = read_start(scene.start.path, {.step = scene.start.step, .plane = plane_of(scene.start.plane)});
  leave_out_other_units(state, scene);
  place(state, scene);
  check_plane(state, scene);
  fix(state, scene.start);
  name_materials(state, scene);
  wrap(state, scene);
  return state;
}

bool keeps_contacts(const StartFrom& start) { return start.scale == 1.0 && start.flip == "none"; }

}  // namespace repose
