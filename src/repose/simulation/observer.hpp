// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/time_steps.hpp"

#include <functional>
#include <utility>

namespace repose {

template <int D>
class Simulation;

/// Observes a simulation whenever it is due. It changes nothing there, so that a run has the same bits with it and
/// without.
template <int D>
class Observer {
 public:
  virtual ~Observer() = default;

  /// The first time after `time` [T] at which it is due; infinity for never. A function of `time` alone, so that a
  /// resumed run is observed at the same times.
  virtual double due_after(double time) const = 0;

  /// Whether it is due, too, at the end of a run.
  virtual bool due_at_end() const { return false; }

  virtual void observe(const Simulation<D>& simulation) = 0;
};

/// Calls a function at regular times.
template <int D>
class RegularObserver final : public Observer<D> {
 public:
  using Use = std::function<void(const Simulation<D>&)>;

  RegularObserver(const Every& times, Use use) : times_(times), use_(std::move(use)) {}

  double due_after(double time) const override { return times_.after(time); }
  void observe(const Simulation<D>& simulation) override { use_(simulation); }

 private:
  Every times_;
  Use use_;
};

}  // namespace repose
