// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"

#include <string>
#include <vector>

namespace repose {

/// A moment of a run and its time [T].
struct FrameTime {
  std::string key;
  double time = 0.0;
};

/// [L] around the grains of all moments.
struct RunBox {
  Vec<2> low{}, high{};
};

/// What a run is, as JSON: `api/run` of docs/reference/view.md.
std::string describe_run(const std::string& folder, const Record<2>& run, const std::vector<FrameTime>& frames,
                         const RunBox& box);

}  // namespace repose
