// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/parameters.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>
#include <type_traits>

namespace repose {

/// No resistance to rolling.
struct FreeRolling {
  static constexpr std::string_view name = "none";
};

inline void parameters(FreeRolling&, Parameters&, const LawScales&) {}

inline double surface_stiffness(const FreeRolling&, double, double, const Inertia&) { return 0.0; }

template <class T, class Tangential>
REPOSE_FN Tangential rolling_force(const FreeRolling&, const Touch<T>&, const NormalForce<T>&, const Tangential&,
                                   const std::type_identity_t<T>&, Tangential&) {
  return Tangential{};
}

template <class T, class Tangential>
REPOSE_FN Tangential displaced(const FreeRolling&, const Touch<T>&, const Tangential&, double,
                               const Tangential& unmoved) {
  return unmoved;
}

template <class Tangential>
double stored_energy(const FreeRolling&, const Touch<double>&, const NormalForce<double>&, const Tangential&) {
  return 0.0;
}

}  // namespace repose
