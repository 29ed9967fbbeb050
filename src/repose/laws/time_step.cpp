// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

StiffestContact stiffest_contact(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner,
                                 double gravity, double fall) {
  const double m = mover.mass;
  const double pair_mass = 2.0 * m * partner.mass / (m + partner.mass);
  const double diameter = 0.5 * (mover.diameter + partner.diameter);
  const double normal = std::visit(
      [&](const auto& law) { return stiffness_at(law, pair_mass, diameter, m * gravity * fall); }, laws.normal);
  const auto at_surface = [&](const auto& law) { return surface_stiffness(law, normal, m); };
  const double stiffest =
      std::max({normal, std::visit(at_surface, laws.tangential), std::visit(at_surface, laws.rolling)});
  return {std::sqrt(stiffest / m)};
}

}  // namespace repose
