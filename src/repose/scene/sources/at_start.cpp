// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/at_start.hpp"

#include "repose/scene/scene.hpp"

#include <fmt/format.h>

namespace repose {

void NoSource::check(const Scene& scene, Problems& problems) const {
  if (scene.placed.empty() && scene.start.from.empty() && problems.sound("grain") && problems.sound("source.kind") &&
      problems.sound("start.from")) {
    problems.problem("source.kind",
                     ": there are no grains: needs a source.kind, a start.from or at least one [[grain]]");
  }
}

void DepositedDiscs::check(const Scene&, Problems& problems) const {
  constexpr std::int64_t most = 2'000'000'000;
  if (count > most && problems.sound("source.count")) {
    problems.problem("source.count", fmt::format(" = {}: must be at most {}", count, most));
  }
}

std::string DepositedDiscs::describe() const { return fmt::format("{} deposited", count); }
std::string DepositedSpheres::describe() const { return fmt::format("{} deposited", count); }

}  // namespace repose
