// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/keys.hpp"
#include "repose/scene/reference.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace repose {

namespace {

struct KindOfValue {
  const char* operator()(const Parameters::Number&) const { return "number"; }
  const char* operator()(const Parameters::OptionalNumber& number) const {
    return number.without.word.empty() ? "number" : "number or word";
  }
  const char* operator()(const Parameters::Whole&) const { return "whole number"; }
  const char* operator()(const Parameters::Flag&) const { return "true or false"; }
  const char* operator()(const Parameters::Text&) const { return "text"; }
  const char* operator()(const Parameters::Choice&) const { return "text"; }
  const char* operator()(const Parameters::Vector&) const { return "vector"; }
  const char* operator()(const Parameters::List&) const { return "list"; }
};

/// A value that a key is set to, as text.
using Settings = std::map<std::string, std::string>;

/// Another value of a key, which may bring about other keys.
struct Branch {
  std::string key;
  std::string value;
  std::string meaning;
};

/// Lists the keys of one scene: those that it is shown while some of them have given values and the others their
/// defaults. A list of tables has one entry.
class Listing final : public Parameters {
 public:
  explicit Listing(const Settings& settings) : settings_(settings) {}

  std::vector<KeyText> keys;
  std::vector<Branch> branches;

  void one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
              double fallback) override {
    constexpr auto given = "given";
    for (std::size_t k = 0; k < alternatives.size(); ++k) {
      const auto& one = alternatives[k];
      if (setting(plain(one.name)) == given) chosen = k;
      keys.push_back({.key = plain(one.name),
                      .unit = std::string(one.unit),
                      .allowed = one.bounds.range(),
                      .fallback = k == 0 ? fmt::format("{}", fallback) : "",
                      .about = std::string(one.about),
                      .kind = "number"});
      if (k > 0) branches.push_back({plain(one.name), given, ""});
    }
    value = 0.5;
  }

  void tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(Parameters& entry, std::size_t index)>& each) override {
    resize(1);
    Prefixed entry(fmt::format("{}[].", name), *this);
    each(entry, 0);
  }

 private:
  static std::string plain(std::string_view name) { return std::string(name); }

  std::string setting(const std::string& key) const {
    const auto found = settings_.find(key);
    return found == settings_.end() ? "" : found->second;
  }

  void branch(const Item& item, const std::string& value, std::string_view meaning = "") {
    branches.push_back({plain(item.name), value, std::string(meaning)});
  }

  void show(const Item& item) override {
    KeyText text{.key = plain(item.name),
                 .unit = std::string(item.unit),
                 .allowed = allowed_text(item),
                 .fallback = default_text(item),
                 .about = std::string(item.about),
                 .kind = std::visit(KindOfValue{}, item.value)};
    text.required = !take_default(item) && text.fallback.empty();
    std::visit([&](const auto& kind) { look_at(item, kind, text); }, item.value);
    keys.push_back(std::move(text));
  }

  // Sets the value if a setting says so, and notes the other values that it may have.

  void look_at(const Item& item, const Choice& choice, KeyText& text) {
    const auto usual = choice.value;
    for (const auto& word : choice.words) {
      if (word.name != usual) branch(item, std::string(word.name), word.about);
      if (!word.about.empty()) text.words.emplace_back(word.name, word.about);
    }
    if (const auto wanted = setting(text.key); !wanted.empty()) choice.value = wanted;
    if (choice.fallback.rule.empty()) text.fallback = fmt::format("\"{}\"", text.fallback);
    if (choice.words.size() == 1) text.allowed.clear();  // a name in the scene itself
  }
  void look_at(const Item& item, const Flag& flag, KeyText& text) {
    branch(item, *flag.value ? "false" : "true");
    if (const auto wanted = setting(text.key); !wanted.empty()) flag.value = wanted == "true";
    text.allowed.clear();
  }
  void look_at(const Item& item, const Whole& whole, KeyText& text) {
    if (text.required) return;
    // The other one of two values that it may have.
    const bool one_of_two = whole.bounds.high == whole.value + 1 && whole.bounds.low == whole.value;
    branch(item, one_of_two ? fmt::format("{}", whole.bounds.high) : fmt::format("not {}", whole.value));
    if (!setting(text.key).empty()) ++whole.value;
  }
  void look_at(const Item& item, const Number& number, KeyText& text) {
    if (number.value != 0.0) return;
    branch(item, "> 0");
    if (!setting(text.key).empty()) number.value = number.bounds.hold(1.0) ? 1.0 : 0.5;
  }
  void look_at(const Item& item, const Text& written, KeyText& text) {
    branch(item, "given");
    if (!setting(text.key).empty()) written.value = "given";
    if (!text.required && written.fallback->rule.empty()) text.fallback = fmt::format("\"{}\"", text.fallback);
  }
  void look_at(const Item&, const OptionalNumber& number, KeyText& text) {
    if (!number.without.word.empty()) text.fallback = fmt::format("\"{}\"", text.fallback);
  }
  template <class Other>
  void look_at(const Item&, const Other&, KeyText&) {}

  const Settings& settings_;
};

Listing listing_with(const Settings& settings) {
  Listing listing(settings);
  Scene scene;
  show_keys(scene, listing);
  return listing;
}

std::string table_of(const std::string& key) { return key.substr(0, key.find('.')); }

bool same_text(const KeyText& a, const KeyText& b) {
  return a.key == b.key && a.unit == b.unit && a.allowed == b.allowed && a.fallback == b.fallback &&
         a.required == b.required && a.about == b.about && a.words == b.words;
}

/// Goes from a scene to those that differ from it in one more value, as long as that shows something new.
class Search {
 public:
  explicit Search(std::string method) : method_(std::move(method)) {
    Settings settings{{"method.kind", method_}};
    const auto all = listing_with(settings);
    for (const auto& key : all.keys) note(key, {});
    for (const auto& branch : all.branches) follow(branch, settings, {}, all);
    drop_indirect();
  }

  std::vector<KeyText> found;

 private:
  void note(KeyText key, const std::vector<KeyCondition>& conditions) {
    const auto always = [&](const auto& other) { return other.conditions.empty() && same_text(key, other); };
    if (std::any_of(found.begin(), found.end(), always)) return;
    key.methods = {method_};
    key.conditions = conditions;
    found.push_back(std::move(key));
  }

  void follow(const Branch& branch, Settings settings, std::vector<KeyCondition> conditions, const Listing& before) {
    if (branch.key == "method.kind") return;
    const bool other_dimension = branch.key == "dimension";
    if (other_dimension && !method_kinds().make(method_)->in_dimension(3)) return;
    settings[branch.key] = branch.value;
    conditions.push_back({branch.key, {branch.value}, branch.meaning});
    const auto now = listing_with(settings);
    for (const auto& key : now.keys) {
      const auto same = [&](const auto& other) { return same_text(key, other); };
      if (std::any_of(before.keys.begin(), before.keys.end(), same)) continue;
      note(key, conditions);
    }
    for (const auto& next : now.branches) {
      const auto known = [&](const auto& other) { return other.key == next.key && other.value == next.value; };
      // In another dimension every choice may show other keys.
      const bool fresh = std::none_of(before.branches.begin(), before.branches.end(), known);
      if (next.key != branch.key && (fresh || other_dimension)) follow(next, settings, conditions, now);
    }
  }

  /// Where a key follows from another of its own table alone, all else that brings it about is left out: it changes the
  /// default of that one.
  void drop_indirect() {
    const auto direct = [](const auto& entry) {
      return entry.conditions.size() == 1 && table_of(entry.conditions.front().key) == table_of(entry.key);
    };
    const auto all = found;
    std::erase_if(found, [&](const auto& entry) {
      if (entry.conditions.empty() || direct(entry)) return false;
      return std::any_of(all.begin(), all.end(),
                         [&](const auto& other) { return same_text(entry, other) && direct(other); });
    });
  }

  std::string method_;
};

/// Whether one list of values is part of the other.
bool one_in_other(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  const auto in = [](const auto& part, const auto& whole) {
    return std::all_of(part.begin(), part.end(),
                       [&](const auto& value) { return std::find(whole.begin(), whole.end(), value) != whole.end(); });
  };
  return in(a, b) || in(b, a);
}

/// Joins two entries that differ in nothing but the methods, or in the values of one condition. Another method may have
/// fewer of these values.
bool join(KeyText& entry, const KeyText& other) {
  if (!same_text(entry, other) || entry.conditions.size() != other.conditions.size()) return false;
  const bool same_methods = entry.methods == other.methods;
  const auto add_methods = [&] {
    if (!same_methods) entry.methods.push_back(other.methods.front());
    return true;
  };
  if (entry.conditions == other.conditions) return add_methods();
  for (std::size_t k = 0; k < entry.conditions.size(); ++k) {
    auto joined = entry.conditions;
    if (joined[k].key != other.conditions[k].key) continue;
    joined[k] = other.conditions[k];
    if (joined != other.conditions) continue;
    auto& values = entry.conditions[k].values;
    if (!same_methods && !one_in_other(values, other.conditions[k].values)) return false;
    for (const auto& value : other.conditions[k].values) {
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
    entry.conditions[k].meaning.clear();
    return add_methods();
  }
  return false;
}

}  // namespace

std::vector<KeyText> all_keys() {
  std::vector<KeyText> all;
  const auto join_into = [&](std::vector<KeyText>& list, const KeyText& key) {
    const bool known = std::any_of(list.begin(), list.end(), [&](auto& entry) { return join(entry, key); });
    if (!known) list.push_back(key);
  };
  for (const auto& method : method_kinds().all()) {
    std::vector<KeyText> of_method;
    for (const auto& key : Search(std::string(method->name())).found) join_into(of_method, key);
    for (const auto& key : of_method) join_into(all, key);
  }
  return all;
}

}  // namespace repose
