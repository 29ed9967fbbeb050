// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/grains.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>

namespace repose {

/// Pours grains from an opening above the base: number k falls at time k / rate from rest, at a random place, with a
/// random size. A grain whose place is taken waits; places and sizes depend on the seed and k alone.
class Pour {
 public:
  Pour(const Scene& scene, double time_step, std::int64_t first_id);

  /// True once every grain has been released.
  bool done() const { return released_ == count_; }
  std::int64_t released() const { return released_; }
  std::int64_t count() const { return count_; }

  /// Step at which the next grain is due.
  long next_step() const;

  /// Releases the grain that is due now, if there is room for it; true if it was. Where there is none it is due again
  /// after a short wait.
  bool release(Grains<2>& grains, long step);

  void exchange(Archive& archive) {
    archive.value("source/released", released_);
    archive.value("source/retry", retry_);
    archive.value("source/tries", tries_);
  }

  /// Time for which the next grain has been waiting for room [T].
  double waiting(long step) const;

 private:
  const Scene& scene_;
  double time_step_;
  std::int64_t first_id_;
  std::int64_t count_ = 0;
  std::int64_t released_ = 0;
  long retry_ = 0;           // step of the next try while waiting for room
  std::uint32_t tries_ = 0;  // tries so far for the grain that is due
};

}  // namespace repose
