// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/scene/kind.hpp"
#include "repose/scene/method_kind.hpp"
#include "repose/scene/problems.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace repose {

/// A base that is a wall.
struct BasePlane {
  bool smooth = false;
  std::uint16_t material = 0;
};

/// What grains rest on, at height 0, as a scene chooses it.
class BaseKind : public AnyKind<BaseKind> {
 public:
  /// Whether it can stand under a method.
  virtual bool suits(const MethodTraits& method) const { return method.follows_time; }
  /// Whether grains can rest on it in so many dimensions.
  virtual bool in_dimension(std::int64_t dimension) const { return dimension == 2; }

  /// The keys base.*, besides the kind.
  virtual void keys(const Scene& scene, Parameters& keys) = 0;
  virtual void check(const Scene& /*scene*/, Problems& /*problems*/) const {}

  virtual bool of_grains() const { return false; }
  /// Its grains have the diameter of the scene, whatever others have.
  virtual bool of_one_size() const { return false; }
  /// [L] Its grains lie at x from - this to this, unless they go round a periodic box.
  virtual double reach(const Scene& /*scene*/) const { return 0.0; }
  /// [L^2] of the base that belongs to each of its spheres, where all have the same.
  virtual std::optional<double> area_of_grain() const { return std::nullopt; }
  /// [L] How far its centres lie below height 0 at most.
  virtual double depth(const Scene& /*scene*/) const { return 0.0; }
  /// [L] half the width of the box, where the base decides it.
  virtual std::optional<double> box_half_width(const Scene& /*scene*/) const { return std::nullopt; }

  /// Whether a lattice pile can stand on it.
  virtual bool carries_pile() const { return false; }
  /// [L] between the hollows in which equal grains can lie; none: it has no hollows.
  virtual std::optional<double> pitch() const { return std::nullopt; }
  /// [L] height of the centre of a grain that stands on it, not in a hollow.
  virtual double height_on_top(const Scene& /*scene*/, double diameter) const { return 0.5 * diameter; }

  /// The level wall at height 0 that it is, if it is one.
  virtual std::optional<BasePlane> wall(const Scene& /*scene*/) const { return std::nullopt; }

  virtual std::string describe() const { return std::string(name()); }

  /// Its fixed grains, by ascending x; `id` is that of the next one. Defined in simulation/sources/base.cpp.
  virtual void add_grains(const Scene& /*scene*/, Grains<2>& /*grains*/, std::int64_t& /*id*/) const {}
  /// The same of spheres, by ascending x, then y.
  virtual void add_grains(const Scene& /*scene*/, Grains<3>& /*grains*/, std::int64_t& /*id*/) const {}
};

inline constexpr double most_base_grains = 1e7;
inline constexpr std::int64_t base_wall = 0;  ///< the number of the wall that a base is

Kinds<BaseKind>& base_kinds();

}  // namespace repose
