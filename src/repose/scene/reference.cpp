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
std::string table_of(const std::string& key) {
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

std::string heading(const std::string& table) {
  if (table.empty()) return "## The scene";
  if (table.ends_with("[]")) return fmt::format("## `[[{}]]`", table.substr(0, table.size() - 2));
  return fmt::format("## `[{}]`", table);
}

std::string joined(std::vector<std::string> names, const std::string& last) {
  for (auto& name : names) name = fmt::format("`{}`", name);
  if (names.size() == 1) return names.front();
  const auto end = names.back();
  names.pop_back();
  return fmt::format("{} {} {}", fmt::join(names, ", "), last, end);
}

/// `kind = "row"` (fixed discs ...); `columns` is not 0.
std::string condition_text(const KeyCondition& condition, const std::string& table) {
  const auto name = table_of(condition.key) == table ? below_table(condition.key) : condition.key;
  const auto& first = condition.values.front();
  if (first == "given") return fmt::format("`{}` is given", name);
  if (first.starts_with("not ")) return fmt::format("`{}` is not {}", name, first.substr(4));
  if (first == "> 0") return fmt::format("`{}` > 0", name);
  const bool flag = first == "true" || first == "false";
  auto values = condition.values;
  if (!flag) {
    for (auto& value : values) value = fmt::format("\"{}\"", value);
  }
  values.front() = fmt::format("{} = {}", name, values.front());
  const auto meaning = condition.meaning.empty() ? "" : fmt::format(" ({})", condition.meaning);
  return joined(values, "or") + meaning;
}

/// For which methods and when a key exists; "" if always.
std::string group_of(const KeyText& key) {
  std::string text;
  if (key.methods.size() < method_kinds().all().size()) text = "Method " + joined(key.methods, "and");
  for (std::size_t k = 0; k < key.conditions.size(); ++k) {
    const auto* before = text.empty() ? "Where " : (k == 0 ? ", where " : " and ");
    text += before + condition_text(key.conditions[k], table_of(key.key));
  }
  return text.empty() ? "" : text + ":";
}

std::string row(const KeyText& key) {
  std::string name = below_table(key.key);
  for (auto& c : name) c = c == '|' ? '/' : c;
  auto allowed = key.allowed;
  for (auto bar = allowed.find(" | "); bar != std::string::npos; bar = allowed.find(" | "))
    allowed.replace(bar, 3, ", ");
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", name, key.unit, key.required ? "required" : key.fallback,
                     allowed, key.about);
}

std::string words_text(const KeyText& key) {
  if (key.words.empty()) return "";
  std::string text = fmt::format("\n| `{}` | |\n|---|---|\n", below_table(key.key));
  for (const auto& [name, about] : key.words) text += fmt::format("| `\"{}\"` | {} |\n", name, about);
  return text;
}

/// The groups of keys of one table, in the order in which they are met.
std::string table_text(const std::string& table, const std::vector<KeyText>& keys) {
  std::vector<std::pair<std::string, std::vector<const KeyText*>>> groups;
  for (const auto& key : keys) {
    if (table_of(key.key) != table || repeats_contact(key.key)) continue;
    const auto group = group_of(key);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == group; });
    if (place == groups.end()) place = groups.insert(groups.end(), {group, {}});
    place->second.push_back(&key);
  }
  std::string text = heading(table) + "\n";
  for (const auto& [group, rows] : groups) {
    text += fmt::format("{}\n| key | unit | default | allowed | meaning |\n|---|---|---|---|---|\n",
                        group.empty() ? "" : "\n" + group + "\n");
    for (const auto* key : rows) text += row(*key);
    for (const auto* key : rows) text += words_text(*key);
  }
  if (table == "pair[]") {
    text +=
        "\nBesides, `normal`, `tangential`, `rolling` and `cohesion` as under `[contact]`; what is left out is as "
        "there.\n";
  }
  return text;
}

}  // namespace

std::string scene_reference() {
  const auto keys = all_keys();
  std::vector<std::string> tables;
  for (const auto& key : keys) {
    const auto table = table_of(key.key);
    if (std::find(tables.begin(), tables.end(), table) == tables.end()) tables.push_back(table);
  }
  std::string text;
  for (const auto& table : tables) text += (text.empty() ? "" : "\n") + table_text(table, keys);
  return text;
}

}  // namespace repose
