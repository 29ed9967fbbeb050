// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/registry.hpp"
#include "repose/theory/table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace repose::theory {

/// A parameter as text for the user.
struct ParameterText {
  std::string name;
  std::string value;    ///< its value or default; "" if it must be given
  std::string unit;     ///< "" for words
  std::string allowed;  ///< "must be > 0 and < 60"
  std::string about;
  bool is_set = true;  ///< false: it has no value, and `value` states what holds without one
};

using Setting = std::pair<std::string, std::string>;  ///< name and value, both as written

/// All models with their defaults, in the order of the registry.
std::vector<Model> default_models();

/// The names of all models for a message: "a | b | c".
std::string model_names();

/// The parameters of a model with their defaults; empty for an unknown model.
std::vector<ParameterText> default_parameters(std::string_view model);

/// Parses "key=value"; none if the text has another form.
std::optional<Setting> read_setting(const std::string& written);

/// A model with these settings. Throws InputError with one line per problem: an unknown model or parameter, a value
/// that cannot be parsed or is out of bounds, or values that contradict each other.
Model make_model(std::string_view name, const std::vector<Setting>& settings);

ModelText text_of(const Model& model);
std::vector<ParameterText> parameters_of(const Model& model);

/// The prediction of the model. Throws InputError if the model reads a file and the file is invalid.
Table predict(const Model& model);

/// The table as CSV. Lines that begin with # describe the model, its parameters, the single numbers and the columns;
/// then come one line of names and the rows. Numbers have the fewest digits that read back as the same bits.
std::string as_csv(const Model& model, const Table& table);

/// A text that lists all models with their parameters, defaults, units and sources.
std::string list_of_models();

}  // namespace repose::theory
