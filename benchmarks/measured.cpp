// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "measured.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>

namespace repose::bench {

namespace {

double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Cost measure(double seconds, const std::function<double()>& piece) {
  Cost cost;
  const double cpu = cpu_time();
  const double wall = wall_time();
  while (cost.cpu_seconds < seconds) {
    cost.work += piece();
    cost.cpu_seconds = cpu_time() - cpu;
    cost.wall_seconds = wall_time() - wall;
  }
  return cost;
}

double peak_memory() {
  std::ifstream status("/proc/self/status");
  constexpr double kib_per_mib = 1024.0;
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / kib_per_mib;
  }
  return 0.0;
}

void print_cost(const Cost& cost, const std::string& more) {
  fmt::print(R"({{"work": {}, "cpu_seconds": {}, "wall_seconds": {}, "peak_mib": {:.1f}{}{}}})"
             "\n",
             cost.work, cost.cpu_seconds, cost.wall_seconds, peak_memory(), more.empty() ? "" : ", ", more);
}

}  // namespace repose::bench
