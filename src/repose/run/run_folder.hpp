// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/simulation.hpp"

#include <string>
#include <vector>

namespace repose {

/// The folder that a run writes; see docs/reference/run-folder.md.
class RunFolder {
 public:
  /// What stands in the way of writing a run here, one line each; nothing is touched.
  static std::vector<std::string> problems(const std::string& path, bool overwrite);

  /// Makes the folder (or clears an older run out of it) and writes scene.toml and the state at the start. Throws
  /// InputError if that fails, and then leaves no half-written folder.
  RunFolder(std::string path, const Simulation& simulation);

  /// Writes the present state and summary, and a frame if asked. Throws RunError; what was there before stays.
  void write(const Simulation& simulation, bool frame);

  const std::string& path() const { return path_; }

 private:
  void write_run(const Simulation& simulation);

  std::string path_;
  std::vector<std::string> frames_;
};

}  // namespace repose
