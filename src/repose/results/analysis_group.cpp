// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/analysis_group.hpp"

namespace repose {

AnalysisGroup analysis_group(const Group<Measured>& group, std::function<bool(const Measured&)> exists) {
  return analysis_group<Measured>(group, [exists = std::move(exists)](const Measured& run) -> const Measured* {
    return exists(run) ? &run : nullptr;
  });
}

}  // namespace repose
