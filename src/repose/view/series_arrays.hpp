// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"

#include <string>

namespace repose {

/// The time series of a run as arrays: `api/series` of docs/reference/view.md.
std::string series_arrays(const Record<2>& run);

}  // namespace repose
