// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/table.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace repose::theory {

/// Force of a pile on the ground per length of base: `normal` downward, `shear` to the right, in the model's unit.
struct BaseForce {
  double normal = 0.0;
  double shear = 0.0;
};

/// A table with the columns x_over_b (`points` positions from 0 to 1, both included), normal and shear, in `unit`.
Table base_table(std::int64_t points, const std::string& unit, const std::function<BaseForce(double x_over_b)>& force);

}  // namespace repose::theory
