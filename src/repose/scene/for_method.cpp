// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/for_method.hpp"

#include "repose/scene/method_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <utility>

namespace repose {

namespace {

/// Moves, because a copy of a node of toml++ forgets its line.
void merge(toml::table& from, toml::table& into) {
  for (auto&& [key, node] : from) {
    auto* there = into.get(key);
    if (node.is_table() && there != nullptr && there->is_table()) {
      merge(*node.as_table(), *there->as_table());
    } else {
      into.insert_or_assign(key, std::move(node));
    }
  }
}

std::string at_line(const std::string& name, const toml::node& node) {
  return name.empty() ? "" : fmt::format("{}:{}: ", name, node.source().begin.line);
}

}  // namespace

void apply_keys_for_method(toml::table& root, const std::string& name, std::vector<std::string>& problems) {
  const auto* given = root.get("for");
  if (given == nullptr) return;
  if (!given->is_table()) {
    problems.push_back(at_line(name, *given) + "for: must hold tables of keys, as in [for.soft]");
    root.erase("for");
    return;
  }
  auto by_method = std::move(*root.get("for")->as_table());
  root.erase("for");
  const auto method = root.at_path("method.kind").value<std::string>().value_or(std::string(usual_method));
  std::vector<std::string_view> known;
  for (const auto& kind : method_kinds().all()) known.push_back(kind->name());
  for (auto&& [kind, keys] : by_method) {
    const bool is_method = static_cast<bool>(method_kinds().make(kind.str()));
    if (!is_method) {
      problems.push_back(at_line(name, keys) +
                         fmt::format("for.{}: no method; methods are {}", kind.str(), fmt::join(known, ", ")));
    } else if (!keys.is_table()) {
      problems.push_back(at_line(name, keys) + fmt::format("for.{}: must be a table of keys", kind.str()));
    } else if (kind.str() == method) {
      merge(*keys.as_table(), root);
    }
  }
}

}  // namespace repose
