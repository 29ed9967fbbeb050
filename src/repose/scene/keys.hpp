// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/scene/scene.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// Goes through every key of a scene, in order: the reader fills the values in, the writer writes them out.
/// Keys are dotted paths; units in M, L, T; `about` is one line for the user.
class Keys {
 public:
  virtual ~Keys() = default;
  /// Whether there is anything under a key; what is not said may then be as elsewhere.
  virtual bool given(const std::string& key) const = 0;
  virtual void number(const std::string& key, double& value, double fallback, const Bounds& bounds,
                      std::string_view unit, std::string_view about) = 0;
  /// A number, or the word that stands for none: "auto", or "" where the key may be left out.
  virtual void optional_number(const std::string& key, std::optional<double>& value, std::string_view none,
                               const Bounds& bounds, std::string_view unit, std::string_view about) = 0;
  virtual void integer(const std::string& key, std::int64_t& value, std::optional<std::int64_t> fallback,
                       std::int64_t low, std::string_view about) = 0;
  virtual void flag(const std::string& key, bool& value, bool fallback, std::string_view about) = 0;
  virtual void text(const std::string& key, std::string& value, std::string_view fallback, std::string_view about) = 0;
  /// One of some words; an empty fallback: the key must be given.
  virtual void choice(const std::string& key, std::string& value, std::string_view fallback,
                      const std::vector<std::string>& words, std::string_view about) = 0;
  virtual void vector(const std::string& key, std::array<double, 2>& value,
                      std::optional<std::array<double, 2>> fallback, std::string_view unit, std::string_view about) = 0;
  /// A list of numbers, at least one, that must be given.
  virtual void numbers(const std::string& key, std::vector<double>& values, std::string_view unit,
                       std::string_view about) = 0;
  /// One number that may be given by one of several keys, `group` and a name each; the first is the default.
  virtual void one_of(const std::string& group, const std::vector<Parameters::Way>& ways, std::size_t& way,
                      double& value, double fallback) = 0;
  /// An array of tables [[key]]: resizes through `resize` on reading, and calls `each` for every entry.
  virtual void tables(const std::string& key, const std::function<std::size_t(std::size_t)>& resize,
                      const std::function<void(const std::string& prefix, std::size_t index)>& each) = 0;
};

/// Shows every key of the scene to `keys`.
void go_through(Scene& scene, Keys& keys);

}  // namespace repose
