// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/sweep/ensemble_column.hpp"
#include "repose/sweep/ensemble_estimate.hpp"
#include "repose/sweep/ensemble_profile.hpp"
#include "repose/sweep/height_fit.hpp"
#include "repose/sweep/plan.hpp"
#include "repose/sweep/verdict.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// One member in the table.
struct MemberRow {
  std::size_t point = 0;
  std::int64_t seed = 0;
  std::string status;                    ///< in its summary; "" without one
  std::vector<double> values;            ///< by measure; NaN where undefined, and for members that have not finished
  BaseProfile base;                      ///< empty unless finished
  std::vector<ColumnLayer> column = {};  ///< empty without
  std::vector<double> drops = {};        ///< [M L/T^2] of the force in slips; empty without
};

/// The results of a sweep so far.
struct SweepTable {
  std::vector<std::string> measures;                   ///< dotted names of summary.json, then those of profile_measures
  std::vector<MemberRow> members;                      ///< in the order of the sweep
  std::vector<std::vector<EnsembleEstimate>> entries;  ///< by point and measure
  std::vector<std::size_t> finished, failed;           ///< members by point
  std::vector<std::optional<EnsembleProfile>> profiles;  ///< by point; none where no base, or bases that differ
  std::vector<std::optional<EnsembleColumn>> columns;    ///< by point; none where no two walls face each other
  std::vector<HeightFit> fits;                           ///< by fit of the plan
  std::vector<Verdict> verdicts;                         ///< by claim of the plan

  /// The number of the measures that a member has by itself; those of mean profiles follow.
  std::size_t own_measures() const { return measures.size() - profile_measure_count; }
};

/// The numbers of a summary that measure the grains (not the run, such as its wall time): dotted name and value, NaN
/// for null. Throws InputError unless the text is a summary.
std::vector<std::pair<std::string, double>> measures_of(const std::string& summary, const std::string& name);

/// Means and errors by point, ensemble profiles and verdicts from the members (whose values are by `measures`).
SweepTable make_table(const SweepPlan& plan, std::vector<std::string> measures, std::vector<MemberRow> members);

/// The tables as CSV: one row per point; one row per member.
std::string table_csv(const SweepPlan& plan, const SweepTable& table);
std::string members_csv(const SweepPlan& plan, const SweepTable& table);

/// Writes sweep.h5; see docs/reference/sweep.md. Throws RunError.
void write_sweep_file(const std::string& path, const SweepPlan& plan, const SweepTable& table);

}  // namespace repose
