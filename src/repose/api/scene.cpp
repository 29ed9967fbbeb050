// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/scene.hpp"

#include "repose/scene/read.hpp"
#include "repose/scene/scene.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/scene/toml_text.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

namespace repose::api {

namespace {

constexpr const char* name_of_text = "scene";

struct TomlText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return toml_number(value); }
  std::string operator()(const std::string& value) const { return toml_quoted(value); }
  std::string operator()(const std::vector<double>& values) const {
    std::string text = "[";
    for (const double value : values) text += (text.size() > 1 ? ", " : "") + toml_number(value);
    return text + "]";
  }
  std::string operator()(const Toml& value) const { return value.text; }
};

std::string line_of(const std::string& key, const Value& value) {
  return fmt::format("{} = {}\n", key, std::visit(TomlText{}, value));
}

}  // namespace

Scene::Scene(std::string text, std::string name, Settings settings)
    : text_(std::move(text)), name_(std::move(name)), settings_(std::move(settings)) {
  Overrides overrides;
  for (const auto& [key, value] : settings_) {
    overrides.set.push_back(fmt::format("{}={}", key, std::visit(TomlText{}, value)));
    overrides.origins.emplace_back("setting");
  }
  scene_ = std::make_shared<const repose::Scene>(scene_from_text(text_, name_, overrides));
}

Scene Scene::from_file(const std::string& path, const Settings& settings) {
  return {text_of_file(path), path, settings};
}

Scene Scene::from_text(const std::string& toml, const Settings& settings) { return {toml, name_of_text, settings}; }

Scene Scene::with(const Settings& settings) const {
  auto all = settings_;
  all.insert(all.end(), settings.begin(), settings.end());
  return {text_, name_, std::move(all)};
}

std::string Scene::text() const { return scene_text(*scene_); }

SceneDraft& SceneDraft::set(const std::string& key, const Value& value) {
  keys_ += line_of(key, value);
  return *this;
}

SceneDraft& SceneDraft::add(const std::string& table, const Settings& keys) {
  tables_ += fmt::format("[[{}]]\n", table);
  for (const auto& [key, value] : keys) tables_ += line_of(key, value);
  return *this;
}

}  // namespace repose::api
