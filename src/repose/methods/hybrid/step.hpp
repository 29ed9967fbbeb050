// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/collision_account.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/profile.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/methods/hybrid/collision.hpp"
#include "repose/methods/hybrid/near_list.hpp"
#include "repose/methods/hybrid/settings.hpp"
#include "repose/methods/hybrid/soft_solver.hpp"
#include "repose/methods/hybrid/soft_system.hpp"
#include "repose/methods/hybrid/touches.hpp"

#include <cstdint>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace repose::hybrid {

/// What a step knows of the grains besides their state.
struct Surroundings {
  const HybridSettings& settings;
  const ImpulseLaws& laws;
  const NearList& near;
  const std::vector<std::uint8_t>& pinned;
  Profile* profile = nullptr;  ///< where the solver counts its time
};

/// The grains of soft contacts, by ascending index, as bodies of an implicit step.
void gather_bodies(const Surroundings& around, const Grains<2>& grains, const Touches& touches, double length,
                   SoftSystem& system);
SoftBody body_of(const Surroundings& around, const Grains<2>& grains, std::uint32_t grain, double entry, double length);

/// All pairs of the bodies, with fixed grains and walls too, that can meet in the step. `body` is that of each grain,
/// or nobody.
void gather_pairs(const Surroundings& around, const Grains<2>& grains, const Touches& touches,
                  const std::vector<std::uint32_t>& body, SoftSystem& system);

/// The number of the body of each grain.
std::vector<std::uint32_t> bodies_of(const Grains<2>& grains, const SoftSystem& system);

SoftSystem make_system(const HybridSettings& settings);
Solved solve(const HybridSettings& settings, DirectSolver& solver, SoftSystem& system, double tolerance, bool definite);

/// A wall, or a grain at rest, as a partner.
inline std::uint32_t wall_of(std::int64_t partner) { return static_cast<std::uint32_t>(-1 - partner); }
inline double wall_reach(const Wall<2>& wall, double radius) { return wall.smooth ? 2.0 * radius : radius; }
inline Vec<2> wall_tangent(const Wall<2>& wall) { return in_space(1.0, wall.normal); }

/// One step: grains without soft contacts fly and collide from event to event, those with soft contacts are bodies of
/// an implicit step. A flying grain whose contact turns soft becomes a body at that time, and the implicit step is
/// solved again with it; the paths of both kinds then agree, and so do momentum and energy (docs/physics/hybrid.md).
class Step {
 public:
  /// `system` and `solver` are those of the step before: what of them does not change is used again.
  Step(const Surroundings& around, Grains<2>& grains, Touches& touches, SoftSystem& system, DirectSolver& solver,
       double length);

  /// Takes the step. False if the implicit step has no solution: the grains are then not to be used.
  bool take();

  CollisionAccount account;
  std::vector<Vec<2>> wall_impulses;  ///< [M L/T] of grains on each wall
  double deepest = 0.0;               ///< largest overlap at the end [sum of the radii, or radius at a wall]
  std::uint32_t unsolved = nobody;    ///< grain with the largest residual, where there is no solution

 private:
  /// A meeting of a flying grain and a partner, valid while neither has changed its path.
  struct Event {
    double time = 0.0;  // [T] after the start of the step
    std::uint32_t grain = 0;
    std::int64_t partner = 0;
    std::uint32_t version = 0, partner_version = 0;
  };
  struct Later {
    bool operator()(const Event& a, const Event& b) const {
      return std::tie(a.time, a.grain, a.partner) > std::tie(b.time, b.grain, b.partner);
    }
  };
  /// Where a grain or wall is at a time, and how it moves.
  struct Path {
    Vec<2> place{}, velocity{}, acceleration{};
  };

  bool flies(std::uint32_t grain) const { return body_[grain] == nobody && !grains_.line[grain].fixed(); }
  Path path(std::uint32_t grain, double time) const;
  const ImpulseLaw& law(std::uint32_t grain, std::int64_t partner) const;

  // Flights and collisions.
  void find_events(double now);
  void find_events_of(std::uint32_t grain, double now);
  void find_event(std::uint32_t grain, std::int64_t partner, double now);
  bool meet(const Event& event);
  Collider collider(std::uint32_t grain) const;
  void fly(std::uint32_t grain, double time);
  void give(std::uint32_t grain, const Collision& collision, const Vec<2>& n, double sign);
  Vec<2> acceleration(std::uint32_t grain) const;
  bool repeats(std::uint32_t grain, std::int64_t partner);
  void soften(std::uint32_t grain, std::int64_t partner, double time);

  // Implicit step.
  void add_body(std::uint32_t grain, double time);
  bool solve();
  void finish();
  void keep_touches();

  const Surroundings& around_;
  const HybridSettings& settings_;
  Grains<2>& grains_;
  Touches& touches_;
  SoftSystem& system_;
  DirectSolver& solver_;
  double length_;
  std::vector<std::uint32_t> body_;     // of each grain, or nobody
  std::vector<double> since_;           // [T] of the state of each flying grain
  std::vector<std::uint32_t> version_;  // of the path of each grain
  bool outdated_ = false;               // bodies have changed since the last solution
  std::priority_queue<Event, std::vector<Event>, Later> events_;
  std::map<std::pair<std::uint32_t, std::int64_t>, int> met_;  // how often pairs have collided in this step
  std::int64_t most_events_ = 0;                               // after which every collision turns soft
};

}  // namespace repose::hybrid
