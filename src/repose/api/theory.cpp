// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/theory.hpp"

#include "repose/theory/models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <variant>

namespace repose::api {

namespace {

struct PlainText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const std::vector<double>& values) const { return fmt::format("{}", fmt::join(values, ",")); }
  std::string operator()(const Toml& value) const { return value.text; }
};

}  // namespace

std::vector<std::string> models() {
  std::vector<std::string> names;
  for (const auto& model : theory::default_models()) names.emplace_back(theory::text_of(model).name);
  return names;
}

theory::Table predict(const std::string& model, const Settings& settings) {
  std::vector<theory::Setting> written;
  for (const auto& [name, value] : settings) written.emplace_back(name, std::visit(PlainText{}, value));
  return theory::predict(theory::make_model(model, written));
}

}  // namespace repose::api
