// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/stability.hpp"

namespace repose {

/// The smallest eigenvalue of the stiffness matrix of the last state of a run, and its mode: docs/physics/stability.md.
Stability stability(const Record<2>& record);

}  // namespace repose
