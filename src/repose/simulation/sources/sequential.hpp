// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/scene/sources/sequential.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/source.hpp"

#include <vector>

namespace repose {

/// Lays grains down one by one: each appears at a random place, a little above where it first touches something as it
/// falls, with the velocity of a grain that has fallen for long under the limit of speed. The next one follows once all
/// have been at rest for three steps, which are equal. Source: Bratberg (2003), paper one.
class Sequential final : public Source<2> {
 public:
  Sequential(const Scene& scene, const SequentialSource& source, const TimeSteps& steps, std::int64_t first_id);

  bool done() const override { return released_ == source_.count; }
  std::int64_t released() const override { return released_; }
  std::int64_t count() const override { return source_.count; }
  /// Rest is checked after every step.
  double due() const override;
  bool release(Grains<2>& grains, double time, const SourceView& view) override;
  double waiting(double time) const override { return time - last_; }
  double patience() const override { return 1e3; }
  std::string buried() const override;
  void exchange(Archive& archive) override;

 private:
  bool at_rest(const Grains<2>& grains) const;
  double first_touch(const Grains<2>& grains, const std::vector<WallNow<2>>& walls, double x, double radius) const;

  const Scene& scene_;
  const SequentialSource& source_;
  TimeSteps steps_;
  std::int64_t first_id_;
  GrainDraw<2> draw_;
  std::vector<Wall<2>> walls_;
  std::int64_t released_ = 0;
  double next_ = 0.0;        // [T] of the next check
  double last_ = 0.0;        // [T] of the last release
  long quiet_ = 0;           // checks in a row that found all at rest
  std::uint32_t tries_ = 0;  // tries so far for the grain that is due
};

}  // namespace repose
