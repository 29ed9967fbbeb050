// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"
#include "repose/theory/model_parameters.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace repose::theory {

/// Reads settings into the parameters of a model, and gathers what is wrong with them.
class SettingsReader : public ModelParameters {
 public:
  explicit SettingsReader(const std::vector<std::pair<std::string, std::string>>& settings);

  void number(std::string_view name, double& value, const Bounds& bounds, std::string_view unit,
              std::string_view about) override;
  void optional_number(std::string_view name, std::optional<double>& value, std::string_view otherwise,
                       const Bounds& bounds, std::string_view unit, std::string_view about) override;
  void integer(std::string_view name, std::int64_t& value, const WholeBounds& bounds, std::string_view about) override;
  void choice(std::string_view name, std::string& value, const std::vector<std::string>& words,
              std::string_view about) override;
  void text(std::string_view name, std::string& value, std::string_view about) override;

  /// What is wrong, after all parameters were shown; a setting that no parameter took is unknown to `model`.
  std::vector<std::string> problems(std::string_view model) const;

 private:
  const std::string* take(std::string_view name);
  void complain(std::string_view name, const std::string& written, const std::string& what);
  void read(std::string_view name, const std::string& written, double& value, const Bounds& bounds,
            std::string_view unit);

  std::map<std::string, std::string, std::less<>> settings_;
  std::set<std::string, std::less<>> known_;
  std::vector<std::string> problems_;
};

/// Throws InputError with a line for every problem. What parameters must obey together is asked of
/// `relations(model)`, a list of problems, where the model has one and each parameter is right by itself.
template <class M>
void read_settings(M& model, const std::vector<std::pair<std::string, std::string>>& settings) {
  SettingsReader reader{settings};
  parameters(model, reader);
  auto problems = reader.problems(M::text.name);
  if constexpr (requires { relations(model); }) {
    if (problems.empty()) {
      for (const auto& problem : relations(model)) problems.push_back(std::string{M::text.name} + ": " + problem);
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace repose::theory
