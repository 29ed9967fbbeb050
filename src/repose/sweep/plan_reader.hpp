// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/toml_file.hpp"
#include "repose/sweep/plan.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace repose {

/// Scenes are read and kept for every point, and members have a folder each.
inline constexpr std::size_t most_points = 10'000;
inline constexpr std::size_t most_members = 1'000'000;

/// A key of the scene with one of its values.
struct Setting {
  Parameter parameter;
  std::string origin;  // file:line
};

/// Reads the tables of a sweep file into a plan and collects what is wrong with them.
class SweepReader {
 public:
  SweepReader(const toml::table& root, std::string path) : root_(root), path_(std::move(path)) {}

  SweepPlan read();

 private:
  void problem(const toml::node& node, const std::string& what);
  std::string place(const toml::node& node) const;  // "file:line"
  void check_keys(const toml::table& table, const std::string& prefix, const std::set<std::string>& known);
  std::string text(const toml::table& table, const std::string& prefix, const std::string& key, bool needed);
  std::optional<double> number(const toml::table& table, const std::string& prefix, const std::string& key);
  std::vector<std::string> names(const toml::table& table, const std::string& prefix, const std::string& key,
                                 std::size_t least = 2);
  std::vector<std::string> points_named(const toml::table& table, const std::string& prefix, const std::string& key,
                                        const SweepPlan& plan);
  const toml::array* list_of_tables(const std::string& key);
  Setting setting(const std::string& key, const toml::node& value) const;
  std::vector<Setting> settings(const toml::table& table, const std::string& prefix);
  bool too_many_points();
  std::vector<std::vector<Setting>> combinations();
  void read_seeds(SweepPlan& plan);
  void read_points(SweepPlan& plan);
  void add_point(SweepPlan& plan, const std::string& name, const std::string& scene, const std::vector<Setting>& common,
                 const std::vector<Setting>& own);
  void read_fits(SweepPlan& plan);
  void read_claims(SweepPlan& plan);
  void check_fit(const toml::table& table, const std::string& prefix, Claim& claim, const SweepPlan& plan);
  void check_measure(const toml::table& table, const std::string& prefix, const Claim& claim, const SweepPlan& plan);
  void read_bounds(const toml::table& table, const std::string& prefix, Claim& claim);

  const toml::table& root_;
  std::string path_;
  std::vector<std::string> problems_;
  std::set<std::string> point_names_;
};

}  // namespace repose
