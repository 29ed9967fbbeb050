// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/reading.hpp"
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

  /// Writes the present state, what the analysis says of it, and a frame if asked. Throws RunError; what was there
  /// before stays.
  void write(const Simulation& simulation, bool frame);

  const std::string& path() const { return path_; }

 private:
  void write_run(const Record& record);

  std::string path_;
  std::vector<std::string> frames_;
  std::vector<std::string> segments_;  // of the track
  std::size_t moments_written_ = 0;
};

/// Writes what the analysis says, analysis.h5 and then summary.json, into a run folder. Throws RunError.
void write_reading(const std::string& folder, const Record& record, const Reading& reading);

}  // namespace repose
