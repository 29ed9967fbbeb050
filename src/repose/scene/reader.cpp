// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace repose {

namespace {

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

/// A value as in a message, on one line. Not through toml++'s printer of lists and tables, whose choice of a layout
/// takes every number for one of magnitude above 1 (and is undefined for the others).
std::string value_text(const toml::node& node) {
  if (const auto* list = node.as_array()) {
    std::vector<std::string> entries;
    for (const auto& entry : *list) entries.push_back(value_text(entry));
    return entries.empty() ? "[]" : fmt::format("[ {} ]", fmt::join(entries, ", "));
  }
  if (const auto* table = node.as_table()) {
    std::vector<std::string> entries;
    for (const auto& [name, child] : *table) entries.push_back(fmt::format("{} = {}", name.str(), value_text(child)));
    return entries.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(entries, ", "));
  }
  if (const auto number = node.is_floating_point() ? node.value<double>() : std::nullopt) {
    return fmt::format("{}", *number);
  }
  if (const auto text = node.value<std::string>(); node.is_string()) return fmt::format("\"{}\"", *text);
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

/// A number of either kind, NaN if it is none. Not value<double>(), which is nothing for a whole number that a double
/// has to round.
double number_in(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  return node.is_floating_point() ? node.as_floating_point()->get() : required;
}

/// True for what a dotted key is made of; "" and "a.b" in quotation marks are names in TOML, but none of ours.
bool is_step(std::string_view name) { return !name.empty() && name.find_first_of(".[") == std::string_view::npos; }

/// Splits "a.b[2].c" into "a", "b", "[2]", "c".
std::vector<std::string> steps_of(const std::string& key) {
  std::vector<std::string> steps(1);
  for (const char c : key) {
    if (c == '.') {
      steps.emplace_back();
    } else {
      if (c == '[') steps.emplace_back();
      steps.back() += c;
    }
  }
  return steps;
}

std::string parent_of(const std::string& key) {
  const auto dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

}  // namespace

const toml::node* Reader::find(const std::string& key) const {
  const toml::node* node = &root_;
  for (const auto& step : steps_of(key)) {
    if (node == nullptr) return nullptr;
    if (step.front() == '[') {
      const auto* list = node->as_array();
      node = list != nullptr ? list->get(static_cast<std::size_t>(std::stoul(step.substr(1)))) : nullptr;
    } else {
      const auto* table = node->as_table();
      node = table != nullptr ? table->get(step) : nullptr;
    }
  }
  return node;
}

std::string Reader::place(const std::string& key) const {
  for (std::string at = key; !at.empty(); at = parent_of(at)) {
    if (const auto origin = origin_.find(at); origin != origin_.end()) return origin->second;
    const auto* node = find(at);
    if (node != nullptr && node->source().begin.line > 0) {
      return fmt::format("{}:{}", name_, node->source().begin.line);
    }
  }
  return name_;
}

void Reader::problem(const std::string& key, const std::string& what) {
  wrong_.insert(key);
  problems_.push_back(fmt::format("{}: {}{}", place(key), key, what));
}

void Reader::missing(const std::string& key, std::string_view about) {
  problem(key, fmt::format(": missing; it says: {}", about));
}

void Reader::wrong_type(const std::string& key, const toml::node& node, std::string_view wanted) {
  problem(key, fmt::format(" = {}: must be {}, is {}", value_text(node), wanted, type_name(node)));
}

bool Reader::check_bounds(const std::string& key, const std::string& shown, double value, const Bounds& bounds,
                          std::string_view unit) {
  const bool fine = std::isfinite(value) || (std::isinf(value) && bounds.infinite_allowed);
  if (fine && bounds.holds(value)) return true;
  const std::string allowed = fine ? bounds.text() : "must be a finite number";
  problem(key, fmt::format("{}: {}{}", shown, allowed, unit.empty() ? "" : fmt::format(" [{}]", unit)));
  return false;
}

void Reader::number(const std::string& key, double& value, double fallback, const Bounds& bounds, std::string_view unit,
                    std::string_view about) {
  asked_.insert(key);
  const auto* node = find(key);
  // Something sound to go on with, so that one problem does not bring about others.
  value = std::isnan(fallback) ? 1.0 : fallback;
  if (node == nullptr) {
    if (std::isnan(fallback)) return missing(key, about);
    // Defaults that follow from other keys can overflow.
    check_bounds(key, fmt::format(": missing, and its default, {}, will not do", fallback), fallback, bounds, unit);
    return;
  }
  if (!node->is_number()) return wrong_type(key, *node, "a number");
  const double read = number_in(*node);
  if (check_bounds(key, fmt::format(" = {}", value_text(*node)), read, bounds, unit)) value = read;
}

void Reader::optional_number(const std::string& key, std::optional<double>& value, std::string_view none,
                             const Bounds& bounds, std::string_view unit, std::string_view /*about*/) {
  asked_.insert(key);
  value.reset();
  const auto* node = find(key);
  if (node == nullptr) return;
  if (!none.empty() && node->value<std::string>() == std::string(none)) return;
  if (!node->is_number()) {
    return wrong_type(key, *node, none.empty() ? "a number" : fmt::format("a number or \"{}\"", none));
  }
  value = number_in(*node);
  check_bounds(key, fmt::format(" = {}", value_text(*node)), *value, bounds, unit);
}

void Reader::integer(const std::string& key, std::int64_t& value, std::optional<std::int64_t> fallback,
                     std::int64_t low, std::string_view about) {
  asked_.insert(key);
  value = fallback.value_or(low);
  const auto* node = find(key);
  if (node == nullptr) {
    if (!fallback) missing(key, about);
    return;
  }
  if (!node->is_integer()) return wrong_type(key, *node, "a whole number");
  const auto read = *node->value<std::int64_t>();
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if (read < low || read > most) {
    return problem(key, fmt::format(" = {}: must be a whole number from {} to {}", read, low, most));
  }
  value = read;
}

void Reader::flag(const std::string& key, bool& value, bool fallback, std::string_view /*about*/) {
  asked_.insert(key);
  value = fallback;
  const auto* node = find(key);
  if (node == nullptr) return;
  if (!node->is_boolean()) return wrong_type(key, *node, "true or false");
  value = *node->value<bool>();
}

void Reader::text(const std::string& key, std::string& value, std::string_view fallback, std::string_view /*about*/) {
  asked_.insert(key);
  value = fallback;
  const auto* node = find(key);
  if (node == nullptr) return;
  if (!node->is_string()) return wrong_type(key, *node, "text");
  value = *node->value<std::string>();
}

void Reader::choice(const std::string& key, std::string& value, std::string_view fallback,
                    const std::vector<std::string>& words, std::string_view about) {
  asked_.insert(key);
  value = fallback.empty() ? words.front() : std::string(fallback);
  const auto* node = find(key);
  if (node == nullptr) {
    if (fallback.empty()) missing(key, about);
    return;
  }
  const std::string allowed = fmt::format("one of \"{}\"", fmt::join(words, "\", \""));
  if (!node->is_string()) return wrong_type(key, *node, allowed);
  const auto word = *node->value<std::string>();
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    return problem(key, fmt::format(" = \"{}\": must be {}", word, allowed));
  }
  value = word;
}

void Reader::numbers(const std::string& key, std::vector<double>& values, std::string_view /*unit*/,
                     std::string_view about) {
  asked_.insert(key);
  values.clear();
  const auto* node = find(key);
  if (node == nullptr) return missing(key, about);
  const auto* list = node->as_array();
  if (list == nullptr || list->empty()) return wrong_type(key, *node, "a list of numbers");
  for (const auto& entry : *list) {
    const double number = number_in(entry);
    if (!std::isfinite(number)) {
      return problem(key, fmt::format(" = {}: must be a list of finite numbers", value_text(*node)));
    }
    values.push_back(number);
  }
}

void Reader::one_of(const std::string& group, const std::vector<Parameters::Way>& ways, std::size_t& way, double& value,
                    double fallback) {
  way = 0;
  std::size_t found = ways.size();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const auto key = group + std::string(ways[k].name);
    asked_.insert(key);
    if (!given(key)) continue;
    if (found < ways.size()) {
      problem(key, fmt::format(": only one of {} and {} may be given", ways[found].name, ways[k].name));
      continue;
    }
    found = k;
  }
  if (found < ways.size()) way = found;
  number(group + std::string(ways[way].name), value, way == 0 ? fallback : required, ways[way].bounds, ways[way].unit,
         ways[way].about);
}

void Reader::vector(const std::string& key, std::array<double, 2>& value, std::optional<std::array<double, 2>> fallback,
                    std::string_view /*unit*/, std::string_view about) {
  asked_.insert(key);
  value = fallback.value_or(std::array<double, 2>{});
  const auto* node = find(key);
  if (node == nullptr) {
    if (!fallback) missing(key, about);
    return;
  }
  const auto* list = node->as_array();
  if (list == nullptr) return wrong_type(key, *node, "a list of two numbers");
  if (list->size() != 2) {
    return problem(key, fmt::format(" = {}: must be a list of two numbers, has {}", value_text(*node), list->size()));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const double component = number_in(*list->get(k));
    if (!std::isfinite(component)) {
      return problem(key, fmt::format(" = {}: must be a list of two finite numbers", value_text(*node)));
    }
    value[k] = component;
  }
}

void Reader::tables(const std::string& key, const std::function<std::size_t(std::size_t)>& resize,
                    const std::function<void(const std::string& prefix, std::size_t index)>& each) {
  asked_.insert(key);
  const auto* node = find(key);
  if (node == nullptr) return;
  const auto* list = node->as_array();
  if (list == nullptr || (!list->empty() && !list->is_homogeneous(toml::node_type::table))) {
    return wrong_type(key, *node, fmt::format("a list of tables, each headed [[{}]]", key));
  }
  const auto count = resize(list->size());
  for (std::size_t k = 0; k < count; ++k) each(fmt::format("{}[{}].", key, k), k);
}

void Reader::report_unknown_keys() { unknown_in(root_, ""); }

/// True if a key that begins so was asked for.
bool Reader::any_asked(const std::string& beginning) const {
  const auto first = asked_.lower_bound(beginning);
  return first != asked_.end() && first->starts_with(beginning);
}

void Reader::unknown_in(const toml::node& node, const std::string& key) {
  if (asked_.contains(key) && !node.is_array_of_tables()) return;
  const bool known_parent = key.empty() || any_asked(key + ".") || any_asked(key + "[");
  if (const auto* table = node.as_table(); table != nullptr && known_parent) {
    for (const auto& [name, child] : *table) {
      if (is_step(name.str())) {
        unknown_in(child, key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()));
      } else {
        const auto line = child.source().begin.line;
        problems_.push_back(fmt::format(
            "{}: {}{}\"{}\": unknown key; keys are words, with dots outside quotation marks",
            line > 0 ? fmt::format("{}:{}", name_, line) : place(key), key, key.empty() ? "" : ".", name.str()));
      }
    }
    return;
  }
  if (const auto* list = node.as_array(); list != nullptr && asked_.contains(key)) {
    for (std::size_t k = 0; k < list->size(); ++k) unknown_in(*list->get(k), fmt::format("{}[{}]", key, k));
    return;
  }
  if (known_parent) return wrong_type(key, node, "a table");
  std::set<std::string> siblings;
  const auto parent = parent_of(key).empty() ? "" : parent_of(key) + ".";
  for (auto known = asked_.lower_bound(parent); known != asked_.end() && known->starts_with(parent); ++known) {
    const auto rest = known->substr(parent.size());
    siblings.insert(rest.substr(0, rest.find_first_of(".[")));
  }
  problem(key,
          siblings.empty() ? ": unknown key" : fmt::format(": unknown key; known here: {}", fmt::join(siblings, ", ")));
}

}  // namespace repose
