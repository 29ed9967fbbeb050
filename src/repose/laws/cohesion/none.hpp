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

/// Attraction [M L/T^2] >= 0 between touching grains.
REPOSE_FN double attraction(const NoCohesion&, const Touch<double>&) { return 0.0; }

/// Energy [M L^2/T^2] <= 0 of that attraction.
inline double cohesion_energy(const NoCohesion&, const Touch<double>&) { return 0.0; }

}  // namespace repose
