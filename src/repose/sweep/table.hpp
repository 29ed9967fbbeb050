// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/sweep/plan.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// One member in the table.
struct MemberRow {
  std::size_t point = 0;
  std::int64_t seed = 0;
  std::string status;          ///< in its summary; "" without one
  std::vector<double> values;  ///< by measure; NaN where undefined, and for members that have not finished
  BaseProfile base;            ///< empty unless finished
};

/// The base profile of an ensemble: means over the finished members, with standard errors from their scatter.
struct EnsembleProfile {
  std::size_t members = 0;
  BaseProfile mean;  ///< per base grain
  std::vector<double> normal_error, shear_error;
  BinnedProfile binned;  ///< errors between members
  Estimate dip_index;    ///< of the mean profile; error by the jackknife
  Estimate max_over_centre;
  double centre = 0.0, half_width = 0.0;  ///< [L] of the loaded interval of the mean profile; NaN without one
};

/// The verdict on a claim by the rule of `Claim`.
struct Verdict {
  std::string word;  ///< "agrees", "disagrees" or "undecided"; "no data" where a mean or its error is not defined
  double value = 0.0;
  double error = 0.0;  ///< standard error
};

/// The results of a sweep so far.
struct SweepTable {
  std::vector<std::string> measures;           ///< dotted names of summary.json, then profile.dip_index and the like
  std::vector<MemberRow> members;              ///< in the order of the sweep
  std::vector<std::vector<Estimate>> entries;  ///< by point and measure
  std::vector<std::size_t> finished, failed;   ///< members by point
  std::vector<std::optional<EnsembleProfile>> profiles;  ///< by point; none where no base, or bases that differ
  std::vector<Verdict> verdicts;                         ///< by claim of the plan
};

/// The numbers of a summary that measure the grains (not the run, such as its wall time): dotted name and value, NaN
/// for null. Throws InputError unless the text is a summary.
std::vector<std::pair<std::string, double>> measures_of(const std::string& summary, const std::string& name);

/// The ensemble profile of some members; none where they have no base, or bases that differ.
std::optional<EnsembleProfile> ensemble_profile(const std::vector<const BaseProfile*>& members, double bin_width);

/// What the finished entries of a table decide about a claim, by the rule of `Claim`.
Verdict verdict_of(const Claim& claim, const SweepPlan& plan, const SweepTable& table);

/// Means and errors by point, ensemble profiles and verdicts from the members (whose values are by `measures`).
SweepTable make_table(const SweepPlan& plan, std::vector<std::string> measures, std::vector<MemberRow> members);

/// The tables as CSV: one row per point; one row per member; one row per claim.
std::string table_csv(const SweepPlan& plan, const SweepTable& table);
std::string members_csv(const SweepPlan& plan, const SweepTable& table);
std::string claims_csv(const SweepPlan& plan, const SweepTable& table);

/// Writes sweep.h5; see docs/reference/sweep.md. Throws RunError.
void write_sweep_file(const std::string& path, const SweepPlan& plan, const SweepTable& table);

}  // namespace repose
