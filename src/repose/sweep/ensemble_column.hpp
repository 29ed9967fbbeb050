// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/results/column.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// A number of one slice over the members of an ensemble.
struct EnsembleLayer {
  Estimate depth, solid_fraction, pressure, shear, stress, load;  ///< as in ColumnLayer
};

/// The column of an ensemble, slice by slice: means over the finished members, with standard errors.
struct EnsembleColumn {
  std::size_t members = 0;
  double mass = 0.0;  ///< [M] mean of a column
  std::vector<EnsembleLayer> layers;
};

/// None where no member has a column, or where they differ in the number of slices.
std::optional<EnsembleColumn> ensemble_column(const std::vector<const std::vector<ColumnLayer>*>& members);

}  // namespace repose
