// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/plane.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/laws/contact_force.hpp"

#include <cmath>

namespace repose::soft {

/// What a contact does to its first grain; the second feels minus the force and the same rim torque.
template <int D>
struct Push {
  Vec<D> force{};        ///< [M L/T^2]
  Spin<D> rim_torque{};  ///< [M L/T^2] torque over radius: what changes the rim velocity
};

/// Geometry of a pair within reach.
template <int D>
struct PairGeometry {
  Touch<double> touch;
  Vec<D> normal;  ///< from the second to the first
  Tangent<D> slip_velocity;
  double lever;  ///< contact point from either centre, over the radius of that grain
};

/// The pair as a law sees it. Each grain's lever is its own share r s_i / (s_i + s_j) of the distance r: with the whole
/// distance, as printed in Baxter et al. (6) and (13), a rigid rotation would count as slip.
template <int D>
REPOSE_FN PairGeometry<D> pair_geometry(const Grain<D>& a, const Grain<D>& b, const Vec<D>& d, double distance2,
                                        double reach) {
  const double radii = a.radius + b.radius;
  const double distance = std::sqrt(distance2);
  const double inverse = 1.0 / distance;
  const Vec<D> normal = d * inverse;
  const double lever = distance / radii;
  const Vec<D> relative = a.velocity - b.velocity;
  const auto rim = a.rim_velocity + b.rim_velocity;
  const double mass = 2.0 * a.mass * b.mass / (a.mass + b.mass);
  const double reduced_mass = 1.0 / (a.inverse_mass + b.inverse_mass);
  const double roll_radius = 2.0 * a.radius * b.radius / radii;
  return {make_touch(distance, inverse, radii, reach, -dot(relative, normal), mass, reduced_mass, roll_radius), normal,
          tangential(relative, normal) - spin_cross(rim * lever, normal), lever};
}

/// Force of pair (a, b) on a; brings the history forward by dt. False, and history zero, if the pair is apart.
template <bool Periodic, int D, class Law>
REPOSE_FN bool pair_force(const Law& law, const Grain<D>& a, const Grain<D>& b, const Box<D>& box, double dt,
                          Tangent<D>& history, Push<D>& push) {
  const Vec<D> d = separation<Periodic>(a.position, b.position, box);
  const double distance2 = dot(d, d);
  const double within = reach(law.normal) * (a.radius + b.radius);
  if (distance2 >= within * within) {
    history = Tangent<D>{};
    return false;
  }
  const auto pair = pair_geometry(a, b, d, distance2, within);
  history = turned(history, pair.normal);
  ContactHistory<Tangent<D>> both{history, {}};
  const auto force = contact_force(law, pair.touch, pair.slip_velocity, Tangent<D>{}, dt, both);
  history = both.slip;
  push.force = pair.normal * force.normal.total + in_space(force.tangential, pair.normal);
  push.rim_torque = normal_cross(pair.normal, force.tangential) * -pair.lever;
  return true;
}

/// Geometry of a grain and a plane: the plane is a grain of the same size and nominal mass that cannot move.
template <int D, class Law>
REPOSE_FN bool plane_geometry(const Law& law, const Grain<D>& a, const Plane<D>& plane, PairGeometry<D>& pair) {
  const double diameter = 2.0 * a.radius;
  const double distance = plane.distance(plane.height(a.position), a.radius);
  const double within = reach(law.normal) * diameter;
  if (distance >= within) return false;
  const Tangent<D> slip = tangential(a.velocity, plane.normal) - spin_cross(a.rim_velocity, plane.normal);
  pair = {
      make_touch(distance, 1.0 / distance, diameter, within, -dot(a.velocity, plane.normal), a.mass, a.mass, a.radius),
      plane.normal, slip, 1.0};
  return true;
}

/// Both forces of a grain and a plane.
template <int D, class Law>
REPOSE_FN ContactForce<Tangent<D>> plane_contact(const Law& law, const Plane<D>& plane, const PairGeometry<D>& pair,
                                                 double dt, Tangent<D>& history) {
  if (plane.smooth) return {normal_force(law.normal, pair.touch), Tangent<D>{}};
  ContactHistory<Tangent<D>> both{history, {}};
  const auto force = contact_force(law, pair.touch, pair.slip_velocity, Tangent<D>{}, dt, both);
  history = both.slip;
  return force;
}

/// Force of a plane on grain a.
template <int D, class Law>
REPOSE_FN bool plane_force(const Law& law, const Grain<D>& a, const Plane<D>& plane, double dt, Tangent<D>& history,
                           Push<D>& push) {
  PairGeometry<D> pair;
  if (!plane_geometry(law, a, plane, pair)) {
    history = Tangent<D>{};
    return false;
  }
  const auto force = plane_contact(law, plane, pair, dt, history);
  push.force = pair.normal * force.normal.total + in_space(force.tangential, pair.normal);
  push.rim_torque = normal_cross(pair.normal, force.tangential) * -pair.lever;
  return true;
}

}  // namespace repose::soft
