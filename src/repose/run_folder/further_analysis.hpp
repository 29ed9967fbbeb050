// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/results/sphere_results.hpp"

namespace repose {

/// What an analysis can be asked for that takes longer than all the rest of it.
struct FurtherAnalysis {
  bool force_range = false;  ///< determinacy/force_range.hpp
  bool stability = false;    ///< stability/stability.hpp
  bool slips = false;        ///< slips/slips.hpp
};

/// The analysis of a record, with that and with what its scene asks for. Throws InputError where the record has no
/// force range.
Results<2> analyse(const Record<2>& record, const FurtherAnalysis& further);
/// Throws InputError where that is asked for: it is for discs.
Results<3> analyse(const Record<3>& record, const FurtherAnalysis& further);

}  // namespace repose
