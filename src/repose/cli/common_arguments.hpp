// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/cli/command_line/verb.hpp"
#include "repose/scene/read.hpp"

#include <string>

namespace repose {

// Arguments that several verbs share.

/// A scene file and the changes that the command line makes to it.
struct SceneOptions {
  std::string file;
  Overrides overrides;

  Scene read() const { return read_scene(file, overrides); }
};

inline Argument scene_argument(SceneOptions& scene) {
  return {.name = "SCENE",
          .about = "Scene file (TOML)",
          .target = &scene.file,
          .required = true,
          .completes = Completion::scene_files};
}

inline Argument set_argument(SceneOptions& scene) {
  return {.name = "--set",
          .value = "KEY=VALUE",
          .about = "Override a key of the scene, such as contact.friction=0.3",
          .target = &scene.overrides.set};
}

inline Argument seed_argument(SceneOptions& scene) {
  return {.name = "--seed",
          .value = "N",
          .about = "Seed of all random numbers, a decimal whole number",
          .target = &scene.overrides.seed};
}

/// At most `most_threads`; 0, which no user can give, leaves the choice to the program.
inline Argument threads_argument(int& threads, std::string about) {
  constexpr double most_threads = 1024;
  return {.name = "--threads",
          .value = "N",
          .about = std::move(about),
          .target = &threads,
          .bound = {.least = 1, .most = most_threads}};
}

inline Argument folder_argument(std::string& folder, std::string about) {
  return {
      .name = "DIR", .about = std::move(about), .target = &folder, .required = true, .completes = Completion::folders};
}

inline Argument overwrite_argument(bool& overwrite, std::string about) {
  return {.name = "--overwrite", .about = std::move(about), .target = &overwrite};
}

inline Argument quiet_argument(bool& quiet) {
  return {.name = "--quiet", .about = "Print nothing but errors", .target = &quiet};
}

}  // namespace repose
