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
template <class T>
REPOSE_FN T attraction(const NoCohesion&, const Touch<T>&) {
  return T(0.0);
}

/// Potential energy [M L^2/T^2] of the attraction, <= 0.
inline double cohesion_energy(const NoCohesion&, const Touch<double>&) { return 0.0; }

// A law whose attraction depends on the past of the contact has functions of its own instead of these: `bonded` is what
// a contact keeps of it.

template <class Law, class T>
REPOSE_FN T attraction(const Law& law, const Touch<T>& touch, bool& /*bonded*/) {
  return attraction(law, touch);
}

template <class Law>
double cohesion_energy(const Law& law, const Touch<double>& touch, bool /*bonded*/) {
  return cohesion_energy(law, touch);
}

/// Energy [M L^2/T^2] that is lost where a bond ends.
template <class Law>
double energy_of_break(const Law&, const Touch<double>&) {
  return 0.0;
}

/// The distance, in diameters of the smallest grain, up to which bonds last; 0 without bonds.
template <class Law>
double reach_of_bonds(const Law&, double /*smallest_diameter*/) {
  return 0.0;
}

}  // namespace repose
