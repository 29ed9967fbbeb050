// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/parameters.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>

namespace repose {

/// Dry grains: no attraction.
struct NoCohesion {
  static constexpr std::string_view name = "none";
};

inline void parameters(NoCohesion&, Parameters&, const LawScales&) {}

/// Attraction [M L/T^2] between touching grains, >= 0.
REPOSE_FN double attraction(const NoCohesion&, const Touch<double>&) { return 0.0; }

/// Potential energy [M L^2/T^2] of the attraction, <= 0.
inline double cohesion_energy(const NoCohesion&, const Touch<double>&) { return 0.0; }

}  // namespace repose
