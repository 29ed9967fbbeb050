// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/sweep_plan.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/scene/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

namespace fs = std::filesystem;

namespace repose {

namespace {

constexpr std::size_t most_members = 1'000'000;

/// A value as it would stand in a file, on one line; numbers as short as they read back the same.
std::string toml_text(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    std::vector<std::string> entries;
    for (const auto& [name, child] : *table) {
      const std::string key(name.str());
      const bool plain = !key.empty() && key.find_first_not_of(
                                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                             "0123456789_-") == std::string::npos;
      entries.push_back(fmt::format("{} = {}", plain ? key : toml_quoted(key), toml_text(child)));
    }
    return fmt::format("{{ {} }}", fmt::join(entries, ", "));
  }
  if (const auto* list = node.as_array()) {
    std::vector<std::string> entries;
    for (const auto& entry : *list) entries.push_back(toml_text(entry));
    return fmt::format("[{}]", fmt::join(entries, ", "));
  }
  if (node.is_string()) return toml_quoted(node.value_or(std::string()));
  if (node.is_floating_point()) return toml_number(node.value_or(0.0));
  if (node.is_integer()) return fmt::format("{}", node.value_or(std::int64_t{0}));
  if (node.is_boolean()) return node.value_or(false) ? "true" : "false";
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

/// The values below a table with their dotted keys, in the order of the file; an inline table is a value.
std::vector<std::pair<std::string, const toml::node*>> values_below(const toml::table& table,
                                                                    const std::string& prefix = "") {
  std::vector<std::pair<std::string, const toml::node*>> found;
  for (const auto& [name, child] : table) {
    const std::string key = prefix.empty() ? std::string(name.str()) : fmt::format("{}.{}", prefix, name.str());
    const auto* inner = child.as_table();
    if (inner != nullptr && !inner->is_inline()) {
      const auto below = values_below(*inner, key);
      found.insert(found.end(), below.begin(), below.end());
    } else {
      found.emplace_back(key, &child);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const auto& first = a.second->source().begin;
    const auto& second = b.second->source().begin;
    return std::tie(first.line, first.column) < std::tie(second.line, second.column);
  });
  return found;
}

/// A key of the scene with one of its values.
struct Setting {
  Parameter parameter;
  std::string origin;  // file:line
};

class SweepReader {
 public:
  SweepReader(const toml::table& root, std::string path) : root_(root), path_(std::move(path)) {}

  SweepPlan read();

 private:
  void problem(const toml::node& node, const std::string& what) {
    problems_.push_back(fmt::format("{}: {}", place(node), what));
  }
  std::string place(const toml::node& node) const {
    const auto line = node.source().begin.line;
    return line > 0 ? fmt::format("{}:{}", path_, line) : path_;
  }
  void check_keys(const toml::table& table, const std::string& prefix, const std::set<std::string>& known);
  std::string text(const toml::table& table, const std::string& prefix, const std::string& key, bool needed);
  std::optional<double> number(const toml::table& table, const std::string& prefix, const std::string& key);
  std::vector<std::string> names(const toml::table& table, const std::string& prefix, const std::string& key);
  const toml::array* list_of_tables(const std::string& key);
  Setting setting(const std::string& key, const toml::node& value) const;
  std::vector<Setting> settings(const toml::table& table, const std::string& prefix);
  std::vector<std::vector<Setting>> combinations();
  void read_seeds(SweepPlan& plan);
  void read_points(SweepPlan& plan);
  void add_point(SweepPlan& plan, const std::string& name, const std::string& scene, const std::vector<Setting>& common,
                 const std::vector<Setting>& own);
  void read_claims(SweepPlan& plan);

  const toml::table& root_;
  std::string path_;
  std::vector<std::string> problems_;
};

void SweepReader::check_keys(const toml::table& table, const std::string& prefix, const std::set<std::string>& known) {
  for (const auto& [name, child] : table) {
    if (known.contains(std::string(name.str()))) continue;
    problem(child, fmt::format("{}{}: unknown key; known here: {}", prefix, name.str(), fmt::join(known, ", ")));
  }
}

std::string SweepReader::text(const toml::table& table, const std::string& prefix, const std::string& key,
                              bool needed) {
  const auto* node = table.get(key);
  if (node == nullptr) {
    if (needed) problem(table, fmt::format("{}{}: missing", prefix, key));
    return "";
  }
  if (!node->is_string()) problem(*node, fmt::format("{}{} = {}: must be text", prefix, key, toml_text(*node)));
  return node->value_or(std::string());
}

std::optional<double> SweepReader::number(const toml::table& table, const std::string& prefix, const std::string& key) {
  const auto* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    problem(*node, fmt::format("{}{} = {}: must be a finite number", prefix, key, toml_text(*node)));
    return std::nullopt;
  }
  return value;
}

std::vector<std::string> SweepReader::names(const toml::table& table, const std::string& prefix,
                                            const std::string& key) {
  std::vector<std::string> found;
  const auto* node = table.get(key);
  if (node == nullptr) return found;
  const auto* list = node->as_array();
  if (list == nullptr || !list->is_homogeneous(toml::node_type::string) || list->size() < 2) {
    problem(*node, fmt::format("{}{}: must be a list of at least two names of points", prefix, key));
    return found;
  }
  for (const auto& entry : *list) found.push_back(entry.value_or(std::string()));
  return found;
}

const toml::array* SweepReader::list_of_tables(const std::string& key) {
  const auto* node = root_.get(key);
  if (node == nullptr) return nullptr;
  const auto* list = node->as_array();
  if (list == nullptr || list->empty() || !list->is_homogeneous(toml::node_type::table)) {
    problem(*node, fmt::format("{}: must be a list of tables, each headed [[{}]]", key, key));
    return nullptr;
  }
  return list;
}

Setting SweepReader::setting(const std::string& key, const toml::node& value) const {
  const double number = value.is_number() ? value.value_or(0.0) : std::numeric_limits<double>::quiet_NaN();
  return {{key, toml_text(value), number}, place(value)};
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
    if (key == "seed") problem(*value, fmt::format("{}set.seed: the sweep sets it; use seeds", prefix));
    found.push_back(setting(key, *value));
  }
  return found;
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
    if (key == "seed") {
      problem(*value, "vary.seed: the sweep sets it; use seeds");
    } else if (list == nullptr || list->empty()) {
      problem(*value, fmt::format("vary.{} = {}: must be a list of values", key, toml_text(*value)));
    } else if (all.size() * list->size() > most_members) {
      problem(*value, fmt::format("vary: more than {} points", most_members));
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

void SweepReader::read_seeds(SweepPlan& plan) {
  const auto* node = root_.get("seeds");
  if (node == nullptr) return problem(root_, "seeds: missing; it says: how many, or a list of them");
  constexpr std::int64_t most = 1'000'000;
  if (node->is_integer()) {
    const auto count = node->value_or(std::int64_t{0});
    if (count < 1 || count > most) {
      return problem(*node, fmt::format("seeds = {}: must be a whole number from 1 to {}", count, most));
    }
    for (std::int64_t seed = 1; seed <= count; ++seed) plan.seeds.push_back(seed);
    return;
  }
  const auto* list = node->as_array();
  if (list == nullptr || list->empty() || !list->is_homogeneous(toml::node_type::integer)) {
    return problem(*node, fmt::format("seeds = {}: must be how many, or a list of whole numbers", toml_text(*node)));
  }
  std::set<std::int64_t> seen;
  for (const auto& entry : *list) {
    const auto seed = entry.value_or(std::int64_t{-1});
    if (seed < 0) problem(*node, fmt::format("seeds: {}: must be >= 0", seed));
    if (!seen.insert(seed).second) problem(*node, fmt::format("seeds: {}: is there twice", seed));
    plan.seeds.push_back(seed);
  }
}

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

void SweepReader::add_point(SweepPlan& plan, const std::string& name, const std::string& scene,
                            const std::vector<Setting>& common, const std::vector<Setting>& own) {
  SweepPoint point;
  point.name = fit_for_a_folder(name);
  Overrides overrides;
  overrides.seed = plan.seeds.empty() ? 1 : plan.seeds.front();
  for (const auto* list : {&common, &own}) {
    for (const auto& [parameter, origin] : *list) {
      overrides.set.push_back(fmt::format("{} = {}", parameter.key, parameter.text));
      overrides.origins.push_back(origin);
    }
  }
  for (const auto& [parameter, origin] : own) {
    point.parameters.push_back(parameter);
    if (std::find(plan.keys.begin(), plan.keys.end(), parameter.key) == plan.keys.end()) {
      plan.keys.push_back(parameter.key);
    }
  }
  const auto taken = [&](const SweepPoint& other) { return other.name == point.name; };
  if (std::any_of(plan.points.begin(), plan.points.end(), taken)) {
    problems_.push_back(fmt::format("{}: two points have the name \"{}\"", path_, point.name));
  }
  try {
    point.scene = read_scene((fs::path(path_).parent_path() / scene).string(), overrides);
  } catch (const InputError& error) {
    problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
  }
  plan.points.push_back(std::move(point));
}

void SweepReader::read_points(SweepPlan& plan) {
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
      add_point(plan, name.empty() ? fs::path(general_scene).stem().string() : name, general_scene, common,
                combination);
    }
    return;
  }
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto& table = *list->get(k)->as_table();
    const auto prefix = fmt::format("point[{}].", k);
    check_keys(table, prefix, {"name", "scene", "set"});
    const auto name = text(table, prefix, "name", true);
    auto scene = text(table, prefix, "scene", general_scene.empty());
    if (scene.empty()) scene = general_scene;
    if (name.empty() || scene.empty()) continue;
    const auto of_point = settings(table, prefix);
    for (const auto& combination : varied) {
      auto own = of_point;
      own.insert(own.end(), combination.begin(), combination.end());
      add_point(plan, named(name, combination), scene, common, own);
    }
  }
}

void SweepReader::read_claims(SweepPlan& plan) {
  const auto* list = list_of_tables("claim");
  if (list == nullptr) return;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto& table = *list->get(k)->as_table();
    const auto prefix = fmt::format("claim[{}].", k);
    check_keys(table, prefix, {"text", "source", "measure", "point", "difference", "spread", "above", "below"});
    Claim claim;
    claim.text = text(table, prefix, "text", true);
    claim.source = text(table, prefix, "source", false);
    claim.measure = text(table, prefix, "measure", true);
    const auto point = text(table, prefix, "point", false);
    const auto difference = names(table, prefix, "difference");
    const auto spread = names(table, prefix, "spread");
    const int kinds = (point.empty() ? 0 : 1) + (difference.empty() ? 0 : 1) + (spread.empty() ? 0 : 1);
    if (kinds != 1) {
      problem(table, fmt::format("{}point: give one of point, difference and spread", prefix));
      continue;
    }
    if (!point.empty()) {
      claim.points = {point};
    } else if (!difference.empty()) {
      claim.kind = Claim::Kind::difference;
      claim.points = difference;
      if (difference.size() != 2) problem(table, fmt::format("{}difference: must be a list of two names", prefix));
    } else {
      claim.kind = Claim::Kind::spread;
      claim.points = spread;
    }
    const auto above = number(table, prefix, "above");
    const auto below = number(table, prefix, "below");
    claim.above = above.value_or(claim.above);
    claim.below = below.value_or(claim.below);
    if ((!above && !below) || claim.above >= claim.below) {
      problem(table, fmt::format("{}above: give above, below or both, with above < below", prefix));
    }
    for (const auto& name : claim.points) {
      const auto same = [&](const SweepPoint& other) { return other.name == name; };
      if (std::any_of(plan.points.begin(), plan.points.end(), same)) continue;
      std::vector<std::string> known;
      for (const auto& other : plan.points) known.push_back(other.name);
      problem(table, fmt::format("{}points: no point \"{}\"; there are {}", prefix, name, fmt::join(known, ", ")));
    }
    plan.claims.push_back(std::move(claim));
  }
}

SweepPlan SweepReader::read() {
  SweepPlan plan;
  check_keys(root_, "", {"title", "scene", "seeds", "set", "vary", "point", "claim"});
  plan.title = text(root_, "", "title", false);
  read_seeds(plan);
  read_points(plan);
  read_claims(plan);
  if (plan.points.size() * plan.seeds.size() > most_members) {
    problems_.push_back(fmt::format("{}: {} points with {} seeds each: more than {} members", path_, plan.points.size(),
                                    plan.seeds.size(), most_members));
  }
  // The same key is wrong in every point that has it; once is enough.
  std::vector<std::string> once;
  for (const auto& line : problems_) {
    if (std::find(once.begin(), once.end(), line) == once.end()) once.push_back(line);
  }
  if (!once.empty()) throw InputError(once);
  return plan;
}

}  // namespace

SweepPlan read_sweep(const std::string& path) {
  const auto root = parsed_toml(text_of_file(path), path);
  return SweepReader(root, path).read();
}

std::vector<SweepFile> self_contained(const std::string& path) {
  const auto text = text_of_file(path);
  auto root = parsed_toml(text, path);
  std::vector<SweepFile> files(1);
  std::map<std::string, std::string> names;  // of scenes, by path as given
  const auto bring = [&](toml::table& table) {
    const auto given = table.get("scene") != nullptr ? table.get("scene")->value<std::string>() : std::nullopt;
    if (!given) return;
    auto& name = names[*given];
    if (name.empty()) {
      name = fmt::format("scenes/{}-{}", names.size(), fs::path(*given).filename().string());
      files.push_back({name, text_of_file((fs::path(path).parent_path() / *given).string())});
    }
    table.insert_or_assign("scene", name);
  };
  bring(root);
  if (auto* points = root.get_as<toml::array>("point")) {
    for (auto& point : *points) {
      if (auto* table = point.as_table()) bring(*table);
    }
  }
  // The file as its author wrote it, with its comments; only the paths are exchanged.
  std::string exchanged = text;
  for (const auto& [given, name] : names) {
    for (const auto& old_text : {toml_quoted(given), fmt::format("'{}'", given)}) {
      for (auto at = exchanged.find(old_text); at != std::string::npos; at = exchanged.find(old_text, at + 1)) {
        exchanged.replace(at, old_text.size(), toml_quoted(name));
      }
    }
  }
  if (parsed_toml(exchanged, path) != root) {
    throw InputError(fmt::format("{}: scene: a path must be written plainly, and stand for nothing but a scene", path));
  }
  files.front() = {"sweep.toml", exchanged};
  return files;
}

}  // namespace repose
