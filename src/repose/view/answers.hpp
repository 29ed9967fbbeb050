// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/view/answer.hpp"

#include <memory>
#include <mutex>
#include <string>

namespace repose {

class RunAnswers;
class SweepAnswers;

/// Answers the addresses of a view, of a run or a sweep, one at a time: HDF5 is not for several threads.
class Answers {
 public:
  /// Throws InputError if the folder holds neither.
  explicit Answers(const std::string& folder);
  ~Answers();

  /// The answer to an address below the token, such as "api/run".
  Answer answer(const std::string& address);

  /// Whether there are events of the folder ("") or of a member of a sweep ("members/POINT/seed-N/").
  bool has_events(const std::string& of);

  /// What they tell, as JSON; "" where the folder has vanished.
  std::string state(const std::string& of);

 private:
  RunAnswers* member(const std::string& of);

  std::string folder_;
  std::mutex mutex_;
  std::unique_ptr<RunAnswers> run_;
  std::unique_ptr<SweepAnswers> sweep_;
};

}  // namespace repose
