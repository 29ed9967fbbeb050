// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/scene/sources/drop.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/source.hpp"

#include <vector>

namespace repose {

/// Grains that fall one by one from random places of an opening, a level line, disc or rectangle: number k is due at
/// time k / rate. A grain whose place is taken tries others, and waits where there is none; the later ones wait behind
/// it.
template <int D>
class Drop : public Source<D> {
 public:
  Drop(const Scene& scene, const DropSource& source, const TimeSteps& steps, std::int64_t first_id);

  bool done() const override { return released_ == source_.count; }
  std::int64_t released() const override { return released_; }
  std::int64_t count() const override { return source_.count; }
  double due() const override;
  bool release(Grains<D>& grains, double time, const SourceView& view) override;
  double waiting(double time) const override;
  std::string buried() const override;
  void exchange(Archive& archive) override;

 protected:
  /// The first moment of release at a time [T] or after it.
  virtual double moment(double time) const { return time; }

  const Scene& scene_;
  const DropSource& source_;
  TimeSteps steps_;

 private:
  /// When the next grain is due by the rate alone [T].
  double planned() const { return static_cast<double>(released_) / source_.rate; }

  std::int64_t first_id_;
  GrainDraw<D> draw_;
  std::vector<Wall<D>> walls_;
  double reach_ = 1.0;  // two grains act on each other within this times the sum of their radii
  std::int64_t released_ = 0;
  double retry_ = 0.0;       // [T] of the next try while waiting for room
  double last_ = 0.0;        // [T] of the last release
  std::uint32_t tries_ = 0;  // tries so far for the grain that is due
};

}  // namespace repose
