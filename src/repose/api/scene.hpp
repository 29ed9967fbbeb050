// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace repose {
struct Scene;
}

namespace repose::api {

/// A value as a scene file has it, for tables and lists of words: {R"({ law = "hooke", stiffness = 500 })"}.
struct Toml {
  std::string text;
};

/// The value of a key of a scene.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, Toml>;

/// Keys such as "contact.friction" with their values. The keys are those of docs/reference/scene.md.
using Settings = std::vector<std::pair<std::string, Value>>;

/// A checked scene. A scene from a file, from text and from memory goes through the same checks; all of them throw
/// InputError with one line for every problem.
class Scene {
 public:
  /// Reads a scene file. Paths in the scene are relative to the file. Settings replace keys of the file.
  static Scene from_file(const std::string& path, const Settings& settings = {});

  /// Reads the text of a scene file. Paths in the scene are relative to the current folder.
  static Scene from_text(const std::string& toml, const Settings& settings = {});

  /// The same scene with other values of some keys. Defaults that depend on a changed key follow it.
  Scene with(const Settings& settings) const;

  /// The text of the scene file with every key and its value, as a run folder keeps it.
  std::string text() const;

  const repose::Scene& content() const { return *scene_; }

 private:
  Scene(std::string text, std::string name, Settings settings);

  std::string text_;  // as given
  std::string name_;  // the file in messages
  Settings settings_;
  std::shared_ptr<const repose::Scene> scene_;
};

/// A scene that is built key by key in memory.
class SceneDraft {
 public:
  /// Sets a key that does not belong to a list of tables.
  SceneDraft& set(const std::string& key, const Value& value);

  /// Appends a table to a list of tables, for example add("plane", {{"point", ...}, {"normal", ...}}).
  SceneDraft& add(const std::string& table, const Settings& keys);

  /// The text of the scene file with the keys that were set.
  std::string text() const { return keys_ + tables_; }

  /// The scene. Throws InputError; a problem names the line of `text`.
  Scene checked() const { return Scene::from_text(text()); }

 private:
  std::string keys_;
  std::string tables_;
};

}  // namespace repose::api
