// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/cohesion/none.hpp"
#include "repose/laws/rolling/free.hpp"
#include "repose/laws/twisting/twisting.hpp"

#include <type_traits>

namespace repose {

/// The laws that act together in one contact. Each combination of types compiles to one kernel.
template <class Normal, class Tangential, class Rolling = FreeRolling, class Cohesion = NoCohesion,
          class Twisting = NoTwisting>
struct PairLaw {
  Normal normal{};
  Tangential tangential{};
  Rolling rolling{};
  Cohesion cohesion{};
  Twisting twisting{};

  /// Whether contacts resist rolling. If so, each keeps a rolling displacement beside its slip displacement.
  static constexpr bool rolls = !std::is_same_v<Rolling, FreeRolling>;
  /// Whether contacts of spheres resist twisting.
  static constexpr bool twists = !std::is_same_v<Twisting, NoTwisting>;
  /// Whether contacts attract each other, and may then be bonded beyond the reach of the normal law.
  static constexpr bool coheres = !std::is_same_v<Cohesion, NoCohesion>;
};
template <class Normal, class Tangential>
PairLaw(Normal, Tangential) -> PairLaw<Normal, Tangential>;

}  // namespace repose
