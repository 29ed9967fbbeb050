// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace repose::theory {

namespace {

/// The corners of the graph, from the largest velocity of the other body to that of the first.
std::vector<std::pair<double, double>> corners(const ContactLaw& contact) {
  const double end = contact.largest_velocity;
  if (contact.law == "signorini") return {{0.0, contact.mass * end}, {0.0, 0.0}, {end, 0.0}};
  return {{-end, contact.limit}, {0.0, contact.limit}, {0.0, -contact.limit}, {end, -contact.limit}};
}

}  // namespace

ContactAnswer answer(const ContactLaw& contact) {
  const double sticking = -contact.mass * contact.free_velocity;
  const double impulse =
      contact.law == "signorini" ? std::max(sticking, 0.0) : std::clamp(sticking, -contact.limit, contact.limit);
  return {impulse == sticking ? 0.0 : contact.free_velocity + impulse / contact.mass, impulse};
}

void parameters(ContactLaw& contact, Parameters& to) {
  to.choice("law", contact.law, {"signorini", "coulomb", "rolling"},
            "impulses along the normal, of friction, of rolling friction");
  to.number("mass", contact.mass, positive, "M", "reduced mass of the contact in this direction");
  to.number("limit", contact.limit, not_negative, "M L/T", "largest impulse of coulomb and rolling");
  to.number("free_velocity", contact.free_velocity, {.low = -1e6, .high = 1e6}, "L/T",
            "formal velocity without an impulse");
  to.number("largest_velocity", contact.largest_velocity, positive, "L/T", "end of the axis");
  to.integer("points", contact.points, {.low = 8, .high = 1'000'000}, "points along the graph");
}

Table evaluate(const ContactLaw& contact) {
  const auto found = answer(contact);
  Table table{{{"velocity", "L/T", "formal velocity", {}, {}},
               {"law", "M L/T", "impulse that the law allows", {}, {}},
               {"line", "M L/T", "impulse that gives this velocity", {}, {}}},
              {{"answer_velocity", found.velocity, "L/T", "formal velocity of the answer"},
               {"answer_impulse", found.impulse, "M L/T", "impulse of the answer"}}};
  const auto corner = corners(contact);
  const auto pieces = static_cast<std::int64_t>(corner.size()) - 1;
  for (std::int64_t k = 0; k < contact.points; ++k) {
    const double along = static_cast<double>(k * pieces) / static_cast<double>(contact.points - 1);
    const auto piece = std::min<std::int64_t>(static_cast<std::int64_t>(along), pieces - 1);
    const double part = along - static_cast<double>(piece);
    const auto& [x0, y0] = corner[static_cast<std::size_t>(piece)];
    const auto& [x1, y1] = corner[static_cast<std::size_t>(piece) + 1];
    const double velocity = x0 + (x1 - x0) * part;
    table.columns[0].values.push_back(velocity);
    table.columns[1].values.push_back(y0 + (y1 - y0) * part);
    table.columns[2].values.push_back(contact.mass * (velocity - contact.free_velocity));
  }
  return table;
}

}  // namespace repose::theory
