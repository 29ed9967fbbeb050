// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/cohesion/constant.hpp"
#include "repose/laws/cohesion/jkr.hpp"
#include "repose/laws/cohesion/none.hpp"
#include "repose/laws/normal/continuous.hpp"
#include "repose/laws/normal/elastic_hertz.hpp"
#include "repose/laws/normal/hertz.hpp"
#include "repose/laws/normal/hooke.hpp"
#include "repose/laws/pair_law.hpp"
#include "repose/laws/rolling/constant.hpp"
#include "repose/laws/rolling/free.hpp"
#include "repose/laws/rolling/spring.hpp"
#include "repose/laws/rolling/viscous.hpp"
#include "repose/laws/tangential/cumulative.hpp"
#include "repose/laws/tangential/linear.hpp"
#include "repose/laws/tangential/mindlin.hpp"
#include "repose/laws/tangential/none.hpp"
#include "repose/laws/tangential/viscous.hpp"
#include "repose/laws/tangential/weakening.hpp"
#include "repose/laws/twisting/twisting.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace repose {

/// Every law, by kind. A new law needs its header and one entry here.
using NormalLaw = std::variant<Continuous, Hooke, Hertz, ElasticHertz>;
using TangentialLaw = std::variant<Cumulative, Linear, Mindlin, Viscous, None, Weakening>;
using RollingLaw = std::variant<FreeRolling, RollingSpring, RollingViscous, RollingConstant>;
using CohesionLaw = std::variant<NoCohesion, ConstantCohesion, Jkr>;
using TwistingLaw = std::variant<NoTwisting, TwistingSpring, TwistingViscous, TwistingConstant>;  ///< of spheres

/// The laws of a pair of materials, chosen at run time.
struct ContactLaws {
  NormalLaw normal;
  TangentialLaw tangential;
  RollingLaw rolling;
  CohesionLaw cohesion;
  TwistingLaw twisting{};
};

/// The laws of every pair of materials: a symmetric table with the entry of a and b at a * materials + b.
struct MaterialLaws {
  std::size_t materials = 1;
  std::vector<ContactLaws> table;
};

}  // namespace repose
