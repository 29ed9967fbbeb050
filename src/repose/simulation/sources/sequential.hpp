// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/scene/sources/sequential.hpp"
#include "repose/simulation/sources/draw.hpp"
#include "repose/simulation/sources/source.hpp"

#include <vector>

namespace repose {

/// Lays grains down one by one: each appears a little above where it first touches something on its way down, at a
/// random place, with the velocity that a grain which has fallen long has under the limit of speed; the next once all
/// have been at rest for three steps. Source: Bratberg (2003), paper one.
class Sequential final : public Source {
 public:
  Sequential(const Scene& scene, const SequentialSource& source, double time_step, std::int64_t first_id);

  bool done() const override { return released_ == source_.count; }
  std::int64_t released() const override { return released_; }
  std::int64_t count() const override { return source_.count; }
  /// Whether all rest is looked at after every step.
  long next_step() const override { return next_; }
  bool release(Grains<2>& grains, long step, const std::function<double()>& apex) override;
  double waiting(long step) const override { return static_cast<double>(step - last_) * time_step_; }
  double patience() const override { return 1e3; }
  std::string buried() const override;
  void exchange(Archive& archive) override;

 private:
  bool at_rest(const Grains<2>& grains) const;
  double first_touch(const Grains<2>& grains, double x, double radius) const;

  const Scene& scene_;
  const SequentialSource& source_;
  double time_step_;
  std::int64_t first_id_;
  GrainDraw draw_;
  std::vector<Wall<2>> walls_;
  std::int64_t released_ = 0;
  long next_ = 0;   // step of the next look
  long last_ = 0;   // step of the last release
  long quiet_ = 0;  // steps at rest in a row
};

}  // namespace repose
