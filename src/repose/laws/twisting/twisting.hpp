// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/rolling/constant.hpp"
#include "repose/laws/rolling/free.hpp"
#include "repose/laws/rolling/spring.hpp"
#include "repose/laws/rolling/viscous.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>

namespace repose {

/// Resistance to twisting, the relative spin of two spheres about the normal of their contact: a torque along the
/// normal, opposite on the two. It has the form of a law of rolling, with a friction mu_t of its own; the velocity v_w
/// is the roll radius R times the relative spin. In 2D nothing twists.
///
/// A sphere has I = 2/5 m R^2, so that one which spins about the vertical on a plane slows down by 5/2 mu_t g/R under a
/// constant torque, and as exp(-5/2 b t) under a viscous one. Full slip under Hertz's pressure would have
/// mu_t = 3 pi/16 mu a/R, a the radius of the contact area. Source of the spring: Luding (2008).
/// Validated by tests/unit/twisting_test.cpp, tests/unit/spheres_test.cpp (decay of spin).
template <class Rolling>
struct Twisting : Rolling {};

using NoTwisting = Twisting<FreeRolling>;
using TwistingSpring = Twisting<RollingSpring>;
using TwistingViscous = Twisting<RollingViscous>;
using TwistingConstant = Twisting<RollingConstant>;

inline void parameters(NoTwisting&, Parameters&, const LawScales&) {}

inline void parameters(TwistingSpring& law, Parameters& to, const LawScales& scales) {
  to.number("friction", law.friction, required, not_negative, "",
            "mu_t: the torque about the normal is at most mu_t R N");
  to.number("stiffness", law.stiffness, {100.0 * scales.weight / scales.diameter, "100 m g/d"}, positive, "M/T^2",
            "torque over R per twisted length, R times the angle");
  to.number("damping", law.damping, 0.3, not_negative, "", "fraction of critical damping");
}

inline void parameters(TwistingViscous& law, Parameters& to, const LawScales&) {
  to.number("friction", law.friction, required, not_negative, "",
            "mu_t: the torque about the normal is at most mu_t R N");
  to.number("rate", law.rate, required, positive, "1/T", "torque over R, reduced mass and twisting velocity");
}

inline void parameters(TwistingConstant& law, Parameters& to, const LawScales& scales) {
  to.number("friction", law.friction, required, not_negative, "", "mu_t: the torque about the normal is mu_t R N");
  to.number("full_at", law.full_at, {0.01 * std::sqrt(scales.gravity * scales.diameter), "0.01 sqrt(g d)"}, positive,
            "L/T", "twisting velocity above which the torque is complete; it grows linearly up to there");
}

/// The displacement [L] of a contact about its normal, or a velocity [L/T]: one number, with the inertia of a sphere.
using Twist = Vec<1>;

/// The torque along the normal divided by the roll radius [M L/T^2]. Advances `twist` [L] by dt at the twisting
/// velocity [L/T].
template <class Rolling>
REPOSE_FN double twisting_force(const Twisting<Rolling>& law, const Touch<double>& touch,
                                const NormalForce<double>& normal, double twist_velocity, double dt, double& twist) {
  const Rolling& rolling = law;
  Twist displacement{{twist}};
  const Twist force = rolling_force(rolling, touch, normal, Twist{{twist_velocity}}, dt, displacement);
  twist = displacement[0];
  return force[0];
}

/// As of every law (displacement.hpp).
template <class Rolling>
REPOSE_FN double twisted(const Twisting<Rolling>& law, const Touch<double>& touch, double twist_velocity, double dt,
                         double twist) {
  const Rolling& rolling = law;
  return displaced(rolling, touch, Twist{{twist_velocity}}, dt, Twist{{twist}})[0];
}

template <class Rolling>
double energy_of_twist(const Twisting<Rolling>& law, const Touch<double>& touch, const NormalForce<double>& normal,
                       double twist) {
  const Rolling& rolling = law;
  return stored_energy(rolling, touch, normal, Twist{{twist}});
}

}  // namespace repose
