// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/further_analysis.hpp"

#include "repose/core/errors.hpp"
#include "repose/determinacy/force_range.hpp"
#include "repose/slips/slips.hpp"
#include "repose/stability/stability.hpp"

namespace repose {

Results<2> analyse(const Record<2>& record, const FurtherAnalysis& further) {
  auto results = analyse(record);
  if (further.force_range) results.force_range = force_range(record, results);
  if (further.stability) results.stability = stability(record);
  if (further.slips || record.scene.analysis.slips) results.slips = slips(record);
  return results;
}

Results<3> analyse(const Record<3>& record, const FurtherAnalysis& further) {
  if (further.force_range || further.stability || further.slips) {
    throw InputError("force range, stability and slips are measured in two dimensions alone");
  }
  return analyse(record);
}

}  // namespace repose
