// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/rain.hpp"

#include <cmath>

namespace repose {

namespace {

constexpr double part = 0.1;  // of the time in which a grain falls by half its diameter

}  // namespace

Rain::Rain(const Scene& scene, const TimeSteps& steps, std::int64_t first_id)
    : Drop(scene, steps, first_id),
      moments_(steps.cut(part * std::sqrt(scene.grains.diameter / scene.gravity)), steps) {}

}  // namespace repose
