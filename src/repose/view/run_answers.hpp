// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/exports.hpp"
#include "repose/record/record.hpp"
#include "repose/view/answer.hpp"
#include "repose/view/frame_arrays.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace repose {

/// Answers questions about a run folder, finished or still written. Reads only, and may be asked by several threads.
class RunAnswers {
 public:
  explicit RunAnswers(std::string folder) : folder_(std::move(folder)) {}

  /// The answer to an address such as "run", "frame/000001" or "series". Damaged or missing files give status 404.
  Answer answer(const std::string& address);

  /// Status, frames, rows and time, as an event tells them. Throws InputError where there is no run.
  nlohmann::ordered_json state();

  /// Keys of all moments, ascending in time; the last is "last". Throws InputError.
  std::vector<std::string> keys();

  /// The arrays of one moment. Throws InputError.
  std::string frame(const std::string& key, Precision precision = Precision::full);

 private:
  /// What is known of a saved frame without reading it again: it never changes.
  struct Extent {
    double time = 0.0;
    Vec<2> low{}, high{};
  };
  using Run = std::shared_ptr<const Record<2>>;

  Run run();                                  // the last state with the series, read again when run.h5 has changed
  Extent extent_of(const std::string& name);  // of a saved frame
  std::vector<std::string> frames_before_the_last(const Record<2>& run);
  std::string run_text();
  std::string series();
  std::string base();
  std::string fields();

  std::string folder_;
  std::mutex mutex_;
  Run run_;
  std::string version_;  // of run.h5 that run_ is from
  std::string scene_;    // hash of the scene that extents_ belong to
  std::map<std::string, Extent> extents_;
};

/// Changes whenever a file is replaced; "" where there is none.
std::string file_version(const std::string& path);

}  // namespace repose
