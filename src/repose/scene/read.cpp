// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/read.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/for_method.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/loads.hpp"
#include "repose/scene/overlaps.hpp"
#include "repose/scene/reader.hpp"
#include "repose/scene/start.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <optional>

namespace repose {

namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string key_of(const std::string& setting) { return trimmed(setting.substr(0, setting.find('='))); }

/// The entry of a list of tables with this name, by its number.
std::optional<std::size_t> entry_named(const toml::array& list, const std::string& name) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto* entry = list[k].as_table();
    if (entry != nullptr && entry->get("name") != nullptr && entry->get("name")->value<std::string>() == name) return k;
  }
  return std::nullopt;
}

/// The table of the next steps of a key, from one step on. A list of tables, such as the planes, has its names as
/// steps. `read` becomes the key as it is read, with numbers of entries. Null where there is no such table.
toml::table* step_into(toml::table& table, const std::string& step, std::string& rest, std::string& read) {
  if (table.get(step) == nullptr) table.insert(step, toml::table{});
  read += step;
  auto* list = table.get(step)->as_array();
  if (list == nullptr) {
    read += ".";
    return table.get(step)->as_table();
  }
  const auto dot = rest.find('.');
  const auto entry = entry_named(*list, rest.substr(0, dot));
  if (dot == std::string::npos || !entry) return nullptr;
  rest = rest.substr(dot + 1);
  read += fmt::format("[{}].", *entry);
  return (*list)[*entry].as_table();
}

/// Puts "a.b=value" into the table; returns the key as it is read, or adds a problem and returns "".
std::string apply(const std::string& setting, const std::string& origin, toml::table& root,
                  std::vector<std::string>& problems) {
  const auto equals = setting.find('=');
  const std::string key = key_of(setting);
  const bool empty_step = key.empty() || key.front() == '.' || key.back() == '.' || key.find("..") != std::string::npos;
  if (equals == std::string::npos || empty_step || setting.find('\n') != std::string::npos) {
    problems.push_back(fmt::format("{}: must be KEY=VALUE, with a key as in contact.friction", origin));
    return "";
  }
  if (key.find('[') != std::string::npos) {
    problems.push_back(fmt::format("{}: an entry of a list is named, as in plane.NAME.point", origin));
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
  std::string read;
  for (auto dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
    const std::string step = rest.substr(0, dot);
    rest = rest.substr(dot + 1);
    auto* next = step_into(*table, step, rest, read);
    if (next == nullptr) {
      const bool is_list = table->get(step)->is_array();
      problems.push_back(fmt::format("{}: {}: {}", origin, key,
                                     is_list ? fmt::format("\"{}\" is a list; a key of it is {}.NAME.KEY, where an "
                                                           "entry has that name",
                                                           step, step)
                                             : fmt::format("\"{}\" is not a table", step)));
      return "";
    }
    table = next;
  }
  table->insert_or_assign(rest, *holder.get("value"));
  return read + rest;
}

/// What one key alone cannot tell. A method judges its step last, for which all else must be sound.
void check_all(const Scene& scene, Problems& problems) {
  if (const auto what = title_problem(scene.title); !what.empty()) problems.problem("title", what);
  // Laws are kept for every two materials.
  constexpr std::size_t most_materials = 100;
  if (scene.materials.size() > most_materials) {
    problems.problem("material", fmt::format(": {} materials; at most {}", scene.materials.size(), most_materials));
    return;
  }
  check_species(scene, problems);
  check_analysis(scene, problems);
  if (scene.method->traits().has_forces()) {
    check_force_scale(scene, problems);
    check_contact(scene, problems);
  }
  check_boundaries(scene, problems);
  check_sources(scene, problems);
  if (scene.method->traits().follows_time) check_stop(scene, problems);
  check_loads(scene, problems);
  scene.method->check(scene, problems);
}

Scene read_table(const toml::table& root, const std::string& name,
                 const std::vector<std::pair<std::string, std::string>>& origins, std::vector<std::string> problems,
                 const Scene* earlier = nullptr) {
  Reader reader(root, name);
  for (const auto& [key, origin] : origins) reader.comes_from(key, origin);
  Scene scene;
  show_keys(scene, reader);
  reader.report_unknown_keys();
  const auto folder = std::filesystem::path(name).parent_path().string();
  for (auto& piece : scene.pieces) {
    if (scene.dimension == 3) piece.shape->find(folder);
  }
  with_dimension(scene.dimension, [&](auto dimension) {
    std::optional<StartState<dimension>> start;
    if (earlier != nullptr) {
      expect_start(scene, *earlier, reader);
    } else {
      start = look_at_start<dimension>(scene, reader, folder);
    }
    check_all(scene, reader);
    check_overlaps(scene, start, reader);
  });
  problems.insert(problems.end(), reader.problems().begin(), reader.problems().end());
  if (!problems.empty()) throw InputError(problems);
  return scene;
}

}  // namespace

Scene scene_from_text(const std::string& text, const std::string& name, const Overrides& overrides) {
  toml::table root = parsed_toml(text, name);
  std::vector<std::string> problems;
  std::vector<std::pair<std::string, std::string>> origins;
  const auto apply_settings = [&](const auto& suits) {
    for (std::size_t k = 0; k < overrides.set.size(); ++k) {
      const auto& setting = overrides.set[k];
      if (!suits(key_of(setting))) continue;
      const auto origin = k < overrides.origins.size() ? overrides.origins[k] : "--set " + setting;
      const auto key = apply(setting, origin, root, problems);
      if (!key.empty()) origins.emplace_back(key, origin);
    }
  };
  const auto chooses_method = [](const std::string& key) { return key == "method" || key == "method.kind"; };
  apply_settings(chooses_method);
  apply_keys_for_method(root, name, problems);
  apply_settings([&](const std::string& key) { return !chooses_method(key); });
  if (overrides.seed) {
    root.insert_or_assign("seed", *overrides.seed);
    origins.emplace_back("seed", "--seed");
  }
  return read_table(root, name, origins, problems, overrides.earlier);
}

Scene read_scene(const std::string& path, const Overrides& overrides) {
  return scene_from_text(text_of_file(path), path, overrides);
}

Scene checked(const Scene& scene) { return read_table(parsed_toml(given_text(scene), ""), "", {}, {}); }

}  // namespace repose
