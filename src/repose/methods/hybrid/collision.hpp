// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/impulse_law.hpp"

#include <algorithm>
#include <cmath>

namespace repose::hybrid {

/// One partner of a hard collision.
struct Collider {
  Vec<2> velocity{};          ///< [L/T]
  double rim_velocity = 0.0;  ///< [L/T] angular velocity times radius
  double inverse_mass = 0.0;  ///< [1/M] 0: a wall or a fixed grain
};

/// The impulse of a hard collision on the first partner [M L/T], along the normal (from the second to the first) and
/// along the tangent z x n.
struct Collision {
  double normal = 0.0;
  double tangential = 0.0;
  bool slips = false;  ///< friction does not suffice to stop the relative motion of the surfaces

  Vec<2> impulse(const Vec<2>& n) const { return n * normal + in_space(tangential, n); }
};

/// How fast the partners approach [L/T], negative, or separate.
inline double normal_speed(const Collider& first, const Collider& second, const Vec<2>& n) {
  return dot(first.velocity - second.velocity, n);
}

/// The relative velocity of the surfaces at the contact point along the tangent [L/T].
inline double slip_speed(const Collider& first, const Collider& second, const Vec<2>& n) {
  return tangential(first.velocity - second.velocity, n) - first.rim_velocity - second.rim_velocity;
}

/// The impulse of a collision of partners that approach: restitution along the normal; along the tangent the impulse
/// that stops the slip, at most friction times the normal impulse.
/// Source: Liffman, Chan and Hughes (1992), (12), (16) and (19), as corrected in docs/physics/hybrid.md.
/// Validated by tests/unit/hybrid_collision_test.cpp.
inline Collision collide(const Collider& first, const Collider& second, const Vec<2>& n, const ImpulseLaw& law) {
  const double lightness = first.inverse_mass + second.inverse_mass;
  if (!(lightness > 0.0)) return {};
  Collision made;
  made.normal = std::max(0.0, -(1.0 + law.restitution) * normal_speed(first, second, n) / lightness);
  // Each rim adds radius^2 / moment of inertia to the inverse of the mass that the tangent sees.
  const double of_surface = (1.0 + inverse_inertia_factor<2>)*lightness;
  const double stops = -slip_speed(first, second, n) / of_surface;
  const double limit = friction_limit(law.friction, made.normal);
  made.slips = std::fabs(stops) > limit;
  made.tangential = project(stops, limit);
  return made;
}

/// Gives a partner its impulse: `sign` is 1 for the first and -1 for the second. The tangential impulses on both rims
/// have the same torque.
/// Source: (6), (13) and (14), whose second sign is corrected.
inline void receive(Collider& partner, const Collision& collision, const Vec<2>& n, double sign) {
  partner.velocity += collision.impulse(n) * (sign * partner.inverse_mass);
  partner.rim_velocity -= inverse_inertia_factor<2> * partner.inverse_mass * collision.tangential;
}

}  // namespace repose::hybrid
