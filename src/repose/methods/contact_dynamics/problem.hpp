// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/impulse_law.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::contact_dynamics {

/// What a sweep touches of a grain or a wall.
template <int D>
struct alignas(D == 2 ? 32 : 64) Body {
  Vec<D> velocity{};          ///< [L/T]
  Spin<D> rim_velocity{};     ///< [L/T] angular velocity times radius
  double inverse_mass = 0.0;  ///< [1/M] 0: whatever pushes it
};
static_assert(sizeof(Body<2>) == 32);

/// What a contact hands over in a step, to its first body; the second gets the opposite.
template <int D>
struct Impulse {
  double normal = 0.0;   ///< [M L/T] pushes apart, never negative
  Tangent<D> tangent{};  ///< [M L/T]
  Spin<D> roll{};        ///< [M L/T] torque impulse over the roll radius 2 r_i r_j / (r_i + r_j)

  Impulse& operator+=(const Impulse& b) {
    normal += b.normal;
    tangent += b.tangent;
    roll += b.roll;
    return *this;
  }
  friend Impulse operator-(const Impulse& a, const Impulse& b) {
    return {a.normal - b.normal, a.tangent - b.tangent, a.roll - b.roll};
  }
  friend Impulse operator*(const Impulse& a, double s) { return {a.normal * s, a.tangent * s, a.roll * s}; }
};

/// Sum of squares.
template <int D>
double squared(const Impulse<D>& a) {
  return a.normal * a.normal + repose::squared(a.tangent) + repose::squared(a.roll);
}

/// One contact as the solver sees it: two cache lines that a sweep streams. Wanted are impulses for which the formal
/// velocities (relative velocity after the step and bias) obey the law.
template <int D>
struct alignas(64) ContactLine {
  Vec<D> normal{};  ///< from the second to the first
  Impulse<D> impulse{};
  double normal_bias = 0.0;       ///< [L/T] gap over time step, or restitution times normal velocity before
  Tangent<D> tangent_bias{};      ///< [L/T] tangential restitution times slip before
  double normal_mass = 0.0;       ///< [M] normal impulse per normal velocity
  double tangent_mass = 0.0;      ///< [M]
  double roll_mass = 0.0;         ///< [M]
  double friction = 0.0;          ///< coefficient
  double rolling_friction = 0.0;  ///< coefficient
  double lever = 1.0;             ///< from a centre to the contact point, over the radius of that grain
  double first_turn = 1.0;        ///< roll radius over radius of the first; of the second it is 2 - first_turn
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};
static_assert(sizeof(ContactLine<2>) == 128);

/// The part of a difference of rim velocities that is rolling: in 3D, all but the spin about the normal.
REPOSE_FN double rolling_part(double spin, const Vec<2>&) { return spin; }
REPOSE_FN Vec<3> rolling_part(const Vec<3>& spin, const Vec<3>& normal) { return tangential(spin, normal); }

/// Velocity at which the two part [L/T].
template <int D>
REPOSE_FN double opening_velocity(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b) {
  return dot(Vec<D>(a.velocity - b.velocity), c.normal);
}

/// Tangential relative velocity at the contact point [L/T]; none in a rigid rotation of the pair.
template <int D>
REPOSE_FN Tangent<D> slip_velocity(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b) {
  return tangential(Vec<D>(a.velocity - b.velocity), c.normal) -
         spin_cross((a.rim_velocity + b.rim_velocity) * c.lever, c.normal);
}

/// Difference of the angular velocities times the roll radius [L/T].
template <int D>
REPOSE_FN Spin<D> roll_velocity(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b) {
  return rolling_part(a.rim_velocity * c.first_turn - b.rim_velocity * (2.0 - c.first_turn), c.normal);
}

/// Gives the two bodies an impulse without rolling part.
template <int D>
REPOSE_FN void push(const ContactLine<D>& c, double normal, const Tangent<D>& tangent, Body<D>& a, Body<D>& b) {
  const Vec<D> impulse = c.normal * normal + in_space(tangent, c.normal);
  const Spin<D> turn = normal_cross(c.normal, tangent) * (-inverse_inertia_factor<D> * c.lever);
  a.velocity += impulse * a.inverse_mass;
  b.velocity -= impulse * b.inverse_mass;
  a.rim_velocity += turn * a.inverse_mass;
  b.rim_velocity += turn * b.inverse_mass;
}

/// Turns the two against each other.
template <int D>
REPOSE_FN void turn(const ContactLine<D>& c, const Spin<D>& roll, Body<D>& a, Body<D>& b) {
  constexpr double factor = inverse_inertia_factor<D>;
  a.rim_velocity += roll * (factor * c.first_turn * a.inverse_mass);
  b.rim_velocity -= roll * (factor * (2.0 - c.first_turn) * b.inverse_mass);
}

/// Hands impulses to the two bodies of a contact, where nothing moves but what can move any way.
struct FreeBodies {
  template <int D>
  REPOSE_FN void push(const ContactLine<D>& c, double normal, const Tangent<D>& tangent, Body<D>& a, Body<D>& b) const {
    contact_dynamics::push(c, normal, tangent, a, b);
  }
  template <int D>
  REPOSE_FN void turn(const ContactLine<D>& c, const Spin<D>& roll, Body<D>& a, Body<D>& b) const {
    contact_dynamics::turn(c, roll, a, b);
  }
};

/// The same where some bodies are pistons: a wall never turns, and moves along one direction or not at all.
template <int D>
struct WithPistons {
  std::size_t first_wall;
  const Vec<D>* direction;

  REPOSE_FN void push(const ContactLine<D>& c, double normal, const Tangent<D>& tangent, Body<D>& a, Body<D>& b) const {
    if (c.second < first_wall) return contact_dynamics::push(c, normal, tangent, a, b);
    Body<D> still;
    contact_dynamics::push(c, normal, tangent, a, still);
    const auto& along = direction[c.second - first_wall];
    const Vec<D> impulse = c.normal * normal + in_space(tangent, c.normal);
    b.velocity -= along * (dot(impulse, along) * b.inverse_mass);
  }
  REPOSE_FN void turn(const ContactLine<D>& c, const Spin<D>& roll, Body<D>& a, Body<D>& b) const {
    Body<D> still;
    contact_dynamics::turn(c, roll, a, c.second < first_wall ? b : still);
  }
};

/// Sets the masses of a contact from its levers and the bodies.
template <int D>
void set_masses(ContactLine<D>& c, double first_inverse_mass, double second_inverse_mass) {
  constexpr double factor = inverse_inertia_factor<D>;
  const double second_turn = 2.0 - c.first_turn;
  c.normal_mass = 1.0 / (first_inverse_mass + second_inverse_mass);
  c.tangent_mass = c.normal_mass / (1.0 + factor * c.lever * c.lever);
  c.roll_mass =
      1.0 /
      (factor * (c.first_turn * c.first_turn * first_inverse_mass + second_turn * second_turn * second_inverse_mass));
}

/// The same with a wall that moves along `direction`, or not at all: as much of it as the impulse can move. In 3D the
/// tangent plane yields unevenly, and its mass is that of where it yields most, with which sweeps converge too.
template <int D>
void set_wall_masses(ContactLine<D>& c, double inverse_mass, double wall_inverse_mass, const Vec<D>& direction) {
  const double across = dot(c.normal, direction);
  set_masses(c, inverse_mass, 0.0);
  c.normal_mass = 1.0 / (inverse_mass + across * across * wall_inverse_mass);
  c.tangent_mass = 1.0 / (inverse_mass * (1.0 + inverse_inertia_factor<D> * c.lever * c.lever) +
                          (1.0 - across * across) * wall_inverse_mass);
}

/// All contacts of one step, with the velocities that there would be without them.
template <int D>
struct Problem {
  std::vector<Body<D>> free;    ///< bodies without contact impulses
  std::vector<Body<D>> bodies;  ///< with the impulses of the contacts
  std::vector<ContactLine<D>> contacts;
  double velocity_scale = 0.0;  ///< [L/T] residuals are measured by; not positive: by the fastest closing contact
  bool rolling = true;          ///< whether some contact resists rolling

  std::size_t first_wall = std::numeric_limits<std::size_t>::max();  ///< bodies from this one on are walls
  bool pistons = false;                                              ///< whether the contacts move some of them
  std::vector<Vec<D>> wall_direction;                                ///< along which each wall moves

  WithPistons<D> with_pistons() const { return {first_wall, wall_direction.data()}; }
};

/// Velocities from the impulses alone, whatever they were before.
template <int D>
void add_impulses(const Problem<D>& problem, std::vector<Body<D>>& bodies) {
  bodies = problem.free;
  const auto among = problem.with_pistons();
  for (const auto& c : problem.contacts) {
    among.push(c, c.impulse.normal, c.impulse.tangent, bodies[c.first], bodies[c.second]);
    among.turn(c, c.impulse.roll, bodies[c.first], bodies[c.second]);
  }
}

}  // namespace repose::contact_dynamics
