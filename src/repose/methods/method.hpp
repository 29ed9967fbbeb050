// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/team.hpp"

#include <vector>

namespace repose {

/// What an advance did.
struct StepReport {
  long steps = 0;        ///< steps taken
  bool trouble = false;  ///< a grain became too fast to follow, or not a number: the state is not to be trusted
};

/// A way to move the grains, as the Simulation sees it.
template <int D>
class Method {
 public:
  virtual ~Method() = default;

  /// Takes up to `steps` steps; fewer only in trouble.
  virtual StepReport advance(Grains<D>& grains, long steps, Team& team) = 0;

  /// To be told when grains were added at the end of the arrays.
  virtual void grains_added(Grains<D>& grains) = 0;

  /// Brings what the method knows of the grains up to date now: grains that have left the box are dropped.
  virtual void refresh(Grains<D>& grains, Team& team) = 0;

  /// Contacts of the present state, ordered by ids.
  virtual Contacts<D> contacts(const Grains<D>& grains) const = 0;

  virtual double time_step() const = 0;
};

}  // namespace repose
