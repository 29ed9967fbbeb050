// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace repose {

/// A key that exists under some condition only: where another key has one of some values.
struct KeyCondition {
  std::string key;
  std::vector<std::string> values;  ///< as in a scene
  std::string meaning;              ///< of the value, if there is one and it has a meaning of its own

  bool operator==(const KeyCondition&) const = default;
};

/// A key of a scene as the reference lists it. The same key has several entries where it means different things.
struct KeyText {
  std::string key;  ///< "base.spacing"; "wall[].from" of a list of tables
  std::string unit;
  std::string allowed;   ///< "> 0"; "" for any
  std::string fallback;  ///< the default, as a value or a rule
  bool required = false;
  std::string about;
  std::string kind{};  ///< of the value: number, number or word, whole number, true or false, text, vector, list
  std::vector<std::pair<std::string, std::string>> words{};  ///< what its words mean, of those that have a meaning
  std::vector<std::string> methods{};                        ///< that have it
  std::vector<KeyCondition> conditions{};                    ///< all must hold
};

/// Every key that the reader of scenes knows, found by showing the keys of a scene again and again with every word of
/// every choice.
std::vector<KeyText> all_keys();

/// The tables of docs/reference/scene.md: one of keys for each table of a scene, between the lines that mark it.
std::string scene_reference();

}  // namespace repose
