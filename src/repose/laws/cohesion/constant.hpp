// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/parameters.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>

namespace repose {

/// A constant attraction between touching grains (overlap > 0): the simplest cohesion. Separating two grains takes a
/// pull of that force. Validated by tests/unit/laws_test.cpp (energy) and tests/cli/test_materials.py (pull-off).
struct ConstantCohesion {
  double force = 0.0;  ///< [M L/T^2] >= 0

  static constexpr std::string_view name = "constant";
};

inline void parameters(ConstantCohesion& law, Parameters& to, const LawScales&) {
  to.number("force", law.force, required, not_negative, "M L/T^2", "attraction between touching grains");
}

template <class T>
REPOSE_FN T attraction(const ConstantCohesion& law, const Touch<T>& touch) {
  return choose(touch.overlap > T(0.0), T(law.force), T(0.0));
}

inline double cohesion_energy(const ConstantCohesion& law, const Touch<double>& touch) {
  return -law.force * positive_part(touch.overlap);
}

}  // namespace repose
