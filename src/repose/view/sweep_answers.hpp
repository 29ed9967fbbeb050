// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/folder.hpp"
#include "repose/view/run_answers.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace repose {

/// Answers questions about a sweep folder and its members. Reads only, and may be asked by several threads.
class SweepAnswers {
 public:
  /// Throws InputError if there is no sweep.
  explicit SweepAnswers(const std::string& folder);

  /// The answer to "sweep" or "members/POINT/seed-N/...".
  Answer answer(const std::string& address);

  /// How many members have finished, run and failed.
  nlohmann::ordered_json state();

  /// The answers of the member with this name, "POINT/seed-N"; null where there is none.
  RunAnswers* member(const std::string& name);

 private:
  using Measures = std::vector<std::pair<std::string, double>>;
  struct Seen {
    std::string version;  // of its summary.json
    std::string status;   // "waiting", "running", "finished" or "failed"
    std::string message;  // why it failed
    Measures measures;    // of a finished one
  };

  const Seen& look_at(std::size_t member);
  std::string sweep_text();
  nlohmann::ordered_json means_of(std::size_t point) const;
  std::string name_of(const Member& member) const;
  Answer of_member(const std::string& address);

  SweepFolder folder_;
  std::mutex mutex_;
  std::vector<Seen> seen_;
  std::map<std::string, std::unique_ptr<RunAnswers>> runs_;
};

}  // namespace repose
