// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

namespace repose::soft {

// A kernel is lean or full. The lean one knows forces alone; the full one also rolling torques, and which part of a
// force dissipates, for the energy audit. Both give the same bits where both apply.

/// What a contact does to its first grain; the second feels minus the force.
template <int D, bool Full = false>
struct Push {
  Vec<D> force{};        ///< [M L/T^2]
  Spin<D> rim_torque{};  ///< [M L/T^2] torque over radius: what changes the rim velocity; the same on the second
};
template <int D>
struct Push<D, true> {
  Vec<D> force{};
  Spin<D> rim_torque{};
  Spin<D> back_rim_torque{};  ///< of the second grain: rolling resistance acts on it the other way round
  Vec<D> damping{};           ///< [M L/T^2] part of the force that is the dashpot's
  Vec<D> friction{};          ///< [M L/T^2] part of the force that is tangential
};

/// Sum of the pushes on a grain: 32 bytes in 2D if lean.
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

  void add(const Push<D, true>& push) {
    force += push.force;
    rim_torque += push.rim_torque;
    damping += push.damping;
    friction += push.friction;
  }
  void add_back(const Push<D, true>& push) {
    force -= push.force;
    rim_torque += push.back_rim_torque;
    damping -= push.damping;
    friction -= push.friction;
  }
};

}  // namespace repose::soft
