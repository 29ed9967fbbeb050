// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/groups.hpp"
#include "repose/record/record.hpp"
#include "repose/results/results.hpp"

#include <string>
#include <vector>

namespace repose {

/// A number of the grains as analysis.h5 has it.
struct MeasureRow {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::string meaning;
};

/// The group of all numbers.
const Group<std::vector<MeasureRow>>& measure_group();

/// Writes analysis.h5: the group of all numbers, and every group of the registry that has a meaning for the run. The
/// layout is described in docs/reference/analysis.md. Throws RunError.
template <int D>
void write_analysis(const std::string& path, const Record<D>& record, const Results<D>& results);

}  // namespace repose
