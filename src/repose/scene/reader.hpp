// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/scene/problems.hpp"
#include "repose/scene/toml_file.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace repose {

/// Fills a scene in from TOML and collects what is wrong with it.
class Reader final : public Parameters, public Problems {
 public:
  /// `name` stands for the file in messages; without one a message begins with the key.
  Reader(const toml::table& root, std::string name) : root_(root), name_(std::move(name)) {}

  void one_of(const std::vector<Alternative>& alternatives, std::size_t& chosen, double& value,
              double fallback) override;
  void tables(std::string_view name, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(Parameters& entry, std::size_t index)>& each) override;
  bool given(std::string_view key) const override { return find(std::string(key)) != nullptr; }

  void problem(const std::string& key, const std::string& what) override;
  bool sound(const std::string& key) const override { return !wrong_.contains(key); }
  bool none() const override { return problems_.empty(); }

  /// Adds a problem for every key of the file that was not asked for.
  void report_unknown_keys();
  /// Says that a key came from elsewhere than the file.
  void comes_from(const std::string& key, const std::string& origin) { origin_[key] = origin; }
  bool from_command_line(const std::string& key) const;
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  void show(const Item& item) override;
  std::optional<double> number_of(const Item& item, const toml::node& node);
  void read(const Item& item, const toml::node& node, const Number& number);
  void read(const Item& item, const toml::node& node, const OptionalNumber& number);
  void read(const Item& item, const toml::node& node, const Whole& whole);
  void read(const Item& item, const toml::node& node, const Flag& flag);
  void read(const Item& item, const toml::node& node, const Text& text);
  void read(const Item& item, const toml::node& node, const Choice& choice);
  void read(const Item& item, const toml::node& node, const Vector& vector);
  void read(const Item& item, const toml::node& node, const List& list);

  const toml::node* find(const std::string& key) const;
  std::string at_line(const toml::node& node) const;
  std::string place(const std::string& key) const;
  void missing(const std::string& key, std::string_view about);
  void wrong_type(const std::string& key, const toml::node& node, std::string_view wanted);
  bool check_bounds(const Item& item, const std::string& shown, double value, const Bounds& bounds);
  bool any_asked(const std::string& beginning) const;
  void unknown_in(const toml::node& node, const std::string& key);

  const toml::table& root_;
  std::string name_;
  std::set<std::string> asked_;
  std::set<std::string> wrong_;
  std::map<std::string, std::string> origin_;
  std::vector<std::string> problems_;
};

}  // namespace repose
