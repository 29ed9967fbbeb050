// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

namespace repose::soft {

// A kernel is lean or full. A lean kernel computes forces only; a full one also rolling torques, and the dissipative
// part of each force for the energy budget. Both give the same bits where both apply.

/// The push of a contact on its first grain; the force on the second is its negative.
template <int D, bool Full = false>
struct Push {
  Vec<D> force{};        ///< [M L/T^2]
  Spin<D> rim_torque{};  ///< [M L/T^2] torque over radius, which changes the rim velocity; equal on the second grain
};
template <int D>
struct Push<D, true> {
  Vec<D> force{};
  Spin<D> rim_torque{};
  Spin<D> back_rim_torque{};  ///< [M L/T^2] on the second grain, where rolling resistance has the opposite sign
  Vec<D> damping{};           ///< [M L/T^2] part of the force by the dashpot
  Vec<D> friction{};          ///< [M L/T^2] tangential part of the force
  double lost = 0.0;          ///< [M L^2/T^2] energy of a bond that ends, charged to the first grain
  double back_lost = 0.0;     ///< [M L^2/T^2] the same, charged to the second
};

/// The sum of the pushes on a grain: 32 bytes in 2D in a lean kernel.
template <int D, bool Full = false>
struct alignas(32) Slot {
  Vec<D> force{};
  Spin<D> rim_torque{};

  REPOSE_FN void add(const Push<D>& push) {
    force += push.force;
    rim_torque += push.rim_torque;
  }
  REPOSE_FN void add_back(const Push<D>& push) {
    force -= push.force;
    rim_torque += push.rim_torque;
  }
};
template <int D>
struct Slot<D, true> {
  Vec<D> force{};
  Spin<D> rim_torque{};
  Vec<D> damping{};
  Vec<D> friction{};
  double lost = 0.0;

  void add(const Push<D, true>& push) {
    force += push.force;
    rim_torque += push.rim_torque;
    damping += push.damping;
    friction += push.friction;
    lost += push.lost;
  }
  void add_back(const Push<D, true>& push) {
    force -= push.force;
    rim_torque += push.back_rim_torque;
    damping -= push.damping;
    friction -= push.friction;
    lost += push.back_lost;
  }
};

}  // namespace repose::soft
