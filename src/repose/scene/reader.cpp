// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/reader.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/quantity.hpp"

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

std::string_view last_step(std::string_view key) { return key.substr(key.rfind('.') + 1); }

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

/// "scene.toml:12"; "" where the scene has no file.
std::string Reader::at_line(const toml::node& node) const {
  const auto line = node.source().begin.line;
  return name_.empty() || line == 0 ? name_ : fmt::format("{}:{}", name_, line);
}

std::string Reader::place(const std::string& key) const {
  for (std::string at = key; !at.empty(); at = parent_of(at)) {
    if (const auto origin = origin_.find(at); origin != origin_.end()) return origin->second;
    const auto* node = find(at);
    if (node != nullptr && node->source().begin.line > 0) return at_line(*node);
  }
  return name_;
}

bool Reader::from_command_line(const std::string& key) const {
  const auto origin = origin_.find(key);
  return origin != origin_.end() && origin->second.starts_with("--set");
}

void Reader::problem(const std::string& key, const std::string& what) {
  wrong_.insert(key);
  const auto where = place(key);
  problems_.push_back(fmt::format("{}{}{}{}", where, where.empty() ? "" : ": ", key, what));
}

void Reader::missing(const std::string& key, std::string_view about) {
  problem(key, fmt::format(": missing: {}", about));
}

void Reader::wrong_type(const std::string& key, const toml::node& node, std::string_view wanted) {
  problem(key, fmt::format(" = {}: must be {}, is {}", value_text(node), wanted, type_name(node)));
}

bool Reader::check_bounds(const Item& item, const std::string& shown, double value, const Bounds& bounds) {
  if (bounds.hold(value)) return true;
  const bool finite = std::isfinite(value) || (std::isinf(value) && bounds.infinite_allowed);
  const auto unit = item.unit.empty() ? "" : fmt::format(" [{}]", item.unit);
  problem(std::string(item.name), fmt::format("{}: {}{}", shown, finite ? bounds.text() : any.text(), unit));
  return false;
}

void Reader::show(const Item& item) {
  const std::string key(item.name);
  asked_.insert(key);
  const auto* node = find(key);
  // Without a default something sound to continue with, so that one problem does not bring about others.
  const bool has_default = take_default(item);
  if (node != nullptr) {
    std::visit([&](const auto& kind) { read(item, *node, kind); }, item.value);
  } else if (!has_default) {
    missing(key, item.about);
  } else if (const auto* number = std::get_if<Number>(&item.value)) {
    // Defaults that follow from other keys can overflow.
    const auto shown = fmt::format(": missing, and its default is {}", number->value);
    check_bounds(item, shown, number->value, number->bounds);
  }
}

/// A number, or a quantity with a unit of an SI scene; NaN for what is neither. Nothing for a quantity that is wrong,
/// which is then a problem.
std::optional<double> Reader::number_of(const Item& item, const toml::node& node) {
  const auto text = node.value<std::string>();
  if (!node.is_string() || !begins_as_number(*text)) return number_in(node);
  const auto wrong = [&](std::string_view what) {
    problem(std::string(item.name), fmt::format(" = {}: {}", value_text(node), what));
    return std::nullopt;
  };
  const auto* units = root_.get("units");
  if (units == nullptr || units->value_or(std::string()) != "SI") {
    return wrong("a quantity with a unit needs units = \"SI\"");
  }
  try {
    return number_of_quantity(*text, item.unit);
  } catch (const InputError& error) {
    return wrong(error.what());
  }
}

void Reader::read(const Item& item, const toml::node& node, const Number& number) {
  const auto found = number_of(item, node);
  if (!found) return;
  const double value = *found;
  if (std::isnan(value) && !node.is_number()) return wrong_type(std::string(item.name), node, "a number");
  if (check_bounds(item, fmt::format(" = {}", value_text(node)), value, number.bounds)) number.value = value;
}

void Reader::read(const Item& item, const toml::node& node, const OptionalNumber& number) {
  const std::string word(number.without.word);
  if (!word.empty() && node.value<std::string>() == word) return;
  const auto found = number_of(item, node);
  if (!found) return;
  if (std::isnan(*found) && !node.is_number()) {
    return wrong_type(std::string(item.name), node,
                      word.empty() ? "a number" : fmt::format("a number or \"{}\"", word));
  }
  number.value = *found;
  check_bounds(item, fmt::format(" = {}", value_text(node)), *number.value, number.bounds);
}

void Reader::read(const Item& item, const toml::node& node, const Whole& whole) {
  const std::string key(item.name);
  if (!node.is_integer()) return wrong_type(key, node, "a whole number");
  const auto value = *node.value<std::int64_t>();
  const auto most = std::min(whole.bounds.high, std::int64_t{1} << 53);
  if (value < whole.bounds.low || value > most) {
    return problem(key, fmt::format(" = {}: must be a whole number from {} to {}", value, whole.bounds.low, most));
  }
  whole.value = value;
}

void Reader::read(const Item& item, const toml::node& node, const Flag& flag) {
  if (!node.is_boolean()) return wrong_type(std::string(item.name), node, "true or false");
  flag.value = *node.value<bool>();
}

void Reader::read(const Item& item, const toml::node& node, const Text& text) {
  if (!node.is_string()) return wrong_type(std::string(item.name), node, "text");
  text.value = *node.value<std::string>();
}

void Reader::read(const Item& item, const toml::node& node, const Choice& choice) {
  const std::string key(item.name);
  std::vector<std::string_view> names;
  for (const auto& word : choice.words) names.push_back(word.name);
  const std::string allowed = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
  if (!node.is_string()) return wrong_type(key, node, allowed);
  const auto word = *node.value<std::string>();
  if (std::find(names.begin(), names.end(), word) == names.end()) {
    return problem(key, fmt::format(" = \"{}\": must be {}", word, allowed));
  }
  choice.value = word;
}

void Reader::read(const Item& item, const toml::node& node, const Vector& vector) {
  const std::string key(item.name);
  const auto count = vector.value.size();
  const auto* words = count == 2 ? "two" : "three";
  const auto* list = node.as_array();
  if (list == nullptr) return wrong_type(key, node, fmt::format("a list of {} numbers", words));
  if (list->size() != count) {
    return problem(key,
                   fmt::format(" = {}: must be a list of {} numbers, has {}", value_text(node), words, list->size()));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto found = number_of(item, *list->get(k));
    if (!found) return;
    const double component = *found;
    if (!std::isfinite(component)) {
      return problem(key, fmt::format(" = {}: must be a list of {} finite numbers", value_text(node), words));
    }
    vector.value[k] = component;
  }
}

void Reader::read(const Item& item, const toml::node& node, const List& list) {
  const std::string key(item.name);
  const auto* entries = node.as_array();
  if (entries == nullptr || (entries->empty() && !list.may_be_empty)) {
    return wrong_type(key, node, "a list of numbers");
  }
  for (const auto& entry : *entries) {
    const auto found = number_of(item, entry);
    if (!found) return;
    const double number = *found;
    if (!std::isfinite(number)) {
      return problem(key, fmt::format(" = {}: must be a list of finite numbers", value_text(node)));
    }
    list.values.push_back(number);
  }
}

void Reader::one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value, double fallback) {
  chosen = 0;
  std::size_t found = alternatives.size();
  for (std::size_t k = 0; k < alternatives.size(); ++k) {
    const std::string key(alternatives[k].name);
    asked_.insert(key);
    if (!given(key)) continue;
    if (found < alternatives.size()) {
      problem(key, fmt::format(": only one of {} and {} may be given", last_step(alternatives[found].name),
                               last_step(alternatives[k].name)));
      continue;
    }
    found = k;
  }
  if (found < alternatives.size()) chosen = found;
  Parameters::one_of(alternatives, chosen, value, fallback);
}

void Reader::tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
                    const std::function<void(Parameters& entry, std::size_t index)>& each) {
  const std::string key(name);
  asked_.insert(key);
  const auto* node = find(key);
  if (node == nullptr) return;
  const auto* list = node->as_array();
  if (list == nullptr || (!list->empty() && !list->is_homogeneous(toml::node_type::table))) {
    return wrong_type(key, *node, fmt::format("a list of tables, each headed [[{}]]", key));
  }
  const auto count = resize(list->size());
  for (std::size_t k = 0; k < count; ++k) {
    Prefixed entry(fmt::format("{}[{}].", key, k), *this);
    each(entry, k);
  }
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
        problems_.push_back(fmt::format(
            "{}: {}{}\"{}\": unknown key; keys are words, with dots outside quotation marks",
            child.source().begin.line > 0 ? at_line(child) : place(key), key, key.empty() ? "" : ".", name.str()));
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
