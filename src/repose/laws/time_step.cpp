// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// Tangential stiffness felt by the surface of a grain [M/T^2], rotation included (a disc's surface is three times as
/// light as its centre); 0 where the law's own slope follows the normal stiffness and stays below it.
double surface_stiffness(const Linear& law) { return 3.0 * law.stiffness; }
double surface_stiffness(const Cumulative&) { return 0.0; }
double surface_stiffness(const None&) { return 0.0; }

}  // namespace

StiffestContact stiffest_contact(const NormalLaw& normal, const TangentialLaw& tangential, const ContactConditions& c) {
  const auto mass_of = [&](double diameter) { return c.mass * std::pow(diameter / c.diameter, 2); };
  const double tangential_stiffness = std::visit([](const auto& law) { return surface_stiffness(law); }, tangential);
  StiffestContact stiffest;
  for (const double mover : {c.smallest_diameter, c.largest_diameter}) {
    for (const double partner : {c.smallest_diameter, c.diameter, c.largest_diameter}) {
      const double m = mass_of(mover);
      const double pair_mass = 2.0 * m * mass_of(partner) / (m + mass_of(partner));
      const double energy = m * c.gravity * c.fall;
      const double stiffness = std::visit(
          [&](const auto& law) { return stiffness_at(law, pair_mass, 0.5 * (mover + partner), energy); }, normal);
      const double k = std::max(stiffness, tangential_stiffness);
      stiffest.frequency = std::max(stiffest.frequency, std::sqrt(k / m));
    }
  }
  return stiffest;
}

}  // namespace repose
