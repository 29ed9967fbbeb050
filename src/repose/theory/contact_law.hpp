// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>

namespace repose::theory {

/// The graph of a law of contact dynamics, impulse against formal velocity, and the line of what the impulse does to
/// the velocity: impulse = mass (velocity - free velocity). Where they cross lies the answer of the contact. Source:
/// Bratberg's thesis (2003), eqs (74), (84), (89) as corrected, Figs. 13-15. Signs: a positive normal velocity
/// separates, an impulse pushes the first body along the axis of its velocity.
/// Validated by tests/theory/contact_law_test.cpp.
struct ContactLaw {
  std::string law = "coulomb";    ///< signorini, coulomb or rolling
  double mass = 1.0;              ///< reduced mass, or moment of inertia over the squared radius
  double limit = 1.0;             ///< largest impulse of coulomb or rolling: friction times the normal impulse
  double free_velocity = -0.5;    ///< formal velocity without an impulse
  double largest_velocity = 3.0;  ///< end of the axis
  std::int64_t points = 201;

  static constexpr ModelText text{.name = "contact-law",
                                  .about = "Impulse against formal velocity of a contact that is not smooth",
                                  .source = "Bratberg 2003 (thesis), eqs (74), (84), (89), Figs. 13-15, corrected"};
};

/// Formal velocity and impulse where law and line cross.
struct ContactAnswer {
  double velocity = 0.0;
  double impulse = 0.0;
};
ContactAnswer answer(const ContactLaw& contact);

void parameters(ContactLaw& contact, Parameters& to);

/// The graph of the law as a line through points, and the line of the impulse at the same velocities.
Table evaluate(const ContactLaw& contact);

}  // namespace repose::theory
