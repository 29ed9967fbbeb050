// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

#include <vector>

namespace repose::testing {

/// One law of each kind in the registry, with usual parameters; a law that is registered but missing here fails
/// to compile the check below.
inline std::vector<NormalLaw> every_normal_law() { return {Continuous::make(36, 1.2, 0.5, 1.0), Hooke{2e4, 0.3}}; }
inline std::vector<TangentialLaw> every_tangential_law() {
  return {Cumulative{0.5, 1.214}, Linear{0.5, 6e3, 0.1}, None{}};
}
static_assert(std::variant_size_v<NormalLaw> == 2 && std::variant_size_v<TangentialLaw> == 3,
              "add the new law to the lists above");

template <class Use>
void for_every_pair_law(Use&& use) {
  for (const auto& normal : every_normal_law()) {
    for (const auto& tangential : every_tangential_law()) with_pair_law(normal, tangential, use);
  }
}

}  // namespace repose::testing
