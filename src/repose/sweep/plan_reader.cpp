// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/plan_reader.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/problems.hpp"
#include "repose/sweep/form.hpp"
#include "repose/sweep/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace repose {

std::vector<std::string> SweepReader::names(const toml::table& table, const std::string& prefix, const std::string& key,
                                            std::size_t least) {
  std::vector<std::string> found;
  const auto* node = table.get(key);
  if (node == nullptr) return found;
  const auto* list = node->as_array();
  if (list == nullptr || !list->is_homogeneous(toml::node_type::string) || list->size() < least) {
    problem(*node, fmt::format("{}{}: must be a list of at least {} of points", prefix, key,
                               least == 1 ? "one name" : "two names"));
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

void SweepReader::read_seeds(SweepPlan& plan) {
  const auto* node = root_.get("seeds");
  if (node == nullptr) return problem(root_, "seeds: missing: give their number, or a list of seeds");
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
    return problem(
        *node, fmt::format("seeds = {}: must be the number of seeds, or a list of whole numbers", toml_text(*node)));
  }
  std::set<std::int64_t> seen;
  for (const auto& entry : *list) {
    const auto seed = entry.value_or(std::int64_t{-1});
    constexpr std::int64_t largest = std::int64_t{1} << 53;
    if (seed < 0 || seed > largest) problem(*node, fmt::format("seeds: {}: must be from 0 to {}", seed, largest));
    if (!seen.insert(seed).second) problem(*node, fmt::format("seeds: {}: is listed twice", seed));
    plan.seeds.push_back(seed);
  }
}

SweepPlan SweepReader::read() {
  SweepPlan plan;
  check_keys(root_, "", {"title", "scene", "seeds", "set", "vary", "point", "fit", "claim"});
  plan.title = text(root_, "", "title", false);
  if (const auto what = title_problem(plan.title); !what.empty()) problem(*root_.get("title"), "title" + what);
  read_seeds(plan);
  read_points(plan);
  if (!plan.points.empty()) {
    read_fits(plan);
    read_claims(plan);
  }
  if (plan.points.empty() && problems_.empty()) problems_.push_back(fmt::format("{}: has no points", path_));
  if (plan.points.size() * plan.seeds.size() > most_members) {
    problems_.push_back(fmt::format("{}: {} points with {} seeds each: more than {} members", path_, plan.points.size(),
                                    plan.seeds.size(), most_members));
  }
  // A key that is wrong in several points is reported once.
  std::vector<std::string> once;
  std::set<std::string> known;
  for (const auto& line : problems_) {
    if (known.insert(line).second) once.push_back(line);
  }
  if (!once.empty()) throw InputError(once);
  return plan;
}

SweepPlan read_sweep(const std::string& path, SweepForm form) {
  auto root = parsed_toml(text_of_file(path), path);
  take_form(root, form, path);
  return SweepReader(root, path).read();
}

}  // namespace repose
