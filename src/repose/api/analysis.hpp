// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose::api {

/// A number that the analysis finds, by its name in docs/reference/summary.md.
struct Measure {
  std::string name;    ///< dotted, for example "angle_of_repose_deg.mean"
  double value = 0.0;  ///< NaN where it is not defined
};

/// Analyses a run folder again, as `repose analyse` does: writes its analysis.h5 and summary.json and returns the
/// measures. The run itself stays as it is. Throws InputError, RunError.
std::vector<Measure> analyse(const std::string& folder);

/// The measures in the summary.json of a run folder. Throws InputError.
std::vector<Measure> measures(const std::string& folder);

/// The value of a measure. Throws InputError with the known names where there is no such measure.
double value_of(const std::vector<Measure>& measures, const std::string& name);

}  // namespace repose::api
