// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/rain.hpp"

#include <cmath>

namespace repose {

namespace {

constexpr double part = 0.1;  // of the time in which a grain falls by half its diameter

}  // namespace

Rain::Rain(const Scene& scene, const DropSource& source, const TimeSteps& steps, std::int64_t first_id)
    : Drop(scene, source, steps, first_id),
      moments_(steps.cut(part * std::sqrt(scene.grains.diameter / scene.gravity)), steps) {}

std::unique_ptr<Source> RainSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id) const {
  return std::make_unique<Rain>(scene, *this, steps, first_id);
}

}  // namespace repose
