// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/columns.hpp"
#include "repose/results/column.hpp"

#include <vector>

namespace repose {

/// The datasets of `column` in analysis.h5.
const Columns<std::vector<ColumnLayer>>& column_layers();

}  // namespace repose
