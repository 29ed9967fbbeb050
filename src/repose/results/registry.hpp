// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/results/analysis_group.hpp"
#include "repose/results/measure.hpp"

#include <vector>

namespace repose {

/// All that a run is measured by: keys of summary.json and groups of analysis.h5, in their order.
template <int D>
struct RegistryIn {
  std::vector<MeasureIn<D>> measures;
  std::vector<AnalysisGroupIn<D>> groups;
};
using Registry = RegistryIn<2>;

/// The measures of one subject; subjects.cpp lists those of Repose.
template <int D>
using SubjectIn = void (*)(RegistryIn<D>& to);
using Subject = SubjectIn<2>;
template <int D>
std::vector<SubjectIn<D>> subjects();
template <>
std::vector<SubjectIn<2>> subjects<2>();
template <>
std::vector<SubjectIn<3>> subjects<3>();

/// Adds a subject in two dimensions to those of Repose. Call this before a run is analysed. Throws
/// std::invalid_argument where a measure has a name that is taken.
void register_subject(Subject subject);

template <int D = 2>
const std::vector<MeasureIn<D>>& measures();
template <int D = 2>
const std::vector<AnalysisGroupIn<D>>& analysis_groups();

/// The measure of a number of summary.json by its dotted name, such as "packing.solid_fraction.mean", in two dimensions
/// or else in three; null if none.
const KnownMeasure* find_measure(const std::string& name);

}  // namespace repose
