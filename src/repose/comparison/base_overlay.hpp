// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/comparison/base_comparison.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// Reads MODEL or MODEL:key=value,key=value, as on the command line. Appends each problem to `problems`, one line
/// each.
TheoryChoice read_choice(const std::string& written, std::vector<std::string>& problems);

/// All models compared with one base.
struct BaseOverlay {
  std::string point;         ///< of a sweep; "" for a run
  std::int64_t members = 1;  ///< finished runs that the profile is the mean of
  std::vector<TheoryComparison> models;
  std::string problem;  ///< why this point has no base to compare with
};

/// Compares the models with the base of a finished run, or of every point of a sweep that has a base profile, and
/// writes the results under the key "theory" of summary.json; see docs/reference/summary.md. Throws InputError with a
/// line for every problem, and then writes nothing.
std::vector<BaseOverlay> overlay_theory(const std::string& folder, const std::vector<std::string>& choices);

/// The measured base of a run folder (of a sweep folder: of one of its points). Throws InputError.
MeasuredBase measured_base(const std::string& folder);
MeasuredBase measured_base(const std::string& folder, std::size_t point);

}  // namespace repose
