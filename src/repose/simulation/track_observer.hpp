// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/track.hpp"
#include "repose/simulation/observer.hpp"

namespace repose {

/// Records where the moving grains are, at regular times and at the end.
template <int D>
class TrackObserver final : public Observer<D> {
 public:
  explicit TrackObserver(const Every& times) : times_(times) {}

  double due_after(double time) const override { return times_.after(time); }
  bool due_at_end() const override { return !times_.never(); }
  void observe(const Simulation<D>& simulation) override;

  const Track<D>& track() const { return track_; }
  void restore(Track<D> track) { track_ = std::move(track); }

 private:
  Every times_;
  Track<D> track_;
};

}  // namespace repose
