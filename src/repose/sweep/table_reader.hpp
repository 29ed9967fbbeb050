// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/toml_file.hpp"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace repose {

/// Reads the keys of the tables of a file and collects what is wrong with them, one line each: "file:line: key: what is
/// allowed". A prefix such as "claim[2]." names the table in messages.
class TableReader {
 public:
  explicit TableReader(std::string path) : path_(std::move(path)) {}

 protected:
  void problem(const toml::node& node, const std::string& what);
  std::string place(const toml::node& node) const;  // "file:line"
  void check_keys(const toml::table& table, const std::string& prefix, const std::set<std::string>& known);
  /// "" where there is none, which is a problem if it is needed.
  std::string text(const toml::table& table, const std::string& prefix, const std::string& key, bool needed);
  std::optional<double> number(const toml::table& table, const std::string& prefix, const std::string& key);
  bool flag(const toml::table& table, const std::string& prefix, const std::string& key);  // false where there is none

  std::string path_;
  std::vector<std::string> problems_;
};

}  // namespace repose
