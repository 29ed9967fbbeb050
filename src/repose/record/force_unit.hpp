// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// The force [M L/T^2] in which the thresholds of the analysis are given, by `analysis.force_scale`: the weight of a
/// nominal grain, the mean magnitude of the normal forces of these contacts that are not zero (0 without any), or the
/// given one. Validated by tests/unit/force_unit_test.cpp.
template <int D = 2>
double force_unit(const Scene& scene, const Contacts<D>& contacts);

/// What that unit is called in a message: "grain weights", "mean forces", or "times 2.5 M L/T^2".
std::string force_unit_name(const Scene& scene);

/// The kinetic energy [M L^2/T^2] above which a burst is counted.
double burst_threshold(const Scene& scene, double force_unit);

}  // namespace repose
