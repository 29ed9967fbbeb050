// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/rain.hpp"

#include <cmath>

namespace repose {

namespace {

constexpr double part = 0.1;  // of the time in which a grain falls by half its diameter

}  // namespace

template <int D>
Rain<D>::Rain(const Scene& scene, const DropSource& source, const TimeSteps& steps, std::int64_t first_id)
    : Drop<D>(scene, source, steps, first_id),
      moments_(steps.cut(part * std::sqrt(scene.grains.diameter / scene.gravity)), steps) {}

template class Rain<2>;
template class Rain<3>;

std::unique_ptr<Source<2>> RainSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                             Dimension<2>) const {
  return std::make_unique<Rain<2>>(scene, *this, steps, first_id);
}
std::unique_ptr<Source<3>> RainSource::start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                             Dimension<3>) const {
  return std::make_unique<Rain<3>>(scene, *this, steps, first_id);
}

}  // namespace repose
