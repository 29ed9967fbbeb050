// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace repose::bench {

/// What a piece of work cost.
struct Cost {
  double work = 0.0;         ///< in units of the caller
  double cpu_seconds = 0.0;  ///< of all threads
  double wall_seconds = 0.0;
};

/// Calls `piece`, which returns the work it did, until it has taken this many seconds of CPU time.
Cost measure(double seconds, const std::function<double()>& piece);

/// The largest memory of this process so far [MiB].
double peak_memory();

/// Prints the cost and memory as one line of JSON, with further members, such as `"contacts": 5`.
void print_cost(const Cost& cost, const std::string& more = "");

}  // namespace repose::bench
