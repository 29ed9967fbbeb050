// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/grains.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace repose {

/// Where grains come from while a run goes on. All that changes is shown to `exchange`; everything random depends on
/// the seed and the number of the grain alone.
class Source {
 public:
  virtual ~Source() = default;

  /// True once every grain has been released.
  virtual bool done() const = 0;
  virtual std::int64_t released() const = 0;
  virtual std::int64_t count() const = 0;

  /// Step at which the next grain is due.
  virtual long next_step() const = 0;

  /// Releases the grains that are due now and for which there is room; true if any was. Where there is none they are
  /// due again after a short wait. `apex` gives the height of the highest grain that touches something [L].
  virtual bool release(Grains<2>& grains, long step, const std::function<double()>& apex) = 0;

  /// Time for which no grain has found room, although one is due [T].
  virtual double waiting(long step) const = 0;

  /// How long that may be [times of a fall of a diameter].
  virtual double patience() const { return 100.0; }

  /// What to say when that is too long.
  virtual std::string buried() const = 0;

  virtual void exchange(Archive& archive) = 0;
};

/// The source of a scene; `first_id` is that of the first grain it releases.
std::unique_ptr<Source> make_source(const Scene& scene, double time_step, std::int64_t first_id);

}  // namespace repose
