// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"

#include <string>
#include <vector>

namespace repose {

/// What makes the results of a run doubtful, a line each: deep overlaps, an energy budget that does not close, steps
/// that did not converge, grains behind a wall, no grain left. Validated by tests/cli/test_warnings.py.
template <int D>
std::vector<std::string> warnings_of(const Record<D>& record);

}  // namespace repose
