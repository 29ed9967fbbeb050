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

void take_facts(const StartState& state, Scene& scene) {
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
    start.fall = std::max(start.fall, rise + std::max(0.0, row.position[1]));
  }
  if (lightest > 0.0) start.lightest = lightest;
}

/// Grains that move must not lie in walls, as placed ones must not, nor behind planes.
void check_room(const StartState& state, const Scene& scene, Reader& reader) {
  if (!reader.none()) return;
  constexpr double allowed = 0.1;  // diameters by which walls may press into a grain
  constexpr std::size_t most = 10;
  const auto walls = make_walls(scene);
  const auto names = wall_names(scene);
  const auto now = walls_at(walls, {}, 0.0);
  const auto box = make_box(scene);
  std::size_t count = 0;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    const auto& row = state.grains[k];
    if (row.fixed) continue;
    const auto wall = overlapping_wall(walls, now, box, row.position, row.radius * (1.0 - 2.0 * allowed), 1.0);
    if (!wall || ++count > most) continue;
    const auto at = above(walls[*wall], now[*wall].normal, from_wall(walls[*wall], now[*wall], row.position, box));
    const auto where = at.height < 0.0
                           ? fmt::format("its centre lies {:.3g} behind wall \"{}\"", -at.height, names[*wall])
                           : fmt::format("wall \"{}\" presses into it by {:.3g} diameters", names[*wall],
                                         wall_overlap(walls[*wall], at, row.radius) / (2.0 * row.radius));
    reader.problem("start.from",
                   fmt::format(" = \"{}\": grain {} at ({:.6g}, {:.6g}): {}", scene.start.from,
                               row.id.value_or(static_cast<std::int64_t>(k)), row.position[0], row.position[1], where));
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

void check_grains(const StartState& state, const Scene& scene, Reader& reader) {
  const auto materials = scene.material_names().size();
  std::size_t outside = 0;
  std::size_t unknown = 0;
  double left = 0.0;
  double right = 0.0;
  for (const auto& row : state.grains) {
    left = &row == &state.grains.front() ? row.position[0] : std::min(left, row.position[0]);
    right = &row == &state.grains.front() ? row.position[0] : std::max(right, row.position[0]);
    if (std::fabs(row.position[0]) > scene.box.half_width) ++outside;
    if (row.material >= materials) ++unknown;
  }
  const auto says = fmt::format(" = \"{}\": ", scene.start.from);
  if (outside > 0 && reader.sound("box.half_width")) {
    reader.problem("start.from",
                   fmt::format("{}{} of its grains lie outside the box, x = +-{}: they lie at x = {:.6g} to "
                               "{:.6g}; set start.shift or box.half_width",
                               says, outside, scene.box.half_width, left, right));
  }
  if (unknown > 0) {
    reader.problem("start.from", fmt::format("{}{} of its grains are of materials that this scene has not: it needs "
                                             "the same list of [[material]]",
                                             says, unknown));
  }
  check_base(scene, reader);
}

}  // namespace

std::optional<StartState> look_at_start(Scene& scene, Reader& reader, const std::string& folder) {
  auto& start = scene.start;
  if (start.from.empty()) return std::nullopt;
  // A path on the command line is relative to the current folder.
  const fs::path beside = reader.from_command_line("start.from") ? fs::path() : fs::path(folder);
  start.path = start_file((beside / start.from).string());
  try {
    auto state = state_at_start(scene);
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

Scene with_own_start(Scene scene) {
  auto& start = scene.start;
  if (!start.from.empty()) start.from = "start" + fs::path(start.path).extension().string();
  return scene;
}

}  // namespace repose
