// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/start.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/start_checks.hpp"
#include "repose/scene/start_places.hpp"
#include "repose/scene/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// What a contact remembers makes sense to: a method, and where contacts have laws of force, the tangential law that
/// kept the displacement.
std::string memory_of(const MethodKind& method, const std::string& tangential_law) {
  return method.traits().force_laws ? tangential_law : std::string(method.name());
}

std::string memory_of(const std::string& scene, const std::string& name) {
  const auto root = parsed_toml(scene, name);
  const auto kind = root.at_path("method.kind").value_or(std::string());
  const auto method = method_kinds().make(kind);
  return method ? memory_of(*method, root.at_path("contact.tangential.law").value_or(std::string())) : kind;
}

std::string memory_of(const Scene& scene) {
  return memory_of(*scene.method,
                   std::visit([](const auto& law) { return std::string(law.name); }, scene.contact.tangential));
}

template <int D>
void take_facts(const StartState<D>& state, Scene& scene) {
  auto& start = scene.start;
  const auto names = scene.material_names();
  constexpr double same = 1e-9;  // masses that differ by rounding alone
  double lightest = 0.0;
  for (const auto& row : state.grains) {
    const double diameter = 2.0 * row.radius;
    start.smallest = start.largest > 0.0 ? std::min(start.smallest, diameter) : diameter;
    start.largest = std::max(start.largest, diameter);
    start.base |= row.base;
    if (row.fixed) continue;
    ++start.moving;
    const double usual = scene.mass_of(diameter, row.material < names.size() ? names[row.material] : names.front());
    const double mass = row.mass.value_or(usual);
    const double ratio = std::fabs(mass - usual) > same * usual ? mass / usual : 1.0;
    lightest = lightest > 0.0 ? std::min(lightest, ratio) : ratio;
    start.total_mass += mass;
    start.total_size += diameter;
    const double speed2 = start.at_rest ? 0.0 : dot(row.velocity, row.velocity);
    const double rise = scene.gravity > 0.0 ? 0.5 * speed2 / scene.gravity : 0.0;
    start.fall = std::max(start.fall, rise + std::max(0.0, row.position[up<D>]));
  }
  if (lightest > 0.0) start.lightest = lightest;
}

/// "1, 2" or "1, 2, 3".
template <int D>
std::string place_text(const Vec<D>& place) {
  std::string text;
  for (int k = 0; k < D; ++k) text += fmt::format("{}{:.6g}", k == 0 ? "" : ", ", double{place[k]});
  return text;
}

/// Grains that move must not lie in walls, as placed ones must not, nor behind planes.
template <int D>
void check_room(const StartState<D>& state, const Scene& scene, Reader& reader) {
  if (!reader.none()) return;
  constexpr double allowed = 0.1;  // diameters by which walls may press into a grain
  constexpr std::size_t most = 10;
  const auto walls = make_walls<D>(scene);
  const auto names = wall_names(scene);
  const auto now = walls_at(walls, {}, 0.0);
  const auto box = make_box<D>(scene);
  std::size_t count = 0;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    const auto& row = state.grains[k];
    if (row.fixed) continue;
    const auto wall = overlapping_wall(walls, now, box, row.position, row.radius * (1.0 - 2.0 * allowed), 1.0);
    if (!wall || ++count > most) continue;
    const auto at = above(walls[*wall], now[*wall], from_wall(walls[*wall], now[*wall], row.position, box));
    const auto where = at.height < 0.0
                           ? fmt::format("its centre lies {:.3g} behind wall \"{}\"", -at.height, names[*wall])
                           : fmt::format("wall \"{}\" presses into it by {:.3g} diameters", names[*wall],
                                         wall_overlap(walls[*wall], at, row.radius) / (2.0 * row.radius));
    reader.problem("start.from",
                   fmt::format(" = \"{}\": grain {} at ({}): {}", scene.start.from,
                               row.id.value_or(static_cast<std::int64_t>(k)), place_text(row.position), where));
  }
  if (count > most) {
    reader.problem("start.from",
                   fmt::format(" = \"{}\": and {} more grains in or behind walls", scene.start.from, count - most));
  }
}

void check_base(const Scene& scene, Reader& reader) {
  if (!scene.start.base || !scene.base->of_grains()) return;
  if (!reader.sound("base.kind")) return;
  reader.problem("base.kind", fmt::format(" = \"{}\": the grains of start.from bring their base with them; leave "
                                          "base.kind out",
                                          scene.base->name()));
}

/// Grains outside the box along a level axis; `key` is that of half the width of the box.
template <int D>
void check_inside(const StartState<D>& state, const Scene& scene, int axis, double half_width, const std::string& key,
                  Reader& reader) {
  std::size_t outside = 0;
  double low = 0.0;
  double high = 0.0;
  for (const auto& row : state.grains) {
    const double place = row.position[axis];
    low = &row == &state.grains.front() ? place : std::min(low, place);
    high = &row == &state.grains.front() ? place : std::max(high, place);
    if (std::fabs(place) > half_width) ++outside;
  }
  if (outside == 0 || !reader.sound(key)) return;
  reader.problem("start.from", fmt::format(" = \"{0}\": {1} of its grains lie outside the box, {2} = +-{3}: they lie "
                                           "at {2} = {4:.6g} to {5:.6g}; set start.shift or {6}",
                                           scene.start.from, outside, "xyz"[axis], half_width, low, high, key));
}

template <int D>
void check_grains(const StartState<D>& state, const Scene& scene, Reader& reader) {
  check_inside(state, scene, 0, scene.box.half_width, "box.half_width", reader);
  if constexpr (D == 3) check_inside(state, scene, 1, scene.box.half_depth, "box.half_depth", reader);
  const auto materials = scene.material_names().size();
  const auto unknown = std::count_if(state.grains.begin(), state.grains.end(),
                                     [&](const auto& row) { return row.material >= materials; });
  if (unknown > 0) {
    reader.problem("start.from", fmt::format(" = \"{}\": {} of its grains are of materials that this scene has not: it "
                                             "needs the same list of [[material]]",
                                             scene.start.from, unknown));
  }
  check_base(scene, reader);
}

}  // namespace

template <int D>
std::optional<StartState<D>> look_at_start(Scene& scene, Reader& reader, const std::string& folder) {
  auto& start = scene.start;
  if (start.from.empty()) return std::nullopt;
  // A path on the command line is relative to the current folder.
  const fs::path beside = reader.from_command_line("start.from") ? fs::path() : fs::path(folder);
  start.path = start_file((beside / start.from).string());
  try {
    auto state = state_at_start<D>(scene);
    take_facts(state, scene);
    check_grains(state, scene, reader);
    start.warnings = state.warnings;
    check_units(state, scene, reader, start.warnings);
    const auto deepest = deepest_overlap(state, scene);
    add_warnings(state, scene, deepest, start.warnings);
    for (auto& warning : start.warnings) warning = "start.from: " + warning;
    start.description = describe_start(state, scene, deepest);
    start.histories =
        !state.scene.empty() && keeps_contacts(start) && memory_of(state.scene, start.path) == memory_of(scene);
    check_room(state, scene, reader);
    return state;
  } catch (const InputError& error) {
    for (const auto& line : error.problems()) {
      reader.problem("start.from", fmt::format(" = \"{}\": {}", start.from, line));
    }
  }
  return std::nullopt;
}

template std::optional<StartState<2>> look_at_start(Scene&, Reader&, const std::string&);
template std::optional<StartState<3>> look_at_start(Scene&, Reader&, const std::string&);

void expect_start(Scene& scene, const Scene& earlier, Reader& reader) {
  auto& start = scene.start;
  start.path = start.from + "/run.h5";
  start.expected = true;
  start.smallest = earlier.smallest_diameter();
  start.largest = earlier.largest_diameter();
  start.base = earlier.start.base || earlier.base->of_grains();
  start.lightest = earlier.start.lightest;
  start.moving = earlier.start.moving + earlier.source->released() + earlier.source->placed() +
                 std::count_if(earlier.placed.begin(), earlier.placed.end(),
                               [](const PlacedGrain& grain) { return !grain.fixed; });
  const double diameter = earlier.usual_diameter();
  start.total_mass = static_cast<double>(start.moving) * scene.mass_of(diameter, scene.material_names().front());
  start.total_size = static_cast<double>(start.moving) * diameter;
  start.histories = keeps_contacts(start) && memory_of(earlier) == memory_of(scene);
  check_base(scene, reader);
}

std::string surface_file(std::size_t piece) { return fmt::format("surface-{}.stl", piece); }

Scene with_own_start(Scene scene) {
  auto& start = scene.start;
  if (!start.from.empty()) start.from = "start" + fs::path(start.path).extension().string();
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    auto& piece = scene.pieces[k];
    if (piece.shape && !piece.shape->found_file().empty()) piece.shape->rename_file(surface_file(k));
  }
  return scene;
}

}  // namespace repose
