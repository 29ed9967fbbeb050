// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/keys.hpp"
#include "repose/scene/toml_file.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace repose {

/// Fills a scene in from TOML and collects what is wrong with it.
class Reader final : public Keys {
 public:
  Reader(const toml::table& root, std::string name) : root_(root), name_(std::move(name)) {}

  void number(const std::string& key, double& value, double fallback, const Bounds& bounds, std::string_view unit,
              std::string_view about) override;
  void optional_number(const std::string& key, std::optional<double>& value, std::string_view none,
                       const Bounds& bounds, std::string_view unit, std::string_view about) override;
  void integer(const std::string& key, std::int64_t& value, std::optional<std::int64_t> fallback, std::int64_t low,
               std::string_view about) override;
  void flag(const std::string& key, bool& value, bool fallback, std::string_view about) override;
  void text(const std::string& key, std::string& value, std::string_view fallback, std::string_view about) override;
  void choice(const std::string& key, std::string& value, std::string_view fallback,
              const std::vector<std::string>& words, std::string_view about) override;
  void vector(const std::string& key, std::array<double, 2>& value, std::optional<std::array<double, 2>> fallback,
              std::string_view unit, std::string_view about) override;
  void numbers(const std::string& key, std::vector<double>& values, std::string_view unit,
               std::string_view about) override;
  void one_of(const std::string& group, const std::vector<Parameters::Way>& ways, std::size_t& way, double& value,
              double fallback) override;
  void tables(const std::string& key, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(const std::string& prefix, std::size_t index)>& each) override;

  /// Adds a problem with a key, at the place where the key (or else its table) stands.
  void problem(const std::string& key, const std::string& what);
  /// True if the key is there and nothing is wrong with it so far.
  bool sound(const std::string& key) const { return !wrong_.contains(key); }
  bool given(const std::string& key) const override { return find(key) != nullptr; }
  /// Adds a problem for every key of the file that `go_through` did not ask for.
  void report_unknown_keys();
  /// Says that a key came from elsewhere than the file.
  void comes_from(const std::string& key, const std::string& origin) { origin_[key] = origin; }
  bool from_command_line(const std::string& key) const {
    const auto origin = origin_.find(key);
    return origin != origin_.end() && origin->second.starts_with("--set");
  }
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  const toml::node* find(const std::string& key) const;
  std::string place(const std::string& key) const;
  void missing(const std::string& key, std::string_view about);
  void wrong_type(const std::string& key, const toml::node& node, std::string_view wanted);
  bool check_bounds(const std::string& key, const std::string& shown, double value, const Bounds& bounds,
                    std::string_view unit);
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
