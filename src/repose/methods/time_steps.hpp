// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

/// How a method divides time, and the one rule that turns a time into whole steps.
struct TimeSteps {
  double length = 0.0;     ///< [T] of every step; 0 when steps vary and the method can stop at any time
  bool staggered = false;  ///< velocities lag half a step behind positions, except at time 0

  bool equal() const { return length > 0.0; }

  /// The number of steps nearest to a time, and the time [T] after a number of steps. Only for equal steps.
  long count(double time) const { return std::lround(bounded(time / length)); }
  double after(long steps) const { return static_cast<double>(steps) * length; }

  /// The time nearest to this one at which the method can stop.
  double nearest(double time) const { return equal() ? after(count(time)) : time; }

  /// The first time at which the method can stop and that is not before `time` less `tolerance` steps.
  double at_or_after(double time, double tolerance = 0.0) const {
    return equal() ? after(static_cast<long>(std::ceil(bounded(time / length - tolerance)))) : time;
  }

  /// A duration [T] in whole steps: the nearest number, at least one.
  double rounded(double duration) const { return equal() ? after(std::max(1L, count(duration))) : duration; }

  /// A duration [T] in whole steps: as many as fit into it, at least one.
  double cut(double duration) const {
    return equal() ? after(std::max(1L, static_cast<long>(bounded(duration / length)))) : duration;
  }

  /// The sum of a time at which the method can stop and a duration in whole steps.
  double later(double time, double duration) const {
    return equal() ? after(count(time) + count(duration)) : time + duration;
  }

  /// How far velocities lag behind positions at a time [T].
  double velocity_lag(double time) const { return staggered && time > 0.0 ? 0.5 * length : 0.0; }

  /// Limits a number of steps to one that a long holds and no run reaches.
  static double bounded(double steps) {
    constexpr double most = 1e15;
    return std::min(std::max(0.0, steps), most);
  }
};

/// The multiples of an interval, at which something is due. They do not depend on the time of the question, so a
/// resumed run finds the same ones.
class Every {
 public:
  /// Multiples of an interval [T], rounded to whole steps; none if it is 0.
  Every(double interval, const TimeSteps& steps) : steps_(steps) {
    if (!(interval > 0.0)) return;
    interval_ = steps.rounded(interval);
    count_ = steps.equal() ? steps.count(interval_) : 1;
  }

  bool never() const { return count_ == 0; }

  /// The first multiple after a time; infinity if there is none.
  double after(double time) const {
    if (never()) return std::numeric_limits<double>::infinity();
    if (steps_.equal()) return steps_.after((steps_.count(time) / count_ + 1) * count_);
    double multiple = std::max(0.0, std::floor(time / interval_));
    while (multiple * interval_ <= time) multiple += 1.0;
    return multiple * interval_;
  }

  /// The first multiple at a time or after it.
  double at_or_after(double time) const {
    if (never()) return std::numeric_limits<double>::infinity();
    if (steps_.equal()) return steps_.after((steps_.count(time) + count_ - 1) / count_ * count_);
    double multiple = std::max(0.0, std::floor(time / interval_));
    while (multiple * interval_ < time) multiple += 1.0;
    return multiple * interval_;
  }

 private:
  TimeSteps steps_;
  double interval_ = 0.0;  // [T]
  long count_ = 0;         // steps in the interval, or 1 where steps vary; 0: never
};

}  // namespace repose
