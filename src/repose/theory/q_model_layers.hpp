// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/q_model.hpp"

#include <functional>
#include <vector>

namespace repose::theory {

/// Weights (width) of a run of the model, shown layer by layer from layer 0. A pure function of the model and the
/// number of the run: no two fractions anywhere share a random number.
void each_layer(const QModel& model, std::int64_t run,
                const std::function<void(std::int64_t layer, const std::vector<double>& weights)>& show);

}  // namespace repose::theory
