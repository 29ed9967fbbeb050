// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"

namespace repose {

/// The base forces that static equilibrium allows at the places of the last state of a run; the ring and the half-width
/// of the dip index are those of `results`. Throws InputError where the method of the run is not contact dynamics.
ForceRange force_range(const Record<2>& record, const Results<2>& results);

}  // namespace repose
