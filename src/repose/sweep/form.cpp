// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/form.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <vector>

namespace repose {

namespace {

/// Puts the values of `from` into `to`, table into table; an inline table is a value. A list keeps its place in the
/// file, by which the keys of [vary] are ordered.
void merge(const toml::table& from, toml::table& to) {
  for (const auto& [key, value] : from) {
    const auto* table = value.as_table();
    auto* old_table = to.get_as<toml::table>(key.str());
    if (table != nullptr && old_table != nullptr && !table->is_inline() && !old_table->is_inline()) {
      merge(*table, *old_table);
    } else if (auto* old_list = to.get_as<toml::array>(key.str()); old_list != nullptr && value.is_array()) {
      old_list->clear();
      for (const auto& entry : *value.as_array()) old_list->push_back(entry);
    } else {
      to.insert_or_assign(key.str(), value);
    }
  }
}

std::vector<std::string> problems_of(const toml::node& quick, const std::string& path) {
  const auto place = [&](const toml::node& node) { return fmt::format("{}:{}", path, node.source().begin.line); };
  const auto* table = quick.as_table();
  if (table == nullptr) return {fmt::format("{}: quick: must be a table", place(quick))};
  std::vector<std::string> problems;
  for (const auto& [key, value] : *table) {
    const auto name = std::string(key.str());
    if (name != "seeds" && name != "set" && name != "vary") {
      problems.push_back(fmt::format("{}: quick.{}: unknown key; known here: seeds, set, vary", place(value), name));
    } else if (name != "seeds" && !value.is_table()) {
      problems.push_back(fmt::format("{}: quick.{}: must be a table", place(value), name));
    }
  }
  return problems;
}

}  // namespace

void take_form(toml::table& root, SweepForm form, const std::string& path) {
  if (const auto* named = root.get("form")) {
    if (named->value_or(std::string()) != "quick") {
      throw InputError(fmt::format("{}:{}: form: must be \"quick\"", path, named->source().begin.line));
    }
    form = SweepForm::quick;
    root.erase("form");
  }
  const auto* quick = root.get("quick");
  if (quick == nullptr) return;
  if (const auto problems = problems_of(*quick, path); !problems.empty()) throw InputError(problems);
  // A copy: toml++ may move what stands in a table when another key is inserted.
  const toml::table wanted = *quick->as_table();
  root.erase("quick");
  if (form == SweepForm::full) return;
  for (const auto* key : {"set", "vary"}) {
    if (wanted.contains(key) && !root.contains(key)) root.insert(key, toml::table{});
  }
  merge(wanted, root);
}

}  // namespace repose
