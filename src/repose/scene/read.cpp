// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/read.hpp"

#include "repose/core/errors.hpp"
#include "repose/laws/time_step.hpp"
#include "repose/scene/reader.hpp"
#include "repose/scene/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Puts "a.b=value" into the table; returns the key, or adds a problem and returns "".
std::string apply(const std::string& setting, const std::string& origin, toml::table& root,
                  std::vector<std::string>& problems) {
  const auto equals = setting.find('=');
  const std::string key = trimmed(setting.substr(0, equals));
  const bool empty_step = key.empty() || key.front() == '.' || key.back() == '.' || key.find("..") != std::string::npos;
  if (equals == std::string::npos || empty_step || setting.find('\n') != std::string::npos) {
    problems.push_back(fmt::format("{}: must be KEY=VALUE, with a key as in contact.friction", origin));
    return "";
  }
  if (key.find('[') != std::string::npos) {
    problems.push_back(fmt::format("{}: entries of lists are set in the scene file only", origin));
    return "";
  }
  if (static_cast<std::size_t>(std::count(key.begin(), key.end(), '.')) >= most_key_steps) {
    problems.push_back(fmt::format("{}: a key of more than {} steps", origin, most_key_steps));
    return "";
  }
  const std::string value = trimmed(setting.substr(equals + 1));
  toml::table holder;
  try {
    holder = parsed_toml("value = " + value, origin);
  } catch (const InputError&) {
    holder.insert_or_assign("value", value);  // a bare word is text
  }
  toml::table* table = &root;
  std::string rest = key;
  for (auto dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
    const std::string step = rest.substr(0, dot);
    if (table->get(step) == nullptr) table->insert(step, toml::table{});
    table = table->get(step)->as_table();
    if (table == nullptr) {
      problems.push_back(fmt::format("{}: {}: \"{}\" is not a table", origin, key, step));
      return "";
    }
    rest = rest.substr(dot + 1);
  }
  table->insert_or_assign(rest, *holder.get("value"));
  return key;
}

/// A lattice pile stands on what it can stand on, and within the box.
void check_lattice(const Scene& scene, Reader& reader) {
  constexpr std::int64_t most_rows = 4000;
  const auto& source = scene.source;
  if (source.rows > most_rows && reader.sound("source.rows")) {
    reader.problem("source.rows", fmt::format(" = {}: must be at most {}", source.rows, most_rows));
  }
  if (scene.base.kind == "none" && reader.sound("source.kind") && reader.sound("base.kind")) {
    reader.problem("source.kind", " = \"lattice\": needs a base to stand on: base.kind = \"row\" or \"plane\"");
  }
  const double d = scene.grains.diameter;
  const bool fits = scene.base.spacing >= d && scene.base.spacing <= 1.5 * d;
  if (scene.base.kind == "row" && reader.sound("base.spacing") && !fits) {
    reader.problem("base.spacing", fmt::format(" = {}: must be 1 to 1.5 diameters, {} to {}, under a lattice [L]",
                                               scene.base.spacing, d, 1.5 * d));
  }
  if (scene.grains.polydispersity > 0.0 && reader.sound("grains.polydispersity")) {
    reader.problem("grains.polydispersity", fmt::format(" = {}: must be 0 for a lattice", scene.grains.polydispersity));
  }
  const double half = 0.5 * static_cast<double>(source.rows + 1) * scene.base_pitch();
  const double room = scene.base.kind == "row" && scene.box.x == "open" ? scene.base.half_width : scene.box.half_width;
  if (std::fabs(source.x) + half > room && reader.sound("source.rows") && reader.sound("box.half_width")) {
    reader.problem("source.rows", fmt::format(" = {}: the pile must lie within x = +-{}", source.rows, room));
  }
}

/// What one key alone cannot tell.
void check_together(const Scene& scene, Reader& reader) {
  const bool continuous = std::holds_alternative<Continuous>(scene.contact.normal);
  if (continuous && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("gravity", " = 0: the continuous law has its force scale from gravity; use hooke or gravity > 0");
  }
  if (scene.source.kind == "none" && scene.placed.empty() && reader.sound("grain") && reader.sound("source.kind")) {
    reader.problem("source.kind", ": there are no grains: needs a source.kind or at least one [[grain]]");
  }
  if (scene.source.kind == "pour" && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("source.kind", " = \"pour\": needs gravity > 0");
  }
  if (scene.source.kind == "lattice") check_lattice(scene, reader);
  if (!scene.stop.time && !scene.stop.at_rest && reader.sound("stop.time") && reader.sound("stop.at_rest")) {
    reader.problem("stop", ": missing: give time, at_rest or both; the run ends at whichever comes first");
  }
  if (scene.stop.at_rest && scene.gravity == 0.0 && reader.sound("stop.at_rest") && reader.sound("gravity")) {
    reader.problem(
        "stop.at_rest",
        fmt::format(" = {}: is measured in grain weights and needs gravity > 0; use stop.time", *scene.stop.at_rest));
  }
  const double d = scene.grains.diameter;
  constexpr double most_base_grains = 1e7;
  const double row = scene.box.x == "periodic" ? scene.box.half_width : scene.base.half_width;
  if (scene.base.kind == "row" && 2.0 * row / scene.base.spacing > most_base_grains && reader.sound("base.spacing") &&
      reader.sound("base.half_width")) {
    reader.problem("base.spacing",
                   fmt::format(" = {}: the row of half-width {} would have {:.3g} grains; at most {:g}",
                               scene.base.spacing, row, 2.0 * row / scene.base.spacing, most_base_grains));
  }
  if (scene.box.x == "periodic" && reader.sound("box.half_width")) {
    if (scene.box.half_width < 4.0 * scene.largest_diameter()) {
      reader.problem("box.half_width",
                     fmt::format(" = {}: a periodic box must be at least 8 diameters wide", scene.box.half_width));
    }
    const double discs = 2.0 * scene.box.half_width / scene.base.spacing;
    if (scene.base.kind == "row" && reader.sound("base.spacing") &&
        std::fabs(discs - std::round(discs)) > 1e-9 * discs) {
      reader.problem("base.spacing",
                     fmt::format(" = {}: must divide the width {} of the periodic box into whole spacings",
                                 scene.base.spacing, 2.0 * scene.box.half_width));
    }
  } else if (scene.base.kind == "row" && reader.sound("base.half_width") && reader.sound("box.half_width") &&
             scene.box.half_width < scene.base.half_width) {
    reader.problem("box.half_width", fmt::format(" = {}: must be at least base.half_width = {}", scene.box.half_width,
                                                 scene.base.half_width));
  }
  if (scene.base.kind == "row" && reader.sound("base.spacing") && reader.sound("grains.diameter") &&
      scene.base.spacing >= 2.0 * d) {
    reader.problem("base.spacing",
                   fmt::format(" = {}: must be < {}, two diameters, or grains fall through the base [L]",
                               scene.base.spacing, 2.0 * d));
  }
  if (scene.source.kind == "pour" && reader.sound("source.half_width") && reader.sound("box.half_width") &&
      std::fabs(scene.source.x) + scene.source.half_width > scene.box.half_width) {
    reader.problem("source.half_width", fmt::format(" = {}: the opening must lie within the box, x = +-{}",
                                                    scene.source.half_width, scene.box.half_width));
  }
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const auto& [x, y] = scene.planes[k].normal;
    const auto key = fmt::format("plane[{}].normal", k);
    if (std::hypot(x, y) < 1e-100 && reader.sound(key)) {
      reader.problem(key, fmt::format(" = [{}, {}]: must have a direction", x, y));
    }
  }
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto key = fmt::format("grain[{}].position", k);
    if (std::fabs(scene.placed[k].position[0]) > scene.box.half_width && reader.sound(key) &&
        reader.sound("box.half_width")) {
      reader.problem(key, fmt::format(" = [{}, {}]: must lie within the box, x = +-{}", scene.placed[k].position[0],
                                      scene.placed[k].position[1], scene.box.half_width));
    }
  }
}

/// Four digits of x > 0, rounded down.
double rounded_down(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(x)) - 3.0);
  return std::floor(x / digit) * digit;
}

/// The explicit step against the stiffest contact; only where all that it depends on is sound.
void check_time_step(const Scene& scene, Reader& reader) {
  if (!reader.problems().empty()) return;
  const double frequency = scene.contact_frequency();
  if (const double automatic = auto_phase / frequency; !scene.method.time_step) {
    if (std::isfinite(automatic) && automatic > 0.0) return;
    return reader.problem("method.time_step",
                          fmt::format(" = \"auto\": finds no step: the stiffest contact has the frequency w = {:.4g};"
                                      " give a step [T], or check stiffness, mass and diameter",
                                      frequency));
  }
  const double step = *scene.method.time_step;
  if (step * frequency <= largest_phase) return;
  reader.problem(
      "method.time_step",
      fmt::format(" = {}: unstable: the stiffest contact (a fall from the source) has the frequency w = {:.4g}"
                  " and w dt = {:.3g} > 1; the largest step that is not refused is {:.4g}, \"auto\" takes "
                  "{:.4g} [T]",
                  step, frequency, step * frequency, rounded_down(largest_phase / frequency), auto_phase / frequency));
}

}  // namespace

Scene read_scene_text(const std::string& text, const std::string& name, const Overrides& overrides) {
  toml::table root = parsed_toml(text, name);
  std::vector<std::string> problems;
  std::vector<std::pair<std::string, std::string>> origins;
  for (std::size_t k = 0; k < overrides.set.size(); ++k) {
    const auto& setting = overrides.set[k];
    const auto origin = k < overrides.origins.size() ? overrides.origins[k] : "--set " + setting;
    const auto key = apply(setting, origin, root, problems);
    if (!key.empty()) origins.emplace_back(key, origin);
  }
  if (overrides.seed) {
    root.insert_or_assign("seed", *overrides.seed);
    origins.emplace_back("seed", "--seed");
  }
  Reader reader(root, name);
  for (const auto& [key, origin] : origins) reader.comes_from(key, origin);
  Scene scene;
  go_through(scene, reader);
  reader.report_unknown_keys();
  check_together(scene, reader);
  check_time_step(scene, reader);
  problems.insert(problems.end(), reader.problems().begin(), reader.problems().end());
  if (!problems.empty()) throw InputError(problems);
  return scene;
}

Scene read_scene(const std::string& path, const Overrides& overrides) {
  return read_scene_text(text_of_file(path), path, overrides);
}

}  // namespace repose
