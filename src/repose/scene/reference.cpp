// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/reference.hpp"

#include "repose/scene/method_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace repose {

namespace {

/// "contact" of "contact.normal.law", "wall[]" of "wall[].from", "" of "seed".
std::string toml_table_of(const std::string& key) {
  const auto dot = key.find('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string below_table(const std::string& key) {
  const auto dot = key.find('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

/// A pair has the laws of [contact], whose keys are listed once.
bool repeats_contact(const std::string& key) {
  return key.starts_with("pair[].") && below_table(key).find('.') != std::string::npos;
}

/// As a scene writes it: "[contact]", "[[wall]]".
std::string title_of(const std::string& table) {
  if (table.empty()) return "outside tables";
  return table.ends_with("[]") ? fmt::format("[[{}]]", table.substr(0, table.size() - 2)) : fmt::format("[{}]", table);
}

std::string joined(std::vector<std::string> names, const std::string& last) {
  for (auto& name : names) name = fmt::format("`{}`", name);
  if (names.size() == 1) return names.front();
  const auto end = names.back();
  names.pop_back();
  return fmt::format("{} {} {}", fmt::join(names, ", "), last, end);
}

/// `kind = "row"`, or `columns` is not 0.
std::string condition_text(const KeyCondition& condition, const std::string& table) {
  const auto name = toml_table_of(condition.key) == table ? below_table(condition.key) : condition.key;
  const auto& first = condition.values.front();
  if (first == "given") return fmt::format("`{}` given", name);
  if (first.starts_with("not ")) return fmt::format("`{}` not {}", name, first.substr(4));
  if (first == "> 0") return fmt::format("`{}` > 0", name);
  auto values = condition.values;
  const bool number = first.find_first_not_of("0123456789") == std::string::npos;
  if (first != "true" && first != "false" && !number) {
    for (auto& value : values) value = fmt::format("\"{}\"", value);
  }
  values.front() = fmt::format("{} = {}", name, values.front());
  return joined(values, "or");
}

/// The methods of every key of a table; empty if they differ.
std::vector<std::string> methods_of_all(const std::vector<const KeyText*>& keys) {
  const auto& methods = keys.front()->methods;
  const auto same = [&](const auto* key) { return key->methods == methods; };
  return std::all_of(keys.begin(), keys.end(), same) ? methods : std::vector<std::string>();
}

bool has_every_method(const std::vector<std::string>& methods) { return methods.size() == method_kinds().all().size(); }

/// Where a key exists: the methods, if the table does not tell them, and the conditions.
std::string where(const KeyText& key, bool with_methods) {
  std::string text;
  if (with_methods && !has_every_method(key.methods)) text = joined(key.methods, "and");
  for (const auto& condition : key.conditions) {
    text += (text.empty() ? "" : ", ") + condition_text(condition, toml_table_of(key.key));
  }
  return text;
}

std::string row(const KeyText& key, bool with_methods) {
  auto allowed = key.allowed;
  for (auto bar = allowed.find(" | "); bar != std::string::npos; bar = allowed.find(" | "))
    allowed.replace(bar, 3, ", ");
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", below_table(key.key), where(key, with_methods), key.unit,
                     key.required ? "required" : key.fallback, allowed, key.about);
}

/// What the words of a choice mean, of all entries of its key.
std::string words_text(const std::string& name, const std::vector<const KeyText*>& keys) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto* key : keys) {
    if (key->key != name) continue;
    for (const auto& word : key->words) {
      if (std::find(all.begin(), all.end(), word) == all.end()) all.push_back(word);
    }
  }
  if (all.empty()) return "";
  std::string text = fmt::format("\n| `{}` | |\n|---|---|\n", below_table(name));
  for (const auto& [word, about] : all) text += fmt::format("| `\"{}\"` | {} |\n", word, about);
  return text;
}

std::string table_text(const std::string& table, const std::vector<KeyText>& all) {
  std::vector<const KeyText*> keys;
  std::vector<std::string> names;
  for (const auto& key : all) {
    if (toml_table_of(key.key) != table || repeats_contact(key.key)) continue;
    keys.push_back(&key);
    if (std::find(names.begin(), names.end(), key.key) == names.end()) names.push_back(key.key);
  }
  const auto methods = methods_of_all(keys);
  std::string text = fmt::format("<!-- table: {} -->\n", title_of(table));
  if (!methods.empty() && !has_every_method(methods)) text += fmt::format("For {} alone.\n\n", joined(methods, "and"));
  text += "| key | where | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
  for (const auto& name : names) {
    for (const auto* key : keys) {
      if (key->key == name) text += row(*key, methods.empty());
    }
  }
  for (const auto& name : names) text += words_text(name, keys);
  if (table == "pair[]") {
    text +=
        "\nBesides, `normal`, `tangential`, `rolling` and `cohesion` as under `[contact]`; what is left out is as "
        "there.\n";
  }
  return text + "<!-- end -->\n";
}

}  // namespace

std::string scene_reference() {
  const auto keys = all_keys();
  std::vector<std::string> tables;
  for (const auto& key : keys) {
    const auto table = toml_table_of(key.key);
    if (std::find(tables.begin(), tables.end(), table) == tables.end()) tables.push_back(table);
  }
  std::string text;
  for (const auto& table : tables) text += (text.empty() ? "" : "\n") + table_text(table, keys);
  return text;
}

}  // namespace repose
