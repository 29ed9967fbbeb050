// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/read.hpp"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace repose {

/// The options by which a command names a scene and changes it.
struct SceneOptions {
  std::string file;
  Overrides overrides;

  void add_to(CLI::App& command);
  Scene read() const { return read_scene(file, overrides); }
};

}  // namespace repose
