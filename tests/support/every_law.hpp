// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <variant>
#include <vector>

namespace repose::testing {

/// These laws, and each other law of the registry with its defaults.
template <class Law, std::size_t... K>
std::vector<Law> and_all_others(std::vector<Law> laws, std::index_sequence<K...>) {
  const auto listed = [&](std::size_t k) {
    return std::any_of(laws.begin(), laws.end(), [&](const auto& law) { return law.index() == k; });
  };
  (void)std::initializer_list<bool>{(!listed(K) && (laws.emplace_back(std::in_place_index<K>), true))...};
  return laws;
}
template <class Law>
std::vector<Law> and_all_others(std::vector<Law> laws) {
  return and_all_others(std::move(laws), std::make_index_sequence<std::variant_size_v<Law>>());
}

/// Every law of the registry; those that are named have parameters that try them harder than their defaults.
inline std::vector<NormalLaw> every_normal_law() {
  return and_all_others<NormalLaw>(
      {Continuous::make(36, 1.2, 0.5, 1.0), Hooke{2e4, 0.3}, Hertz{1e5, 0.3}, ElasticHertz{1.5e5, 0.3}});
}
inline std::vector<TangentialLaw> every_tangential_law() {
  return and_all_others<TangentialLaw>({Cumulative{0.5, 1.214}, Linear{0.5, 6e3, 0.1}, Mindlin{0.5, 0.8, 0.1},
                                        Viscous{0.5, 20.0}, Weakening{0.5, 6e3, 0.1, 0.2, 0.1}});
}
inline std::vector<RollingLaw> every_rolling_law() {
  return and_all_others<RollingLaw>(
      {FreeRolling{}, RollingSpring{0.1, 500.0, 0.3}, RollingViscous{0.1, 5.0}, RollingConstant{0.1, 0.3}});
}
inline std::vector<CohesionLaw> every_cohesion_law() {
  return and_all_others<CohesionLaw>({NoCohesion{}, ConstantCohesion{0.4}, Jkr{0.2, 1.5e5}});
}

/// In 3D alone.
inline std::vector<TwistingLaw> every_twisting_law() {
  return and_all_others<TwistingLaw>(
      {NoTwisting{}, TwistingSpring{{0.05, 500.0, 0.3}}, TwistingViscous{{0.05, 5.0}}, TwistingConstant{{0.05, 0.3}}});
}

/// Calls `use` with every normal and tangential law, without rolling resistance and cohesion.
template <class Use>
void for_every_pair_law(Use&& use) {
  for (const auto& normal : every_normal_law()) {
    for (const auto& tangential : every_tangential_law()) use(any_pair_law({normal, tangential, {}, {}}));
  }
}

/// Calls `use` with every combination of laws. Each law of rolling goes with the law of twisting of its kind.
template <class Use>
void for_all_laws(Use&& use) {
  const auto every_rolling = every_rolling_law();
  const auto every_twisting = every_twisting_law();
  for (const auto& normal : every_normal_law()) {
    for (const auto& tangential : every_tangential_law()) {
      for (std::size_t k = 0; k < every_rolling.size(); ++k) {
        const auto& twisting = every_twisting[k % every_twisting.size()];
        for (const auto& cohesion : every_cohesion_law()) {
          use(any_pair_law({normal, tangential, every_rolling[k], cohesion, twisting}));
        }
      }
    }
  }
}

}  // namespace repose::testing
