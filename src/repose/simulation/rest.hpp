// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/methods/method.hpp"
#include "repose/scene/scene.hpp"

#include <limits>
#include <vector>

namespace repose {

/// The largest motion and the largest net force of any moving grain.
struct Unrest {
  double kinetic_energy = 0.0;  ///< over weight of the same grain times nominal diameter
  double net_force = 0.0;       ///< over the weight of the same grain
};

/// `loads` act on grains besides gravity and contacts; walls and bases carry theirs by the contacts. Without gravity
/// the mean normal force of the contacts takes the place of the weight; without such a force the unrest is infinite.
template <int D = 2>
Unrest largest_unrest(const Grains<D>& grains, const Contacts<D>& contacts, const std::vector<Load<D>>& loads,
                      const Vec<D>& gravity, double diameter);

/// The rule of `stop.at_rest`: every grain has been below the limit for as long as base forces are averaged. It checks
/// at times of its own, every half of sqrt(d/g) (without gravity, every twentieth of output.window), and not at the
/// rows of the series. While a wall has yet to open or to begin its motion, there is no rest.
class Rest {
 public:
  Rest(const Scene& scene, const TimeSteps& steps);

  /// The first time after `time` [T] at which to check; infinity if the scene does not stop at rest.
  double due_after(double time) const { return times_.after(time); }

  /// Takes the state at a time, and returns whether the rest has lasted.
  bool lasts(const Unrest& unrest, double time);

  /// Whether the last check found a rest that had just begun.
  bool has_just_begun(double time) const { return since_ == time; }

  void exchange(Archive& archive) { archive.value("run/rest_since", since_); }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  Every times_;
  double limit_ = 0.0;          // of the kinetic energy
  double force_limit_ = 0.0;    // of the net force
  double window_ = 0.0;         // [T]
  double not_before_ = -never;  // [T] the last wall has opened, or begun its motion
  double since_ = never;        // [T] the first check of the present rest
};

}  // namespace repose
