// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/progress.hpp"

#include "repose/cli/say.hpp"
#include "repose/simulation/expectation.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace repose {

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Progress::Progress(const Scene& scene, bool show)
    : scene_(scene),
      show_(show),
      terminal_(::isatty(STDOUT_FILENO) == 1),
      all_work_(expected_work(scene, expected_end(scene))) {}

template <int D>
void Progress::update(const Simulation<D>& simulation) {
  if (!show_) return;
  const auto now = Clock::now();
  const double between = terminal_ ? 0.2 : 10.0;
  if (std::chrono::duration<double>(now - last_).count() < between) return;
  last_ = now;
  const double seconds = simulation.wall_seconds();
  const double speed = simulation.grain_steps() / std::max(seconds, 1e-9);
  const double done = std::clamp(simulation.grain_steps() / std::max(all_work_, 1.0), 0.0, 1.0);
  const double left = speed > 0.0 ? std::max(0.0, all_work_ - simulation.grain_steps()) / speed : 0.0;
  const auto line = fmt::format("{:3.0f} %  time {:.5g}  {} grains  {:.1f} M grain-steps/s  {} left", 100.0 * done,
                                simulation.time(), moving_count(simulation.grains()), speed * 1e-6, clock_text(left));
  if (terminal_) {
    constexpr std::size_t width = 24;
    const auto full = static_cast<std::size_t>(done * width);
    say("\r[{}{}] {}\033[K", std::string(full, '#'), std::string(width - full, '.'), line);
    drawn_ = true;
  } else {
    say("{}\n", line);
  }
  std::fflush(stdout);
}

template void Progress::update(const Simulation<2>&);
template void Progress::update(const Simulation<3>&);

void Progress::finish() {
  if (drawn_) say("\r\033[K");
  std::fflush(stdout);
}

}  // namespace repose
