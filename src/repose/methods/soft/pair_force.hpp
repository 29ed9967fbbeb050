// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/laws/contact_force.hpp"
#include "repose/methods/soft/pair_geometry.hpp"
#include "repose/methods/soft/push.hpp"
#include "repose/methods/wall_list.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace repose::soft {

/// The part of a difference of angular velocities that is rolling: in 3D, all but the spin about the normal.
REPOSE_FN double rolling_part(double spin, const Vec<2>&) { return spin; }
REPOSE_FN Vec<3> rolling_part(const Vec<3>& spin, const Vec<3>& normal) { return tangential(spin, normal); }

/// The other part, about the normal: twisting. Discs have none.
REPOSE_FN double twisting_part(double, const Vec<2>&) { return 0.0; }
REPOSE_FN double twisting_part(const Vec<3>& spin, const Vec<3>& normal) { return dot(spin, normal); }

/// The torque of a contact on its first grain against rolling and twisting, divided by the roll radius [M L/T^2].
REPOSE_FN double resisting_torque(const ContactForce<double>& force, const Vec<2>&) { return force.rolling; }
REPOSE_FN Vec<3> resisting_torque(const ContactForce<Vec<3>>& force, const Vec<3>& normal) {
  return force.rolling + normal * force.twisting;
}

/// The same with the rolling and twisting of two grains.
template <int D>
REPOSE_FN PairGeometry<D> pair_geometry(const Grain<D>& a, const Grain<D>& b, const Vec<D>& d, double distance2,
                                        double within) {
  const double radii = a.radius + b.radius;
  const double roll_radius = 2.0 * a.radius * b.radius / radii;
  const PairMotion<D, double> motion{d,     a.velocity - b.velocity,     a.rim_velocity + b.rim_velocity,
                                     radii, 1.0 / a.mass + 1.0 / b.mass, a.inverse_mass + b.inverse_mass};
  auto pair = pair_geometry(motion, distance2, within, roll_radius);
  const Spin<D> turning = a.rim_velocity * (roll_radius / a.radius) - b.rim_velocity * (roll_radius / b.radius);
  pair.roll_velocity = rolling_part(turning, pair.normal);
  pair.twist_velocity = twisting_part(turning, pair.normal);
  return pair;
}

/// Converts the forces of a contact to the push on its grains, which have these radii.
template <int D, bool Full>
REPOSE_FN void to_push(const PairGeometry<D>& pair, const ContactForce<Tangent<D>>& force, double radius,
                       double back_radius, Push<D, Full>& push) {
  to_push(pair, force, push.force, push.rim_torque);
  if constexpr (Full) {
    const Spin<D> torque = resisting_torque(force, pair.normal);
    push.back_rim_torque = push.rim_torque - torque * (pair.touch.roll_radius / back_radius);
    push.rim_torque += torque * (pair.touch.roll_radius / radius);
    push.damping = pair.normal * (force.normal.total - force.normal.elastic);
    push.friction = in_space(force.tangential, pair.normal);
  }
}

/// Computes the push of pair (a, b) on a, and advances the slip displacement; in a full kernel also those of rolling
/// and twisting, and whether the pair is bonded. `times` is the step [T], or HalfSteps where velocities are those of
/// the time of the force. If the pair is out of reach and not bonded, returns false and sets the displacements to zero.
template <bool Periodic, int D, class Law, class Times, bool Full>
REPOSE_FN bool pair_force(const Law& law, const Grain<D>& a, const Grain<D>& b, const Box<D>& box, const Times& times,
                          Tangent<D>& slip, Tangent<D>& roll, double& twist, std::uint8_t& bonded,
                          Push<D, Full>& push) {
  const Vec<D> d = separation<Periodic>(a.position, b.position, box);
  const double distance2 = dot(d, d);
  const double within = reach(law.normal) * (a.radius + b.radius);
  bool apart = distance2 >= within * within;
  if constexpr (Full) apart = apart && bonded == 0;
  if (apart) {
    slip = Tangent<D>{};
    if constexpr (Full) {
      roll = Tangent<D>{};
      twist = 0.0;
    }
    return false;
  }
  const auto pair = pair_geometry(a, b, d, distance2, within);
  ContactHistory<Tangent<D>> history{turned(slip, pair.normal), {}};
  if constexpr (Full) {
    history.roll = turned(roll, pair.normal);
    history.bonded = bonded != 0;
    history.twist = twist;
  }
  const auto force =
      contact_force(law, pair.touch, pair.slip_velocity, pair.roll_velocity, times, history, pair.twist_velocity);
  slip = history.slip;
  to_push(pair, force, a.radius, b.radius, push);
  if constexpr (Full) {
    roll = history.roll;
    twist = history.twist;
    if (bonded != 0 && !history.bonded) {
      (a.fixed() ? push.back_lost : push.lost) = energy_of_break(law.cohesion, pair.touch);
    }
    bonded = history.bonded ? 1 : 0;
  }
  return true;
}

/// The same for a pair that makes no bonds and keeps no displacement about its normal.
template <bool Periodic, int D, class Law, class Times, bool Full>
REPOSE_FN bool pair_force(const Law& law, const Grain<D>& a, const Grain<D>& b, const Box<D>& box, const Times& times,
                          Tangent<D>& slip, Tangent<D>& roll, Push<D, Full>& push) {
  std::uint8_t unbonded = 0;
  double twist = 0.0;
  return pair_force<Periodic>(law, a, b, box, times, slip, roll, twist, unbonded, push);
}

/// The same without resistance to rolling.
template <bool Periodic, int D, class Law, class Times>
REPOSE_FN bool pair_force(const Law& law, const Grain<D>& a, const Grain<D>& b, const Box<D>& box, const Times& times,
                          Tangent<D>& slip, Push<D>& push) {
  Tangent<D> roll{};
  return pair_force<Periodic>(law, a, b, box, times, slip, roll, push);
}

/// The distance that counts for a law: that of the centres of the grain and of a grain of its size behind the wall.
template <int D>
REPOSE_FN double wall_distance(const Grain<D>& a, const Wall<D>& wall, const AboveWall<D>& place) {
  return wall.smooth ? place.height : place.height + a.radius;
}

/// The geometry of a grain and a wall in reach, of which `place` is the shortest line to the centre. The wall counts as
/// a grain of the same size and nominal mass, without curvature; contacts move it along its direction of motion only,
/// and only a piston. `surface` [L/T] is the velocity of a wall that turns, where it touches.
template <int D, class Law>
REPOSE_FN PairGeometry<D> wall_geometry(const Law& law, const Grain<D>& a, const Wall<D>& wall, const WallNow<D>& now,
                                        const AboveWall<D>& place, const Vec<D>& surface) {
  const double diameter = 2.0 * a.radius;
  const double distance = wall_distance(a, wall, place);
  const double within = reach(law.normal) * diameter;
  const Vec<D> relative = a.velocity - now.velocity - surface;
  const Tangent<D> slip = tangential(relative, place.normal) - spin_cross(a.rim_velocity, place.normal);
  const double yielding = now.inverse_mass * squared(dot(wall.motion.direction, place.normal));
  auto touch = make_touch(distance, 1.0 / distance, diameter, within, -dot(relative, place.normal), a.mass,
                          1.0 / a.mass + yielding, a.radius);
  touch.effective_radius = a.radius;
  const Spin<D> turning = a.rim_velocity - now.spin * a.radius;
  return {touch, place.normal, slip, rolling_part(turning, place.normal), 1.0, twisting_part(turning, place.normal)};
}

/// Finds the walls in reach of a grain of a material among the pairs of its row, and which of them act.
template <int D, class Laws>
void find_wall_contacts(const Laws& laws, const Grain<D>& grain, std::uint16_t material, const WallPair<D>* row,
                        std::uint32_t pairs, const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now,
                        const Box<D>& box, WallContacts<D>& contacts) {
  contacts.clear();
  for (std::uint32_t k = 0; k < pairs; ++k) {
    const auto w = row[k].wall;
    const auto& wall = walls[w];
    if (!now[w].present) continue;
    const auto from_point = from_wall(wall, now[w], grain.position, box);
    const auto place = above(wall, now[w], from_point);
    const double within = reach(laws.of(material, wall.material).normal) * (2.0 * grain.radius);
    if (wall_distance(grain, wall, place) < within || row[k].bonded != 0) contacts.add(w, k, from_point, place);
  }
  contacts.join(walls, now, grain.radius);
}

/// The forces between a grain and a wall.
template <int D, class Law, class Times>
REPOSE_FN ContactForce<Tangent<D>> wall_contact(const Law& law, const Wall<D>& wall, const PairGeometry<D>& pair,
                                                const Times& times, ContactHistory<Tangent<D>>& history) {
  if (wall.smooth) return {normal_force(law.normal, pair.touch), 0.0, {}, {}, {}};
  return contact_force(law, pair.touch, pair.slip_velocity, pair.roll_velocity, times, history, pair.twist_velocity);
}

/// The history of a contact with a wall, turned to its normal, and back.
template <int D>
ContactHistory<Tangent<D>> history_of(const WallPair<D>& contact, const Vec<D>& normal) {
  ContactHistory<Tangent<D>> history{turned(contact.slip, normal), turned(contact.roll, normal), contact.bonded != 0};
  if constexpr (D == 3) history.twist = contact.twist;
  return history;
}
template <int D>
void keep(const ContactHistory<Tangent<D>>& history, WallPair<D>& contact) {
  contact.slip = history.slip;
  contact.roll = history.roll;
  if constexpr (D == 3) contact.twist = history.twist;
}
/// Forgets it: the contact does not act.
template <int D>
void forget(WallPair<D>& contact) {
  contact.slip = {};
  contact.roll = {};
  contact.bonded = 0;
  if constexpr (D == 3) contact.twist = 0.0;
}

}  // namespace repose::soft
