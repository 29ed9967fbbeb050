// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/sweep/plan_reader.hpp"
#include "repose/sweep/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <map>

namespace fs = std::filesystem;

namespace repose {

Setting SweepReader::setting(const std::string& key, const toml::node& value) const {
  const double number = value.is_number() ? value.value_or(0.0) : std::numeric_limits<double>::quiet_NaN();
  return {{key, toml_text(value), number}, place(value)};
}

bool SweepReader::check_setting(const std::string& key, const std::string& prefix, const toml::node& value) {
  if (key == "seed") problem(value, fmt::format("{}seed: the sweep sets it; use seeds", prefix));
  if (key == "start.from") {
    problem(value,
            fmt::format("{}start.from: goes into a scene, which is copied with its start; or use starts_from", prefix));
  }
  return key != "seed" && key != "start.from";
}

std::vector<Setting> SweepReader::settings(const toml::table& table, const std::string& prefix) {
  std::vector<Setting> found;
  const auto* node = table.get("set");
  if (node == nullptr) return found;
  const auto* values = node->as_table();
  if (values == nullptr) {
    problem(*node, fmt::format("{}set: must be a table of keys of the scene", prefix));
    return found;
  }
  for (const auto& [key, value] : values_below(*values)) {
    check_setting(key, prefix + "set.", *value);
    found.push_back(setting(key, *value));
  }
  return found;
}

/// Whether [vary] and [[point]] make more points than a sweep may have, which is then a problem.
bool SweepReader::too_many_points() {
  double count = 1.0;
  if (const auto* points = root_.get_as<toml::array>("point")) count *= static_cast<double>(points->size());
  if (const auto* values = root_.get_as<toml::table>("vary")) {
    for (const auto& [key, value] : values_below(*values)) {
      if (const auto* list = value->as_array()) count *= static_cast<double>(std::max<std::size_t>(1, list->size()));
    }
  }
  if (count <= static_cast<double>(most_points)) return false;
  problems_.push_back(fmt::format("{}: vary and point make {:g} points: at most {}", path_, count, most_points));
  return true;
}

/// Every combination of the values in [vary]; a single empty one without.
std::vector<std::vector<Setting>> SweepReader::combinations() {
  std::vector<std::vector<Setting>> all(1);
  const auto* node = root_.get("vary");
  if (node == nullptr) return all;
  const auto* values = node->as_table();
  if (values == nullptr) {
    problem(*node, "vary: must be a table of keys of the scene, each with a list of values");
    return all;
  }
  for (const auto& [key, value] : values_below(*values)) {
    const auto* list = value->as_array();
    if (!check_setting(key, "vary.", *value)) continue;
    if (list == nullptr || list->empty()) {
      problem(*value, fmt::format("vary.{} = {}: must be a list of values", key, toml_text(*value)));
    } else {
      std::vector<std::vector<Setting>> grown;
      for (const auto& combination : all) {
        for (const auto& entry : *list) {
          grown.push_back(combination);
          grown.back().push_back(setting(key, entry));
        }
      }
      all = std::move(grown);
    }
  }
  return all;
}

namespace {

/// A name that any file system takes.
std::string fit_for_a_folder(std::string name) {
  for (auto& c : name) {
    const bool fine =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string("._=+-").find(c) != std::string::npos;
    if (!fine) c = '-';
  }
  if (!name.empty() && name.front() == '.') name.front() = '-';
  return name;
}

std::string last_step(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::string bare(const std::string& text) {
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.front() == text.back();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// Whether a key says where grains come from, which a point that starts from the members of another has no use for.
bool brings_grains(const std::string& key) {
  const auto table = key.substr(0, key.find('.'));
  return table == "source" || table == "base" || table == "grain";
}

Overrides overrides_of(const PointText& wanted, std::int64_t seed) {
  Overrides overrides;
  overrides.seed = seed;
  for (const auto* list : {&wanted.common, &wanted.own, &wanted.varied}) {
    for (const auto& [parameter, origin] : *list) {
      if (list != &wanted.own && !wanted.starts_from.empty() && brings_grains(parameter.key)) continue;
      overrides.set.push_back(fmt::format("{} = {}", parameter.key, parameter.text));
      overrides.origins.push_back(origin);
    }
  }
  return overrides;
}

}  // namespace

void SweepReader::check_name(const std::string& name) {
  constexpr std::size_t longest_name = 200;  // file systems allow 255 bytes
  if (name.size() > longest_name) {
    problems_.push_back(
        fmt::format("{}: the name of a point has {} letters: at most {}; give it a shorter [[point]] name", path_,
                    name.size(), longest_name));
  } else if (!point_names_.insert(name).second) {
    problems_.push_back(fmt::format("{}: two points have the name \"{}\"", path_, name));
  }
}

void SweepReader::add_point(SweepPlan& plan, const PointText& wanted) {
  SweepPoint point;
  point.name = fit_for_a_folder(wanted.name);
  check_name(point.name);
  for (const auto* list : {&wanted.own, &wanted.varied}) {
    for (const auto& [parameter, origin] : *list) {
      point.parameters.push_back(parameter);
      if (std::find(plan.keys.begin(), plan.keys.end(), parameter.key) == plan.keys.end()) {
        plan.keys.push_back(parameter.key);
      }
    }
  }
  point.file = (fs::path(path_).parent_path() / wanted.scene).string();
  point.overrides = overrides_of(wanted, plan.seeds.empty() ? 1 : plan.seeds.front());
  auto overrides = point.overrides;
  if (!wanted.starts_from.empty()) {
    const auto name = fit_for_a_folder(wanted.starts_from);
    const auto found =
        std::find_if(plan.points.begin(), plan.points.end(), [&](const auto& other) { return other.name == name; });
    // A point that is missing, or whose scene is wrong, has been reported.
    if (found == plan.points.end() || !found->scene.method) return;
    point.starts_from = static_cast<std::size_t>(found - plan.points.begin());
    overrides.earlier = &found->scene;
    overrides.set.push_back(fmt::format("start.from = \"members/{}\"", name));
  }
  try {
    point.scene = read_scene(point.file, overrides);
  } catch (const InputError& error) {
    problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
  }
  plan.points.push_back(std::move(point));
}

std::string SweepReader::starts_from(const toml::table& table, const std::string& prefix, std::size_t points_before) {
  const auto name = text(table, prefix, "starts_from", false);
  if (name.empty()) return "";
  const auto& list = *root_.get("point")->as_array();
  for (std::size_t k = 0; k < points_before; ++k) {
    if (list.get(k)->as_table()->at_path("name").value_or(std::string()) == name) return name;
  }
  problem(*table.get("starts_from"),
          fmt::format("{}starts_from = \"{}\": no such point before this one", prefix, name));
  return name;
}

void SweepReader::read_points(SweepPlan& plan) {
  if (too_many_points()) return;
  const auto general_scene = text(root_, "", "scene", root_.get("point") == nullptr);
  const auto common = settings(root_, "");
  const auto varied = combinations();
  std::map<std::string, int> short_names;
  if (!varied.empty()) {
    for (const auto& entry : varied.front()) ++short_names[last_step(entry.parameter.key)];
  }
  const auto named = [&](std::string name, const std::vector<Setting>& combination) {
    for (const auto& [parameter, origin] : combination) {
      const auto step = last_step(parameter.key);
      name += fmt::format("{}{}={}", name.empty() ? "" : "_", short_names[step] > 1 ? parameter.key : step,
                          bare(parameter.text));
    }
    return name;
  };
  const auto* list = list_of_tables("point");
  if (list == nullptr) {
    if (!problems_.empty() && general_scene.empty()) return;
    for (const auto& combination : varied) {
      const auto name = named("", combination);
      add_point(plan, {.name = name.empty() ? fs::path(general_scene).stem().string() : name,
                       .scene = general_scene,
                       .common = common,
                       .varied = combination});
    }
    return;
  }
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto& table = *list->get(k)->as_table();
    const auto prefix = fmt::format("point[{}].", k);
    check_keys(table, prefix, {"name", "scene", "set", "starts_from"});
    const auto name = text(table, prefix, "name", true);
    auto scene = text(table, prefix, "scene", general_scene.empty());
    if (scene.empty()) scene = general_scene;
    if (name.empty() && table.contains("name") && table.get("name")->is_string()) {
      problem(*table.get("name"), prefix + "name = \"\": must not be empty");
    }
    if (name.empty() || scene.empty()) continue;
    const auto own = settings(table, prefix);
    const auto from = starts_from(table, prefix, k);
    for (const auto& combination : varied) {
      add_point(plan, {.name = named(name, combination),
                       .scene = scene,
                       .starts_from = from.empty() ? "" : named(from, combination),
                       .common = common,
                       .own = own,
                       .varied = combination});
    }
  }
}

}  // namespace repose
