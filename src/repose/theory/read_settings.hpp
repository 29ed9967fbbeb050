// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"
#include "repose/core/parameters.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace repose::theory {

/// Reads settings into the parameters of a model and gathers what is wrong with them.
class SettingsReader final : public Parameters {
 public:
  explicit SettingsReader(const std::vector<std::pair<std::string, std::string>>& settings);

  /// What is wrong, after all parameters were shown; a setting that no parameter took is unknown to `model`.
  std::vector<std::string> problems(std::string_view model) const;

 private:
  void show(const Item& item) override;
  void missing(const Item& item);
  void complain(const Item& item, const std::string& written, const std::string& what);

  void read(const Item& item, const std::string& written, const Number& number);
  void read(const Item& item, const std::string& written, const OptionalNumber& number);
  void read(const Item& item, const std::string& written, const Whole& whole);
  void read(const Item& item, const std::string& written, const Choice& choice);
  void read(const Item& item, const std::string& written, const Text& text);
  template <class Other>
  void read(const Item& item, const std::string& written, const Other&) {
    complain(item, written, "cannot be set by a word or a number");
  }

  std::map<std::string, std::string, std::less<>> settings_;
  std::set<std::string, std::less<>> known_;
  std::vector<std::string> problems_;
};

/// "MODEL: PROBLEM", as a message lists it.
std::string problem_of(std::string_view model, std::string_view problem);

/// Throws InputError with a line for every problem. What parameters must obey together is asked of
/// `relations(model)`, a list of problems, where the model has one and each parameter is right by itself.
template <class M>
void read_settings(M& model, const std::vector<std::pair<std::string, std::string>>& settings) {
  SettingsReader reader{settings};
  parameters(model, reader);
  auto problems = reader.problems(M::text.name);
  if constexpr (requires { relations(model); }) {
    if (problems.empty()) {
      for (const auto& problem : relations(model)) problems.push_back(problem_of(M::text.name, problem));
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace repose::theory
