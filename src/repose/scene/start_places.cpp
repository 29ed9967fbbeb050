// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/start_places.hpp"

#include "repose/tables/file_problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

Factors factors_for(const FileUnits& units, const Scene& scene) {
  Factors factors;
  if (scene.units == "SI" && units.length > 0.0) factors.length = units.length;
  if (scene.units == "SI" && units.mass > 0.0) factors.mass = units.mass;
  if (scene.units == "SI" && units.time > 0.0) factors.spin = 1.0 / units.time;
  factors.length *= scene.start.scale;
  factors.velocity = factors.length * factors.spin;
  return factors;
}

/// In a reduced scene a file with units of its own that is scaled gives places and sizes alone.
template <int D>
void leave_out_other_units(StartState<D>& state, const Scene& scene) {
  const auto& units = state.units;
  if (scene.units == "SI" || scene.start.scale == 1.0 || (units.length == 0.0 && units.mass == 0.0)) return;
  bool any = false;
  for (auto& row : state.grains) {
    any |= row.mass.has_value() || row.spin != Spin<D>{} || row.velocity != Vec<D>{};
    row.mass.reset();
    row.velocity = {};
    row.spin = {};
  }
  if (any) {
    state.warnings.push_back(
        fmt::format("the scene is in reduced units, the file in {}: its masses, velocities and spins "
                    "are left out",
                    units.name));
  }
}

/// Which axes change their sign.
template <int D>
std::array<bool, D> flipped_axes(const std::string& flip) {
  std::array<bool, D> flipped{};
  for (std::size_t k = 0; k < D; ++k) flipped[k] = flip == std::string(1, "xyz"[k]) || flip == "both";
  return flipped;
}

void flip_spin(double& spin, const std::array<bool, 2>& flipped) {
  if (flipped[0] != flipped[1]) spin = -spin;
}
/// A mirror leaves the part of a spin along the axis that it flips, and turns round the others.
void flip_spin(Vec<3>& spin, const std::array<bool, 3>& flipped) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t other = 0; other < 3; ++other) {
      auto& component = spin[static_cast<int>(other)];
      if (flipped[k] && other != k) component = -component;
    }
  }
}

bool all_finite(double number) { return std::isfinite(number); }
bool all_finite(const Vec<3>& vector) {
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

template <int D>
void place(StartState<D>& state, const Scene& scene) {
  const auto& start = scene.start;
  const auto factors = factors_for(state.units, scene);
  const auto flipped = flipped_axes<D>(start.flip);
  const auto put = [&](Vec<D>& vector, double factor) {
    if (factor != 1.0) vector *= factor;
    for (int k = 0; k < D; ++k) {
      if (flipped[static_cast<std::size_t>(k)]) vector[k] = -vector[k];
    }
  };
  const auto move = [&](Vec<D>& position) {
    put(position, factors.length);
    for (int k = 0; k < D; ++k) {
      const double shift = start.shift[static_cast<std::size_t>(k)];
      if (shift != 0.0) position[k] += shift;
    }
  };
  FileProblems problems(start.path);
  for (auto& row : state.grains) {
    move(row.position);
    put(row.velocity, factors.velocity);
    if (factors.spin != 1.0) row.spin *= factors.spin;
    flip_spin(row.spin, flipped);
    if (factors.length != 1.0) {
      row.radius *= factors.length;
      row.third *= factors.length;
    }
    if (row.mass && factors.mass != 1.0) *row.mass *= factors.mass;
    const bool sound = std::isfinite(magnitude(row.position)) && std::isfinite(magnitude(row.velocity)) &&
                       all_finite(row.spin) && std::isfinite(row.radius) && row.radius > 0.0 &&
                       (!row.mass || (std::isfinite(*row.mass) && *row.mass > 0.0));
    if (!sound) problems.add(row.line, "place, size, mass or velocity is out of range in the units of the scene");
  }
  problems.check();
  if (!state.box) return;
  move(state.box->low);
  move(state.box->high);
  for (int k = 0; k < D; ++k) {
    if (state.box->low[k] > state.box->high[k]) std::swap(state.box->low[k], state.box->high[k]);
  }
}

/// Grains outside a periodic box lie at the same place of a neighbouring image. Others keep their bits.
template <int D>
void wrap(StartState<D>& state, const Scene& scene) {
  const auto box = wrapping_box<D>(scene);
  for (auto& row : state.grains) {
    bool outside = box.periodic && std::fabs(row.position[0]) > box.x_max;
    if constexpr (D == 3) outside |= box.periodic_y && std::fabs(row.position[1]) > box.y_max;
    if (outside) row.position = box.wrapped(row.position);
  }
}

void check_plane(const StartState<2>& state, const Scene& scene) {
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

template <int D>
void fix(StartState<D>& state, const StartFrom& start) {
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
template <int D>
void name_materials(StartState<D>& state, const Scene& scene) {
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

template <int D>
Box<D> wrapping_box(const Scene& scene) {
  Box<D> box;
  if (scene.box.periodic() && scene.box.half_width > 0.0) {
    box.periodic = true;
    box.x_max = scene.box.half_width;
    box.x_min = -box.x_max;
  }
  if (D == 3 && scene.box.periodic_y() && scene.box.half_depth > 0.0) {
    box.periodic_y = true;
    box.y_max = scene.box.half_depth;
    box.y_min = -box.y_max;
  }
  return box;
}

template <int D>
StartState<D> state_at_start(const Scene& scene) {
  const auto plane = D == 2 ? plane_of(scene.start.plane) : Plane::xy;
  auto state = read_start<D>(scene.start.path, {.step = scene.start.step, .plane = plane});
  leave_out_other_units(state, scene);
  place(state, scene);
  if constexpr (D == 2) check_plane(state, scene);
  fix(state, scene.start);
  name_materials(state, scene);
  wrap(state, scene);
  return state;
}

template Box<2> wrapping_box(const Scene&);
template Box<3> wrapping_box(const Scene&);
template StartState<2> state_at_start(const Scene&);
template StartState<3> state_at_start(const Scene&);

bool keeps_contacts(const StartFrom& start) { return start.scale == 1.0 && start.flip == "none"; }

}  // namespace repose
