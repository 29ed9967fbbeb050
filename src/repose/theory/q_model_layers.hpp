// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/q_model.hpp"

#include <functional>
#include <vector>

namespace repose::theory {

/// Calls show(layer, weights) for every layer of a run, from layer 0; weights has `width` entries. The weights are a
/// pure function of the model and the number of the run. No two fractions use the same random number.
void each_layer(const QModel& model, std::int64_t run,
                const std::function<void(std::int64_t layer, const std::vector<double>& weights)>& show);

}  // namespace repose::theory
