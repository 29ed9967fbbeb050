// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/members.hpp"

#include <chrono>
#include <map>
#include <string>

namespace repose {

/// Describes the members of a sweep and the work that they are.
std::string describe_plan(const SweepPlan& plan);

/// Describes the result: one line per point, then the verdicts on the claims.
std::string describe_table(const SweepFolder& folder, const SweepTable& table);

/// Shows the progress of a sweep: a table that fills on a terminal, one line per member otherwise.
class SweepView {
 public:
  SweepView(const SweepFolder& folder, const Sweep& sweep, bool quiet);
  /// Call this when a member has ended.
  void ended(std::size_t member);
  /// Call this several times a second.
  void tick();
  /// Clears the live table.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void read_results(std::size_t member);
  std::string live_table() const;
  std::string time_left() const;
  std::string member_name(std::size_t member) const;

  const SweepFolder& folder_;
  const Sweep& sweep_;
  bool quiet_;
  bool terminal_;
  double share_at_start_;
  std::vector<std::map<std::string, double>> results_;  // by member, of the measures shown
  std::size_t lines_drawn_ = 0;
  Clock::time_point last_{};
};

}  // namespace repose
