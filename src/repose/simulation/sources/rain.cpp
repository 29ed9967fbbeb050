// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/rain.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

Rain::Rain(const Scene& scene, const DropSource& source, double time_step, std::int64_t first_id)
    : Drop(scene, source, time_step, first_id) {
  constexpr double part = 0.1;  // of the time in which a grain falls by half its diameter
  every_ = std::max(1L, static_cast<long>(part * std::sqrt(scene.grains.diameter / scene.gravity) / time_step));
}

std::unique_ptr<Source> RainSource::start(const Scene& scene, double time_step, std::int64_t first_id) const {
  return std::make_unique<Rain>(scene, *this, time_step, first_id);
}

}  // namespace repose
