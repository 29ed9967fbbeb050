// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/slips.hpp"

#include <vector>

namespace repose {

/// Falls of the force from a local maximum to the next minimum, where it turns by at least `hysteresis` [M L/T^2].
std::vector<Slip> find_slips(const std::vector<DriveRow>& path, double hysteresis);

/// The slips of the first wall that is driven by a spring or at a speed, from the rows of the time series.
Slips slips(const Record<2>& record);

}  // namespace repose
