// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/base_force.hpp"

#include <utility>

namespace repose::theory {

Table base_table(std::int64_t points, const std::string& unit, const std::function<BaseForce(double)>& force) {
  Column x{"x_over_b", "1", "position along the base, from the left foot", {}, {}};
  Column normal{"normal", unit, "downward force on the ground per length", {}, {}};
  Column shear{"shear", unit, "force on the ground to the right per length", {}, {}};
  for (std::int64_t i = 0; i < points; ++i) {
    x.values.push_back(static_cast<double>(i) / static_cast<double>(points - 1));
    const auto at_x = force(x.values.back());
    normal.values.push_back(at_x.normal);
    shear.values.push_back(at_x.shear);
  }
  return {{std::move(x), std::move(normal), std::move(shear)}, {}};
}

}  // namespace repose::theory
