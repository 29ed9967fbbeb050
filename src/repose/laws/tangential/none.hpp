// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/parameters.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>

namespace repose {

/// No tangential force: smooth grains.
struct None {
  static constexpr std::string_view name = "none";
};

inline void parameters(None&, Parameters&, const LawScales&) {}

inline double surface_stiffness(const None&, double, double) { return 0.0; }

template <class Tangential>
REPOSE_FN Tangential tangential_force(const None&, const Touch<double>&, const NormalForce<double>&, const Tangential&,
                                      double, Tangential&) {
  return Tangential{};
}

template <class Tangential>
REPOSE_FN Tangential displaced(const None&, const Touch<double>&, const Tangential&, double,
                               const Tangential& unmoved) {
  return unmoved;
}

REPOSE_FN double coulomb_limit(const None&, const NormalForce<double>&) { return 0.0; }

template <class Tangential>
double stored_energy(const None&, const Touch<double>&, const NormalForce<double>&, const Tangential&) {
  return 0.0;
}

}  // namespace repose
