// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/columns.hpp"
#include "repose/results/column.hpp"

#include <vector>

namespace repose {

/// The datasets of `column` in analysis.h5. Names and order are the same in both dimensions, units are not.
template <int D>
const Columns<std::vector<ColumnLayer>>& column_layers();
template <>
const Columns<std::vector<ColumnLayer>>& column_layers<2>();
template <>
const Columns<std::vector<ColumnLayer>>& column_layers<3>();

}  // namespace repose
