// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/inference.hpp"

#include <cstddef>

namespace repose {

/// A measure over the finished members of a point.
struct EnsembleEstimate {
  std::size_t count = 0;    ///< members that have it
  std::size_t missing = 0;  ///< finished members that lack it
  double mean = Inference::none;
  double deviation = Inference::none;  ///< standard deviation between members; NaN for measures of the mean profile
  double error = Inference::none;      ///< standard error
  double low = Inference::none, high = Inference::none;  ///< ends of the 95 % interval
  double bias = Inference::none;                         ///< estimated, not subtracted; NaN for means, which have none
};

inline EnsembleEstimate estimate_of(const Inference& inference, double deviation, std::size_t finished) {
  return {inference.count, finished - inference.count,
          inference.value, deviation,
          inference.error, inference.low,
          inference.high,  inference.bias};
}

}  // namespace repose
