// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/track.hpp"
#include "repose/simulation/observer.hpp"

namespace repose {

/// Records where the moving grains are, at regular times and at the end.
class TrackObserver final : public Observer {
 public:
  explicit TrackObserver(const Every& times) : times_(times) {}

  double due_after(double time) const override { return times_.after(time); }
  bool due_at_end() const override { return !times_.never(); }
  void observe(const Simulation& simulation) override;

  const Track& track() const { return track_; }
  void restore(Track track) { track_ = std::move(track); }

 private:
  Every times_;
  Track track_;
};

}  // namespace repose
