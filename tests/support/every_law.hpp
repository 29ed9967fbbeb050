// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"

#include <vector>

namespace repose::testing {

/// Every law of the registry, with usual parameters. The check below does not compile if a registered law is missing
/// here.
inline std::vector<NormalLaw> every_normal_law() {
  return {Continuous::make(36, 1.2, 0.5, 1.0), Hooke{2e4, 0.3}, Hertz{1e5, 0.3}};
}
inline std::vector<TangentialLaw> every_tangential_law() {
  return {Cumulative{0.5, 1.214}, Linear{0.5, 6e3, 0.1}, Mindlin{0.5, 0.8, 0.1}, Viscous{0.5, 20.0}, None{}};
}
inline std::vector<RollingLaw> every_rolling_law() { return {FreeRolling{}, RollingSpring{0.1, 500.0, 0.3}}; }
inline std::vector<CohesionLaw> every_cohesion_law() { return {NoCohesion{}, ConstantCohesion{0.4}}; }
static_assert(std::variant_size_v<NormalLaw> == 3 && std::variant_size_v<TangentialLaw> == 5 &&
                  std::variant_size_v<RollingLaw> == 2 && std::variant_size_v<CohesionLaw> == 2,
              "add the new law to the lists above");

/// Calls `use` with every normal and tangential law, without rolling resistance and cohesion.
template <class Use>
void for_every_pair_law(Use&& use) {
  for (const auto& normal : every_normal_law()) {
    for (const auto& tangential : every_tangential_law()) use(any_pair_law({normal, tangential, {}, {}}));
  }
}

/// Calls `use` with every combination of laws.
template <class Use>
void for_all_laws(Use&& use) {
  for (const auto& normal : every_normal_law()) {
    for (const auto& tangential : every_tangential_law()) {
      for (const auto& rolling : every_rolling_law()) {
        for (const auto& cohesion : every_cohesion_law()) use(any_pair_law({normal, tangential, rolling, cohesion}));
      }
    }
  }
}

}  // namespace repose::testing
