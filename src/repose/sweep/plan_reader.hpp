// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/plan.hpp"
#include "repose/sweep/table_reader.hpp"

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

/// A point as the file describes it.
struct PointText {
  std::string name;              // with what varies
  std::string scene;             // relative to the sweep file
  std::string starts_from = {};  // the name of a point; "": none
  std::vector<Setting> common;
  std::vector<Setting> own = {};
  std::vector<Setting> varied = {};
};

/// Reads the tables of a sweep file into a plan and collects what is wrong with them.
class SweepReader : TableReader {
 public:
  SweepReader(const toml::table& root, std::string path) : TableReader(std::move(path)), root_(root) {}

  SweepPlan read();

 private:
  std::vector<std::string> names(const toml::table& table, const std::string& prefix, const std::string& key,
                                 std::size_t least = 2);
  std::vector<std::string> points_named(const toml::table& table, const std::string& prefix, const std::string& key,
                                        const SweepPlan& plan);
  const toml::array* list_of_tables(const std::string& key);
  Setting setting(const std::string& key, const toml::node& value) const;
  bool check_setting(const std::string& key, const std::string& prefix, const toml::node& value);
  std::vector<Setting> settings(const toml::table& table, const std::string& prefix);
  bool too_many_points();
  std::vector<std::vector<Setting>> combinations();
  void read_seeds(SweepPlan& plan);
  void read_points(SweepPlan& plan);
  void add_point(SweepPlan& plan, const PointText& wanted);
  void check_name(const std::string& name);
  std::string starts_from(const toml::table& table, const std::string& prefix, std::size_t points_before);
  void read_fits(SweepPlan& plan);
  void read_claims(SweepPlan& plan);
  void check_fit(const toml::table& table, const std::string& prefix, Claim& claim, const SweepPlan& plan);
  void check_measure(const toml::table& table, const std::string& prefix, const Claim& claim, const SweepPlan& plan);
  void read_bounds(const toml::table& table, const std::string& prefix, Claim& claim);

  const toml::table& root_;
  std::set<std::string> point_names_;
};

}  // namespace repose
