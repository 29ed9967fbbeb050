// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/table.hpp"

#include <cstddef>

namespace repose {

/// What the finished members of a point tell about a measure of the table: by Student's t, or by the bootstrap for a
/// measure of their mean profile. Members that lack the measure are left out.
Inference infer(const SweepTable& table, std::size_t measure, std::size_t point);

/// What the finished members of two points tell about the difference of a measure, first less second. Paired where two
/// seeds or more have it in both points: what a seed changes in both alike then drops out, and seeds with it in one
/// point alone are left out. Unpaired otherwise.
Inference infer_difference(const SweepTable& table, std::size_t measure, std::size_t first, std::size_t second);

}  // namespace repose
