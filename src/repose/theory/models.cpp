// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/models.hpp"

#include "repose/core/errors.hpp"
#include "repose/theory/read_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace repose::theory {

namespace {

template <std::size_t... Index>
std::vector<Model> every_model(std::index_sequence<Index...> /*of the variant*/) {
  return {Model{std::in_place_index<Index>}...};
}

/// Lists the parameters of a model.
class Lister final : public Parameters {
 public:
  std::vector<ParameterText> texts;

 private:
  void show(const Item& item) override {
    ParameterText text{std::string{item.name}, value_text(item), std::string{item.unit}, "", std::string{item.about}};
    if (!std::holds_alternative<Text>(item.value)) text.allowed = "must be " + allowed_text(item);
    if (std::holds_alternative<Whole>(item.value)) text.unit = "1";
    if (const auto* number = std::get_if<OptionalNumber>(&item.value); number != nullptr && !number->value) {
      text.value = number->without.meaning;
      text.unit.clear();
      text.is_set = false;
    }
    texts.push_back(std::move(text));
  }
};

std::string value_of(const ParameterText& parameter) {
  if (parameter.value.empty()) return "(must be given)";
  const bool with_unit = !parameter.unit.empty() && parameter.unit != "1";
  return with_unit ? parameter.value + " " + parameter.unit : parameter.value;
}

/// The text of a cell: in quotes if it contains a comma, a quote or a line break.
std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string all = "\"";
  for (const char c : cell) all += c == '"' ? std::string{"\"\""} : std::string{c};
  return all + "\"";
}

std::string unit_in_brackets(const std::string& unit) { return unit.empty() ? "" : fmt::format(" [{}]", unit); }

}  // namespace

std::vector<Model> default_models() { return every_model(std::make_index_sequence<std::variant_size_v<Model>>{}); }

std::string model_names() {
  std::vector<std::string_view> names;
  for (const auto& model : default_models()) names.push_back(text_of(model).name);
  return fmt::format("{}", fmt::join(names, " | "));
}

std::vector<ParameterText> default_parameters(std::string_view name) {
  for (const auto& model : default_models()) {
    if (text_of(model).name == name) return parameters_of(model);
  }
  return {};
}

std::optional<Setting> read_setting(const std::string& written) {
  const auto equals = written.find('=');
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  return Setting{written.substr(0, equals), written.substr(equals + 1)};
}

Model make_model(std::string_view name, const std::vector<Setting>& settings) {
  for (auto& model : default_models()) {
    if (text_of(model).name != name) continue;
    std::visit([&](auto& kind) { read_settings(kind, settings); }, model);
    return model;
  }
  throw InputError(fmt::format("{}: no such model of theory; must be {}", name, model_names()));
}

ModelText text_of(const Model& model) {
  return std::visit([](const auto& kind) { return std::decay_t<decltype(kind)>::text; }, model);
}

std::vector<ParameterText> parameters_of(const Model& model) {
  Lister lister;
  auto copy = model;
  std::visit([&](auto& kind) { parameters(kind, lister); }, copy);
  return lister.texts;
}

Table predict(const Model& model) {
  return std::visit([](const auto& kind) { return evaluate(kind); }, model);
}

std::string as_csv(const Model& model, const Table& table) {
  const auto text = text_of(model);
  std::string csv = fmt::format("# {}: {}\n# source: {}\n", text.name, text.about, text.source);
  for (const auto& parameter : parameters_of(model)) {
    csv += fmt::format("# parameter {} = {}: {}\n", parameter.name, value_of(parameter), parameter.about);
  }
  for (const auto& number : table.numbers) {
    csv +=
        fmt::format("# result {} = {}{}: {}\n", number.name, number.value, unit_in_brackets(number.unit), number.about);
  }
  for (const auto& column : table.columns) {
    csv += fmt::format("# column {}{}: {}\n", column.name, unit_in_brackets(column.unit), column.about);
  }
  for (const auto& note : table.notes) csv += fmt::format("# note {}\n", note);
  std::vector<std::string> cells;
  const auto add_row = [&] {
    csv += fmt::format("{}\n", fmt::join(cells, ","));
    cells.clear();
  };
  std::size_t rows = 0;
  for (const auto& column : table.columns) {
    cells.push_back(column.name);
    rows = std::max(column.values.size(), column.words.size());
  }
  add_row();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const auto& column : table.columns) {
      cells.push_back(column.words.empty() ? fmt::format("{}", column.values[row]) : quoted(column.words[row]));
    }
    add_row();
  }
  return csv;
}

std::string list_of_models() {
  std::string list;
  for (const auto& model : default_models()) {
    const auto text = text_of(model);
    list += fmt::format("{}{}\n    {}\n    Source: {}\n", list.empty() ? "" : "\n", text.name, text.about, text.source);
    for (const auto& parameter : parameters_of(model)) {
      list += fmt::format("    {} = {}: {}{}{}\n", parameter.name, value_of(parameter), parameter.about,
                          parameter.allowed.empty() ? "" : "; ", parameter.allowed);
    }
  }
  return list;
}

}  // namespace repose::theory
