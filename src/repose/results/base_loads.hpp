// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_rings.hpp"
#include "repose/record/record.hpp"

#include <optional>
#include <vector>

namespace repose {

/// What a run of spheres presses on its base with.
struct BaseLoads {
  std::vector<BaseLoad> loads;
  std::optional<double> area_of_load;  ///< [L^2] of the base that belongs to each, where all have the same
};

/// The forces on base grains, one load for each, mean over output.window. Without base grains those on the floor, one
/// for each contact, at the time of the record. The floor is the plane of the base; in a scene without a base it is all
/// level walls at one height, that height at which they carry most. Empty where there is neither.
/// Validated by tests/unit/base_loads_test.cpp.
BaseLoads base_loads(const Record<3>& record);

}  // namespace repose
