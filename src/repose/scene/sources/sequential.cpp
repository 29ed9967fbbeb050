// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/sequential.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

void SequentialSource::check(const Scene& scene, Problems& problems) const {
  if (scene.gravity == 0.0 && problems.sound("gravity")) {
    problems.problem("source.kind", " = \"sequential\": needs gravity > 0");
  }
  if (problems.sound("source.half_width") && problems.sound("box.half_width") &&
      std::fabs(x) + half_width > scene.box.half_width) {
    problems.problem("source.half_width", fmt::format(" = {}: grains must be released within the box, x = +-{}",
                                                      half_width, scene.box.half_width));
  }
}

double SequentialSource::expected_end(const Scene& scene) const {
  constexpr double steps_of_a_grain = 20.0;  // until it lies still; seen in examples/deposition-cd.toml
  return steps_of_a_grain * scene.time_step() * static_cast<double>(count);
}

double SequentialSource::expected_work(const Scene&, double time) const {
  return 0.5 * static_cast<double>(count) * time;
}

std::string SequentialSource::describe() const { return fmt::format("{} laid down one by one", count); }

}  // namespace repose
