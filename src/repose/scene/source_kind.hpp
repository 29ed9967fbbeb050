// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/dimension.hpp"
#include "repose/core/grains.hpp"
#include "repose/scene/kind.hpp"
#include "repose/scene/method_kind.hpp"
#include "repose/scene/problems.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace repose {

template <int D>
class Source;
struct TimeSteps;

/// A source of grains as a scene chooses it.
class SourceKind : public AnyKind<SourceKind> {
 public:
  /// Whether it can feed a method.
  virtual bool suits(const MethodTraits& method) const { return method.follows_time; }
  /// Whether it brings grains in so many dimensions.
  virtual bool in_dimension(std::int64_t dimension) const { return dimension == 2; }

  /// The keys source.*, besides the kind.
  virtual void keys(const Scene& scene, Parameters& keys) = 0;
  virtual void check(const Scene& scene, Problems& problems) const = 0;

  virtual std::int64_t released() const { return 0; }  ///< grains that come while it runs
  virtual std::int64_t placed() const { return 0; }    ///< grains that exist at the start
  /// The release height is above the highest grain of the heap, not above height 0.
  virtual bool above_apex() const { return false; }

  /// Its grains come to rest one by one, so that none needs to be faster than it becomes in a step.
  virtual bool limits_speed() const { return false; }

  virtual double fall(const Scene& scene) const;          ///< [L] height from which its fastest grain seems to fall
  virtual double column(const Scene& scene) const;        ///< grains that may stand above one at the base
  virtual double expected_end(const Scene& scene) const;  ///< [T] by which its grains should have come to rest
  virtual double expected_work(const Scene& scene, double time) const;  ///< [T] times moving grains it brought by then

  virtual std::string describe() const = 0;  ///< "1000 poured"; "" if it has nothing to say

  // What follows is defined in simulation/sources, so that a scene needs to know nothing that runs.

  /// The grains that exist at the start; `id` is that of the next one.
  virtual void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const;
  virtual void add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const;
  /// The source at work; `first_id` is that of the first grain it releases.
  virtual std::unique_ptr<Source<2>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                           Dimension<2>) const;
  virtual std::unique_ptr<Source<3>> start(const Scene& scene, const TimeSteps& steps, std::int64_t first_id,
                                           Dimension<3>) const;
};

Kinds<SourceKind>& source_kinds();

}  // namespace repose
