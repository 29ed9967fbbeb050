// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string value_text(const toml::node& node) {
  if (const auto number = node.is_floating_point() ? node.value<double>() : std::nullopt) {
    return fmt::format("{}", *number);
  }
  if (const auto text = node.value<std::string>(); node.is_string()) return fmt::format("\"{}\"", *text);
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  std::string line;
  for (const char c : out.str()) {  // a long list is printed over several lines
    const bool space = c == ' ' || c == '\n' || c == '\t';
    if (!space || (!line.empty() && line.back() != ' ')) line += space ? ' ' : c;
  }
  return line;
}

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

bool starts_with_step(const std::string& key, const std::string& prefix) {
  return key.size() > prefix.size() && key.starts_with(prefix) &&
         (prefix.empty() || key[prefix.size()] == '.' || key[prefix.size()] == '[');
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

void Reader::check_bounds(const std::string& key, const toml::node& node, double value, const Bounds& bounds,
                          std::string_view unit) {
  if (std::isfinite(value) && bounds.holds(value)) return;
  const std::string allowed = std::isfinite(value) ? bounds.text() : "must be a finite number";
  problem(key, fmt::format(" = {}: {}{}", value_text(node), allowed, unit.empty() ? "" : fmt::format(" [{}]", unit)));
}

void Reader::number(const std::string& key, double& value, double fallback, const Bounds& bounds, std::string_view unit,
                    std::string_view about) {
  asked_.insert(key);
  const auto* node = find(key);
  // Something sound to go on with, so that one problem does not bring about others.
  value = std::isnan(fallback) ? 1.0 : fallback;
  if (node == nullptr) {
    if (std::isnan(fallback)) missing(key, about);
    return;
  }
  if (!node->is_number()) return wrong_type(key, *node, "a number");
  value = *node->value<double>();
  check_bounds(key, *node, value, bounds, unit);
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
  value = *node->value<double>();
  check_bounds(key, *node, *value, bounds, unit);
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
    const auto component = list->get(k)->is_number() ? list->get(k)->value<double>() : std::nullopt;
    if (!component || !std::isfinite(*component)) {
      return problem(key, fmt::format(" = {}: must be a list of two finite numbers", value_text(*node)));
    }
    value[k] = *component;
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

void Reader::unknown_in(const toml::node& node, const std::string& key) {
  if (asked_.contains(key) && !node.is_array_of_tables()) return;
  const bool known_parent =
      key.empty() || std::any_of(asked_.begin(), asked_.end(), [&](const auto& a) { return starts_with_step(a, key); });
  if (const auto* table = node.as_table(); table != nullptr && known_parent) {
    for (const auto& [name, child] : *table) {
      unknown_in(child, key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()));
    }
    return;
  }
  if (const auto* list = node.as_array(); list != nullptr && asked_.contains(key)) {
    for (std::size_t k = 0; k < list->size(); ++k) unknown_in(*list->get(k), fmt::format("{}[{}]", key, k));
    return;
  }
  if (known_parent) return wrong_type(key, node, "a table");
  std::set<std::string> siblings;
  for (const auto& known : asked_) {
    const auto parent = parent_of(key);
    if (!starts_with_step(known, parent)) continue;
    const auto rest = known.substr(parent.empty() ? 0 : parent.size() + 1);
    siblings.insert(rest.substr(0, rest.find_first_of(".[")));
  }
  problem(key,
          siblings.empty() ? ": unknown key" : fmt::format(": unknown key; known here: {}", fmt::join(siblings, ", ")));
}

}  // namespace repose
