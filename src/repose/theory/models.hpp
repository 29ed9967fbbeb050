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

/// A parameter as a user meets it.
struct ParameterText {
  std::string name;
  std::string value;    ///< what it has, or its default; "" where there is none
  std::string unit;     ///< "" for words
  std::string allowed;  ///< "must be > 0 and < 60"
  std::string about;
  bool is_set = true;  ///< false: it has no value, and `value` says what holds without
};

using Setting = std::pair<std::string, std::string>;  ///< name and value, both as written

/// All models with their defaults, in the order of the registry.
std::vector<Model> default_models();

/// Names of all models, as a message lists them: "a | b | c".
std::string model_names();

/// Parameters of a model with their defaults; none for an unknown one.
std::vector<ParameterText> default_parameters(std::string_view model);

/// Reads "key=value"; none where it is not so written.
std::optional<Setting> read_setting(const std::string& written);

/// A model with the settings read into it. Throws InputError with a line for every problem: unknown model or
/// parameter, a value that is none, one outside its bounds, or values that do not go together.
Model make_model(std::string_view name, const std::vector<Setting>& settings);

ModelText text_of(const Model& model);
std::vector<ParameterText> parameters_of(const Model& model);

/// Throws InputError where the model reads a file that is not as it should be.
Table predict(const Model& model);

/// The table as CSV: what it is, parameters, numbers and columns in lines that begin with #, one line of names, then
/// the rows. Numbers have the fewest digits that read back as the same bits.
std::string as_csv(const Model& model, const Table& table);

/// All models with their parameters, defaults, units and sources, for a reader.
std::string list_of_models();

}  // namespace repose::theory
