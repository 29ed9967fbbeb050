// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/rain.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

Rain::Rain(const Scene& scene, double time_step, std::int64_t first_id) : Drop(scene, time_step, first_id) {
  constexpr double part = 0.1;  // of the time in which a grain falls by half its diameter
  every_ = std::max(1L, static_cast<long>(part * std::sqrt(scene.grains.diameter / scene.gravity) / time_step));
}

}  // namespace repose
