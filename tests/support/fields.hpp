// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"

#include <numeric>
#include <vector>

namespace repose {

inline double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

inline std::vector<bool> all_of(const Grains<2>& grains) { return std::vector<bool>(grains.size(), true); }

/// Flags of the grains that are not fixed.
inline std::vector<bool> moving(const Grains<2>& grains) {
  std::vector<bool> flags;
  for (const auto& grain : grains.line) flags.push_back(!grain.fixed());
  return flags;
}

}  // namespace repose
