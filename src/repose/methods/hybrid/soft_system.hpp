// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/methods/hybrid/spring.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::hybrid {

inline constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// A grain in an implicit step. It may enter the step late, after a flight.
struct SoftBody {
  std::uint32_t grain = 0;    ///< index in memory
  double mass = 0.0;          ///< [M]
  double radius = 0.0;        ///< [L]
  double entry = 0.0;         ///< [T] after the start of the step
  double duration = 0.0;      ///< [T] from its entry to the end of the step
  Vec<2> start{};             ///< [L] where it enters
  Vec<2> velocity{};          ///< [L/T] with which it enters
  double rim_velocity = 0.0;  ///< [L/T]
  bool pinned = false;        ///< keeps its x
  Vec<2> moved{};             ///< [L] displacement to the end of the step: what is solved for
  double rolled = 0.0;        ///< [L] displacement of the rim

  Vec<2> at(double time) const { return start + moved * ((time - entry) / duration); }  ///< [L] on its path
  Vec<2> mean_velocity() const { return moved * (1.0 / duration); }
  Vec<2> end_velocity() const { return mean_velocity() * 2.0 - velocity; }
  double end_rim_velocity() const { return 2.0 * rolled / duration - rim_velocity; }
};

/// Two bodies, or a body and a partner at rest, that may touch in the step.
struct SoftPair {
  std::uint32_t first = 0;
  std::uint32_t second = nobody;  ///< nobody: a fixed grain or a wall
  std::int64_t partner = 0;       ///< index in memory of the other grain, or -1 - k for wall k
  Vec<2> apart{};                 ///< [L] where the first enters, from where the second enters or from the partner
  Vec<2> normal{};                ///< of a wall
  double reach = 0.0;             ///< [L] distance at which they touch
  double duration = 0.0;          ///< [T] of the part of the step in which both are there
  double lag_first = 0.0;         ///< fraction of its displacement that the first has made when the second enters
  double lag_second = 0.0;
  double friction = 0.0;      ///< mu_roll
  double well = 0.0;          ///< [1/L] mu_static over the width of an armed well
  double off_anchor = 0.0;    ///< [L] of the start, along the tangent of the wall
  double normal_force = 0.0;  ///< [M L/T^2] mean of the step
  double friction_force = 0.0;
  double well_force = 0.0;
  Vec<2> force{};  ///< [M L/T^2] all of it, on the first

  bool at_wall() const { return partner < 0; }
};

/// A symmetric matrix of a pair or a body.
struct Symmetric {
  double xx = 0.0, xy = 0.0, yy = 0.0;

  void add(const Vec<2>& a, const Vec<2>& b, double s) {
    xx += s * a[0] * b[0];
    xy += 0.5 * s * (a[0] * b[1] + a[1] * b[0]);
    yy += s * a[1] * b[1];
  }
};

/// How the force of a pair answers to displacements, for Newton's method: minus the derivatives, without their small
/// antisymmetric parts.
struct PairSlopes {
  Symmetric first, second, both;  ///< [M/T^2] of each body on itself and of one on the other
  Vec<2> tangent{};
  double drag_first = 0.0, drag_second = 0.0, drag_both = 0.0;  ///< [M/T^2] of friction
};

/// The equations of an implicit step that conserves energy: displacements in which mean forces and changes of momentum
/// agree. `statics` instead asks for forces at the end of the step, without velocities: a step of descent in energy.
/// Source: Liffman, Chan and Hughes (1992), (23)-(36), as corrected and derived in docs/physics/hybrid.md.
/// Validated by tests/unit/hybrid_soft_test.cpp.
struct SoftSystem {
  Spring spring;
  double slip_drag = 0.0;  ///< [M/T]
  Vec<2> gravity{};
  double step = 0.0;    ///< [T] forces in residuals are means over it
  double weight = 1.0;  ///< [M L/T^2] unit of residuals
  bool statics = false;
  bool straight = false;  ///< slopes leave out that forces turn with their contacts, which alone can make them negative

  /// Begins a step of a length [T] without bodies and pairs; their memory is used again.
  void begin(double length);

  std::vector<SoftBody> bodies;  ///< by ascending index of their grains
  std::vector<SoftPair> pairs;   ///< by ascending first, then second body

  std::vector<Vec<2>> unbalanced;       ///< [M L/T^2] residual of each body
  std::vector<double> unbalanced_turn;  ///< [M L/T^2] of its rim

  /// Whether rims can turn: there is friction.
  bool rolls() const;

  /// Computes the residuals, and the mean forces of all pairs.
  void balance();

  /// The largest residual [weight], and of which body. That of a pinned body is along y.
  struct Worst {
    double residual = 0.0;
    std::uint32_t body = nobody;
  };
  Worst worst() const;
  double sum_of_squares() const;  ///< of residuals [weight^2]

  /// Places a pair in time: when both are there, and how far the earlier has then moved.
  void time_pair(SoftPair& pair) const;

  /// The part of a body's residual that no pair makes.
  Vec<2> own_unbalanced(const SoftBody& body) const;
  double own_turn(const SoftBody& body) const;

  /// Finds the mean forces of a pair; returns that on the first body, weighted by the part of the step it acts in.
  Vec<2> act(SoftPair& pair) const;
  /// The same part of its friction, which turns both rims.
  double turning(const SoftPair& pair) const { return fraction_of_step(pair) * pair.friction_force; }
  PairSlopes slopes(const SoftPair& pair) const;
  Vec<2> force_on_first(const SoftPair& pair) const { return pair.force * fraction_of_step(pair); }
  double fraction_of_step(const SoftPair& pair) const { return pair.duration / step; }

 private:
  struct Places {
    Vec<2> before, after, along;  // separations, and the direction of the force
    double distance_before = 0.0, distance_after = 0.0;
  };
  Places places(const SoftPair& pair) const;
  double slip(const SoftPair& pair, const Vec<2>& tangent) const;
  double drag(const SoftPair& pair, double slip) const;
};

}  // namespace repose::hybrid
