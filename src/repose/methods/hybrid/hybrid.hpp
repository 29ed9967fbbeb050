// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/impulse_law.hpp"
#include "repose/methods/hybrid/near_list.hpp"
#include "repose/methods/hybrid/settings.hpp"
#include "repose/methods/hybrid/soft_solver.hpp"
#include "repose/methods/hybrid/step.hpp"
#include "repose/methods/hybrid/touches.hpp"
#include "repose/methods/method.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// Hard collisions by event while grains fly, implicit steps that conserve energy while they rest.
/// Source: Liffman, Chan and Hughes (1992); docs/physics/hybrid.md has the corrected equations.
/// Validated by tests/unit/hybrid_soft_test.cpp, tests/unit/hybrid_test.cpp, tests/cli/test_hybrid.py.
class Hybrid final : public Method<2> {
 public:
  Hybrid(const ImpulseLaws& laws, const HybridSettings& settings);

  TimeSteps time_steps() const override { return {settings_.time_step, false}; }
  double time() const override { return static_cast<double>(steps_) * settings_.time_step; }
  StepReport advance(Grains<2>& grains, double until, Team& team) override;
  void grains_added(Grains<2>& grains) override;
  void refresh(Grains<2>& grains, Team& team) override;
  void exchange(Archive& archive) override;
  void restored(const Grains<2>& grains, const Team& team) override;
  Contacts<2> contacts(const Grains<2>& grains) const override;
  const std::vector<WallState>& walls() const override { return wall_states_; }
  std::vector<Vec<2>> take_wall_impulses() override;
  CollisionAccount take_collision_account() override;
  std::string trouble(const Grains<2>& grains) const override;

  /// Elastic energy of the soft contacts [M L^2/T^2].
  double elastic_energy(const Grains<2>& grains) const;
  std::size_t soft_contacts() const { return touches_.list.size(); }

 private:
  Vec<2> gravity_now() const;
  bool take_step(Grains<2>& grains, double length, int halvings);
  bool relax(Grains<2>& grains);
  void build_list(Grains<2>& grains, double reach);
  void touch_slowly(const Grains<2>& grains, std::uint32_t grain);
  hybrid::Surroundings around() const { return {settings_, laws_, near_, pinned_, profile()}; }
  double overlap(const Grains<2>& grains, const hybrid::Touch& touch, Vec<2>& normal) const;

  ImpulseLaws laws_;
  HybridSettings settings_;
  Vec<2> gravity_;  // [L/T^2] when it has risen; that of the settings is that of the step
  std::vector<WallState> wall_states_;
  hybrid::NearList near_;
  hybrid::Touches touches_;
  hybrid::SoftSystem system_;
  hybrid::DirectSolver solver_;
  std::vector<std::uint8_t> pinned_;  // of each grain
  std::vector<Vec<2>> wall_impulses_;
  CollisionAccount account_;
  long steps_ = 0;
  std::uint8_t relaxed_ = 0;
  std::uint32_t unsolved_ = hybrid::nobody;
};

}  // namespace repose
