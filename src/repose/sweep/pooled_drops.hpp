// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/tail_fit.hpp"
#include "repose/sweep/plan.hpp"
#include "repose/sweep/table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace repose {

/// The drops of all slips of the finished members of a point, put together: what one member has too few of may decide
/// for all. Drops of different seeds are independent.
struct PooledDrops {
  std::string point;
  std::size_t members = 0;  ///< that have slips
  TailFit fit;
};

/// A point without slips is left out. Validated by tests/unit/pooled_drops_test.cpp.
std::vector<PooledDrops> pool_drops(const SweepPlan& plan, const SweepTable& table);

/// drops.csv: a row per point.
std::string drops_csv(const std::vector<PooledDrops>& pooled);

}  // namespace repose
