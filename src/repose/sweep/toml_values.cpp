// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/toml_values.hpp"

#include "repose/scene/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace repose {

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

std::vector<std::pair<std::string, const toml::node*>> values_below(const toml::table& table,
                                                                    const std::string& prefix) {
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

}  // namespace repose
