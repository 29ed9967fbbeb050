// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table_reader.hpp"

#include "repose/sweep/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace repose {

void TableReader::problem(const toml::node& node, const std::string& what) {
  problems_.push_back(fmt::format("{}: {}", place(node), what));
}

std::string TableReader::place(const toml::node& node) const {
  const auto& source = node.source();  // claims may stand in a file of their own
  const auto& path = source.path ? *source.path : path_;
  return source.begin.line > 0 ? fmt::format("{}:{}", path, source.begin.line) : path;
}

void TableReader::check_keys(const toml::table& table, const std::string& prefix, const std::set<std::string>& known) {
  for (const auto& [name, child] : table) {
    if (known.contains(std::string(name.str()))) continue;
    problem(child, fmt::format("{}{}: unknown key; known here: {}", prefix, name.str(), fmt::join(known, ", ")));
  }
}

std::string TableReader::text(const toml::table& table, const std::string& prefix, const std::string& key,
                              bool needed) {
  const auto* node = table.get(key);
  if (node == nullptr) {
    if (needed) problem(table, fmt::format("{}{}: missing", prefix, key));
    return "";
  }
  if (!node->is_string()) problem(*node, fmt::format("{}{} = {}: must be text", prefix, key, toml_text(*node)));
  return node->value_or(std::string());
}

std::optional<double> TableReader::number(const toml::table& table, const std::string& prefix, const std::string& key) {
  const auto* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    problem(*node, fmt::format("{}{} = {}: must be a finite number", prefix, key, toml_text(*node)));
    return std::nullopt;
  }
  return value;
}

bool TableReader::flag(const toml::table& table, const std::string& prefix, const std::string& key) {
  const auto* node = table.get(key);
  if (node == nullptr) return false;
  if (!node->is_boolean()) problem(*node, fmt::format("{}{}: must be true or false", prefix, key));
  return node->value_or(false);
}

}  // namespace repose
