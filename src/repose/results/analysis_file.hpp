// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"

#include <string>

namespace repose {

/// Writes analysis.h5; the layout is described in docs/reference/analysis.md. Throws RunError.
void write_analysis(const std::string& path, const Record& record, const Results& results);

}  // namespace repose
