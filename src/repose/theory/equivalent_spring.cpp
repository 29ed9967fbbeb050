// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/equivalent_spring.hpp"

#include <algorithm>
#include <cmath>

namespace repose::theory {

namespace {

double work(const EquivalentSpring& contact) {
  const double n = contact.exponent;
  return (std::pow(contact.closest, -n) - std::pow(contact.cutoff, -n)) / n;
}

}  // namespace

double equivalent_stiffness(const EquivalentSpring& contact) {
  const double overlap = 1.0 - contact.closest;
  return 2.0 * work(contact) / (overlap * overlap);
}

void parameters(EquivalentSpring& contact, Parameters& to) {
  to.number("exponent", contact.exponent, {.low = 1.0, .high = 1000.0}, "1", "n of the force m g (d/r)^(n+1)");
  to.number("cutoff", contact.cutoff, {.low = 1.0, .high = 10.0}, "d", "distance r0 at which the force begins");
  to.number("closest", contact.closest, {.low = 0.5, .high = 1.0, .high_allowed = false}, "d",
            "closest approach r_i of the grains");
  to.integer("points", contact.points, {.low = 2, .high = 1'000'000}, "distances, from r_i to r0");
}

Table evaluate(const EquivalentSpring& contact) {
  const double stiffness = equivalent_stiffness(contact);
  Table table{{{"distance", "d", "between the centres, r", {}, {}},
               {"continuous", "m g", "force of the continuous interaction", {}, {}},
               {"spring", "m g", "force of the spring of equal work", {}, {}}},
              {{"stiffness", stiffness, "m g/d", "of the spring, k"},
               {"work", work(contact), "m g d", "of either force up to the closest approach"}}};
  for (std::int64_t k = 0; k < contact.points; ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(contact.points - 1);
    const double r = contact.closest + (contact.cutoff - contact.closest) * fraction;
    table.columns[0].values.push_back(r);
    table.columns[1].values.push_back(std::pow(r, -(contact.exponent + 1.0)));
    table.columns[2].values.push_back(stiffness * std::max(0.0, 1.0 - r));
  }
  return table;
}

}  // namespace repose::theory
