// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/reference_table.hpp"

#include <vector>

namespace repose {

/// The table of docs/reference/summary.md, and those of docs/reference/analysis.md.
std::vector<ReferenceTable> summary_reference();
std::vector<ReferenceTable> analysis_reference();

}  // namespace repose
