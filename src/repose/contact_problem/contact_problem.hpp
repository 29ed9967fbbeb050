// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"
#include "repose/methods/method.hpp"
#include "repose/record/record.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// One contact problem of discs apart from any run, as docs/reference/contact-problem.md describes its file.
struct ContactProblem {
  /// A body of the problem; a wall has no radius.
  struct Place {
    std::int64_t id = 0;  ///< of the grain; -1 - k: wall k
    double radius = 0.0;  ///< [L]
    Vec<2> position{};    ///< [L]
  };

  std::string title;
  double time = 0.0;       ///< [T] at which the step begins
  double time_step = 0.0;  ///< [T]
  contact_dynamics::Problem<2> problem;
  std::vector<Place> places;
};

/// The problem of the step that would follow on the last state of a run, from the impulses of the step before. Throws
/// InputError for a run that has none, or whose walls move or grains bear loads.
ContactProblem next_contact_problem(const Record<2>& record);

/// The same under these loads on the grains. The record must be of contact dynamics, with walls that stand still.
ContactProblem pose_contact_problem(const Record<2>& record, const std::vector<Load<2>>& loads);

/// Throws RunError.
void write_contact_problem(const std::string& path, const ContactProblem& problem);

/// Throws InputError, one line for each problem.
ContactProblem read_contact_problem(const std::string& path);

}  // namespace repose
