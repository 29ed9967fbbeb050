// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/grains.hpp"
#include "repose/methods/time_steps.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace repose {

/// What a source sees of the run.
struct SourceView {
  std::function<double()> apex;  ///< height of the highest grain of the heap [L]
  std::vector<WallState> walls;  ///< an entry for each wall of the scene, or none where all stand still
};

/// Where grains come from during a run. All that changes is shown to `exchange`; everything random depends on the seed
/// and the number of the grain alone.
template <int D>
class Source {
 public:
  virtual ~Source() = default;

  /// True once every grain has been released.
  virtual bool done() const = 0;
  virtual std::int64_t released() const = 0;
  virtual std::int64_t count() const = 0;

  /// Time [T] at which the next grain is due, one at which the method can stop; infinity once all are released.
  virtual double due() const = 0;

  /// Releases the grains that are due at this time [T] and for which there is room between the others and the walls;
  /// true if any was. Grains without room are due again after a short wait.
  virtual bool release(Grains<D>& grains, double time, const SourceView& view) = 0;

  /// How long [T] a grain has been due without finding room.
  virtual double waiting(double time) const = 0;

  /// How long that may be [times of a fall of a diameter].
  virtual double patience() const { return 100.0; }

  /// The message when that is too long.
  virtual std::string buried() const = 0;

  virtual void exchange(Archive& archive) = 0;
};

/// The source of a scene; `first_id` is that of the first grain it releases.
template <int D = 2>
std::unique_ptr<Source<D>> make_source(const Scene& scene, const TimeSteps& steps, std::int64_t first_id) {
  return scene.source->start(scene, steps, first_id, Dimension<D>{});
}

}  // namespace repose
