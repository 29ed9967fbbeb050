// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/methods/contact_dynamics/lanes.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::contact_dynamics {

/// The part of a grain or a wall that a sweep reads and writes.
template <int D, class T = double>
struct alignas(at_least<T>(D == 2 ? 32 : 64)) Body {
  VecOf<D, T> velocity{};       ///< [L/T]
  SpinOf<D, T> rim_velocity{};  ///< [L/T] angular velocity times radius
  T inverse_mass{};             ///< [1/M] 0: impulses do not move it
};
static_assert(sizeof(Body<2>) == 32 && alignof(Body<2>) == 32);

/// The impulse of a contact on its first body in a step; the second body gets the opposite.
template <int D, class T = double>
struct Impulse {
  T normal{};                 ///< [M L/T] >= 0, pushes the bodies apart
  TangentOf<D, T> tangent{};  ///< [M L/T]
  /// [M L/T] torque impulse divided by the roll radius 2 r_i r_j / (r_i + r_j). In 3D its part along the normal is that
  /// of twisting, the rest that of rolling.
  SpinOf<D, T> roll{};

  REPOSE_FN Impulse& operator+=(const Impulse& b) {
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

/// The sum of the squares of all components.
template <int D, class T>
double squared(const Impulse<D, T>& a) {
  return a.normal * a.normal + repose::squared(a.tangent) + repose::squared(a.roll);
}

/// The coefficient of friction against twisting, which spheres have.
template <int D>
struct TwistingFriction {};
template <>
struct TwistingFriction<3> {
  double friction = 0.0;
};

/// One contact of the solver: two cache lines. The solver finds impulses for which the formal velocities (relative
/// velocity after the step plus bias) obey the law.
template <int D, class T = double>
struct alignas(at_least<T>(64)) ContactLine {
  VecOf<D, T> normal{};  ///< from the second to the first
  Impulse<D, T> impulse{};
  T normal_bias{};                 ///< [L/T] gap over time step, or restitution times normal velocity before the step
  TangentOf<D, T> tangent_bias{};  ///< [L/T] tangential restitution times slip velocity before the step
  T normal_mass{};                 ///< [M] normal impulse per normal velocity
  T tangent_mass{};                ///< [M]
  T roll_mass{};                   ///< [M]
  T friction{};                    ///< coefficient
  T rolling_friction{};            ///< coefficient
  [[no_unique_address]] TwistingFriction<D> twisting{};
  T lever = T{} + 1.0;       ///< distance of a centre from the contact point over the radius of that grain
  T first_turn = T{} + 1.0;  ///< roll radius over radius of the first body; for the second it is 2 - first_turn
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};
static_assert(sizeof(ContactLine<2>) == 128 && alignof(ContactLine<2>) == 64);

/// The velocity at which the two bodies separate [L/T].
template <int D, class T>
REPOSE_FN T opening_velocity(const ContactLine<D, T>& c, const Body<D, T>& a, const Body<D, T>& b) {
  return dot(VecOf<D, T>(a.velocity - b.velocity), c.normal);
}

/// The tangential relative velocity at the contact point [L/T]; zero in a rigid rotation of the pair.
template <int D, class T>
REPOSE_FN TangentOf<D, T> slip_velocity(const ContactLine<D, T>& c, const Body<D, T>& a, const Body<D, T>& b) {
  return tangential(VecOf<D, T>(a.velocity - b.velocity), c.normal) -
         spin_cross((a.rim_velocity + b.rim_velocity) * c.lever, c.normal);
}

/// The difference of the angular velocities times the roll radius [L/T]. In 3D its part along the normal is twisting,
/// the rest rolling.
template <int D, class T>
REPOSE_FN SpinOf<D, T> roll_velocity(const ContactLine<D, T>& c, const Body<D, T>& a, const Body<D, T>& b) {
  return a.rim_velocity * c.first_turn - b.rim_velocity * (2.0 - c.first_turn);
}

/// Applies the normal and tangential impulse to the two bodies.
template <int D, class T>
REPOSE_FN void push(const ContactLine<D, T>& c, const T& normal, const TangentOf<D, T>& tangent, Body<D, T>& a,
                    Body<D, T>& b) {
  const VecOf<D, T> impulse = c.normal * normal + in_space(tangent, c.normal);
  const SpinOf<D, T> turn = normal_cross(c.normal, tangent) * (-inverse_inertia_factor<D> * c.lever);
  a.velocity += impulse * a.inverse_mass;
  b.velocity -= impulse * b.inverse_mass;
  a.rim_velocity += turn * a.inverse_mass;
  b.rim_velocity += turn * b.inverse_mass;
}

/// Applies the rolling impulse, with that of twisting, to the two bodies.
template <int D, class T>
REPOSE_FN void turn(const ContactLine<D, T>& c, const SpinOf<D, T>& roll, Body<D, T>& a, Body<D, T>& b) {
  constexpr double factor = inverse_inertia_factor<D>;
  a.rim_velocity += roll * (factor * c.first_turn * a.inverse_mass);
  b.rim_velocity -= roll * (factor * (2.0 - c.first_turn) * b.inverse_mass);
}

/// Applies impulses to the two bodies of a contact, if every body that moves can move in all directions.
struct FreeBodies {
  template <int D, class T>
  REPOSE_FN void push(const ContactLine<D, T>& c, const T& normal, const TangentOf<D, T>& tangent, Body<D, T>& a,
                      Body<D, T>& b) const {
    contact_dynamics::push(c, normal, tangent, a, b);
  }
  template <int D, class T>
  REPOSE_FN void turn(const ContactLine<D, T>& c, const SpinOf<D, T>& roll, Body<D, T>& a, Body<D, T>& b) const {
    contact_dynamics::turn(c, roll, a, b);
  }
};

/// Applies impulses to the two bodies of a contact, if some bodies are pistons: a wall never rotates, and moves along
/// one direction or not at all.
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

/// The work [M L^2/T^2] that an impulse does on the first body because the second moves, which impulses do not change.
template <int D>
double driven_work(const ContactLine<D>& c, const Impulse<D>& impulse, const Body<D>& driver) {
  const Vec<D> surface =
      driver.velocity + in_space(spin_cross(Spin<D>(driver.rim_velocity * c.lever), c.normal), c.normal);
  const Vec<D> push = c.normal * impulse.normal + in_space(impulse.tangent, c.normal);
  return dot(push, surface) + inner(impulse.roll, driver.rim_velocity) * (2.0 - c.first_turn);
}

/// Sets the masses of a contact from its levers and the masses of the bodies.
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

/// Sets the masses of a contact with a wall, which moves along `direction` or not at all. In 3D the mass depends on the
/// direction in the tangent plane; the smallest is used, with which sweeps converge too.
template <int D>
void set_wall_masses(ContactLine<D>& c, double inverse_mass, double wall_inverse_mass, const Vec<D>& direction) {
  const double across = dot(c.normal, direction);
  set_masses(c, inverse_mass, 0.0);
  c.normal_mass = 1.0 / (inverse_mass + across * across * wall_inverse_mass);
  c.tangent_mass = 1.0 / (inverse_mass * (1.0 + inverse_inertia_factor<D> * c.lever * c.lever) +
                          (1.0 - across * across) * wall_inverse_mass);
}

/// All contacts of one step, and the free velocities: those without contacts.
template <int D>
struct Problem {
  std::vector<Body<D>> free;    ///< bodies without contact impulses
  std::vector<Body<D>> bodies;  ///< bodies with contact impulses
  std::vector<ContactLine<D>> contacts;
  double velocity_scale = 0.0;  ///< [L/T] unit of residuals; if not positive, the fastest closing contact sets it
  bool rolling = true;          ///< whether any contact resists rolling or twisting

  std::size_t first_wall = std::numeric_limits<std::size_t>::max();  ///< bodies from this index on are walls
  bool pistons = false;                                              ///< whether contacts move any wall
  std::vector<Vec<D>> wall_direction;                                ///< unit vector along which each wall moves
  std::vector<std::uint32_t> surface_of{};  ///< walls of the bodies after those of the walls: surfaces that turn

  /// The wall of a body from `first_wall` on. A wall that turns has other velocities wherever it touches, so each of
  /// its contacts has a body of its own.
  std::size_t wall_of(std::size_t body) const {
    const auto walls = wall_direction.size() - surface_of.size();
    const auto w = body - first_wall;
    return w < walls ? w : surface_of[w - walls];
  }

  WithPistons<D> with_pistons() const { return {first_wall, wall_direction.data()}; }
};

/// Gives a contact with a wall that turns a body of its own, which moves as the wall does where it touches. `mirrored`
/// is the body of a grain that would touch there from behind and turn with the wall.
template <int D>
std::uint32_t add_surface(Problem<D>& problem, std::uint32_t wall, const Body<D>& mirrored) {
  problem.surface_of.push_back(wall);
  problem.wall_direction.emplace_back();
  problem.free.push_back(mirrored);
  return static_cast<std::uint32_t>(problem.free.size() - 1);
}

/// Replaces the surfaces of walls that turn by their walls in all contacts, and removes their bodies.
template <int D>
void name_walls(Problem<D>& problem) {
  if (problem.surface_of.empty()) return;
  for (auto& c : problem.contacts) {
    if (c.second >= problem.first_wall) {
      c.second = static_cast<std::uint32_t>(problem.first_wall + problem.wall_of(c.second));
    }
  }
  const auto kept = problem.free.size() - problem.surface_of.size();
  problem.free.resize(kept);
  problem.bodies.resize(kept);
  problem.wall_direction.resize(problem.wall_direction.size() - problem.surface_of.size());
  problem.surface_of.clear();
}

/// Sets the velocities of the bodies from the free velocities and the impulses alone.
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
