// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/results/analysis_group.hpp"
#include "repose/results/measure.hpp"

#include <vector>

namespace repose {

/// All that a run is measured by: keys of summary.json and groups of analysis.h5, in their order.
struct Registry {
  std::vector<Measure> measures;
  std::vector<AnalysisGroup> groups;
};

/// The measures of one subject; subjects.cpp lists those of Repose.
using Subject = void (*)(Registry& to);
std::vector<Subject> subjects();

/// Adds a subject to those of Repose. Call this before a run is analysed. Throws std::invalid_argument where a measure
/// has a name that is taken.
void register_subject(Subject subject);

const std::vector<Measure>& measures();
const std::vector<AnalysisGroup>& analysis_groups();

/// The measure of a number of summary.json by its dotted name, such as "packing.solid_fraction.mean"; null if none.
const Measure* find_measure(const std::string& name);

}  // namespace repose
