// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What the command line or a sweep changes in a scene.
struct Overrides {
  std::vector<std::string> set;      ///< "key=value", the value as in the file; a bare word is taken as text
  std::vector<std::string> origins;  ///< where the entries of `set` stand, for messages; the command line if left out
  std::optional<std::int64_t> seed;
  /// The scene of the run whose end start.from is, while that run is yet to come; the scene is then checked for its
  /// grains as far as these are known.
  const Scene* earlier = nullptr;
};

/// Reads and checks a scene file. Throws InputError with every problem found, one line each:
/// "file:line: key = value: what is allowed".
Scene read_scene(const std::string& path, const Overrides& overrides = {});

/// The same for the text of a scene; `name` stands for the file in messages, and the folder of that name is where
/// relative paths begin.
Scene scene_from_text(const std::string& text, const std::string& name, const Overrides& overrides = {});

/// A scene filled in by hand, complete: what is left unset gets its default, and all is checked as in a file. Throws
/// InputError with every problem, one line each: "key = value: what is allowed".
Scene checked(const Scene& scene);

}  // namespace repose
