// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/inference.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace repose {

/// The number of resamples of every bootstrap.
inline constexpr std::size_t resamples = 9999;

/// A statistic of one or more independent samples as a function of the weights of their members, those of the first
/// sample first: how many times a resample has each member. NaN where it is not defined.
struct Resampled {
  std::vector<std::size_t> sizes;  ///< members of each sample
  std::function<double(const std::vector<double>& weights)> statistic;
};

/// What samples tell about a statistic, by the bootstrap: members are drawn again with replacement, `resamples` times.
/// The draws are a function of sizes alone, so that the result is the same everywhere.
///
/// Error and bias are those of the resamples, multiplied such that the error of a mean is s/sqrt(n). Interval and
/// p-values are bias corrected and accelerated (BCa; Efron 1987, J. Am. Stat. Assoc. 82, 171), at levels of Student's t
/// instead of the normal distribution (Hesterberg 2015, Am. Stat. 69, 371), because a bootstrap interval of few
/// members is too narrow otherwise. Beyond the ten outermost resamples their distribution is taken as normal. All but
/// the value are NaN if a sample has fewer than two members or more than 1 % of the resamples have no value.
/// Validated by tests/unit/bootstrap_test.cpp.
Inference bootstrap(const Resampled& samples, const std::string& test);

}  // namespace repose
