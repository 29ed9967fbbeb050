// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/simulation.hpp"

#include <chrono>
#include <string>

namespace repose {

/// A duration [s] as 1:02:03 or 2:03.
std::string clock_text(double seconds);

/// Shows the progress of a run: a bar on a terminal, plain lines otherwise.
class Progress {
 public:
  Progress(const Scene& scene, bool show);
  template <int D>
  void update(const Simulation<D>& simulation);
  /// Clears the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  const Scene& scene_;
  bool show_;
  bool terminal_;
  double all_work_;
  bool drawn_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace repose
