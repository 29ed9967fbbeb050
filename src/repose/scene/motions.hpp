// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/coordinates.hpp"
#include "repose/core/dimension.hpp"
#include "repose/scene/kind.hpp"

#include <cstdint>
#include <optional>

namespace repose {

/// What moves a wall, as a scene chooses it.
class MotionKind : public AnyKind<MotionKind> {
 public:
  /// Whether it exists in so many dimensions.
  virtual bool in_dimension(std::int64_t /*dimension*/) const { return true; }

  /// The keys of the wall that say how it moves, besides the kind.
  virtual void keys(Parameters& keys, std::int64_t dimension) = 0;

  /// The key of what sets the direction, and its value; null for a wall that stands still.
  virtual const Coordinates* direction() const { return nullptr; }
  virtual std::string_view direction_key() const { return ""; }
  /// The times [T] between which it moves; null for a wall that stands still. No stop: it moves for ever.
  virtual double start() const { return 0.0; }
  virtual const std::optional<double>* stop() const { return nullptr; }

  // Those of a sound scene.
  virtual WallMotion<2> motion(Dimension<2>) const = 0;
  virtual WallMotion<3> motion(Dimension<3>) const = 0;
};

/// A wall that moves from a time on, perhaps until another.
class MovingWall : public MotionKind {
 public:
  double starts = 0.0;          ///< [T]
  std::optional<double> stops;  ///< [T]

  double start() const override { return starts; }
  const std::optional<double>* stop() const override { return &stops; }

 protected:
  void time_keys(Parameters& keys);
  template <int D>
  WallMotion<D> between_times(typename WallMotion<D>::Kind kind) const;
};

Kinds<MotionKind>& motion_kinds();

struct StandingWall final : KindOf<StandingWall, MotionKind> {
  static constexpr std::string_view kind = "fixed";
  static constexpr std::string_view meaning = "it stands still";

  void keys(Parameters&, std::int64_t) override {}
  WallMotion<2> motion(Dimension<2>) const override { return {}; }
  WallMotion<3> motion(Dimension<3>) const override { return {}; }
};

struct DrivenWall final : KindOf<DrivenWall, MovingWall> {
  static constexpr std::string_view kind = "velocity";
  static constexpr std::string_view meaning = "it moves at a given velocity";

  Coordinates velocity = no_coordinates;  ///< [L/T]

  void keys(Parameters& keys, std::int64_t dimension) override;
  const Coordinates* direction() const override { return &velocity; }
  std::string_view direction_key() const override { return "velocity"; }
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

struct VibratingWall final : KindOf<VibratingWall, MovingWall> {
  static constexpr std::string_view kind = "vibration";
  static constexpr std::string_view meaning =
      "it vibrates: amplitude times sin(2 pi frequency t + phase), t since start";

  Coordinates amplitude = no_coordinates;  ///< [L]
  double frequency = unset;                ///< [1/T]
  double phase = 0.0;                      ///< [deg]

  void keys(Parameters& keys, std::int64_t dimension) override;
  const Coordinates* direction() const override { return &amplitude; }
  std::string_view direction_key() const override { return "amplitude"; }
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

struct RotatingWall final : KindOf<RotatingWall, MovingWall> {
  static constexpr std::string_view kind = "rotation";
  static constexpr std::string_view meaning = "it rotates about a point";

  Coordinates centre = no_coordinates;  ///< [L]
  Coordinates axis{0.0, 0.0, 1.0};      ///< in three dimensions
  double angular_velocity = unset;      ///< [1/T]

  void keys(Parameters& keys, std::int64_t dimension) override;
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

/// Its surface runs about an axis across the plane: in two dimensions alone.
struct BeltWall final : KindOf<BeltWall, MovingWall> {
  static constexpr std::string_view kind = "belt";
  static constexpr std::string_view meaning = "it stays, and its surface runs round it, as a conveyor belt does";

  double speed = unset;  ///< [L/T]

  bool in_dimension(std::int64_t dimension) const override { return dimension == 2; }
  void keys(Parameters& keys, std::int64_t dimension) override;
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

/// A wall with a mass, which the grains push back.
class Piston : public MovingWall {
 public:
  double mass = unset;         ///< [M]
  double drag = 0.0;           ///< [M/T]
  double surface_speed = 0.0;  ///< [L/T]

 protected:
  void piston_keys(Parameters& keys, std::int64_t dimension);
  template <int D>
  WallMotion<D> piston_motion(typename WallMotion<D>::Kind kind) const;
};

struct PushedPiston final : KindOf<PushedPiston, Piston> {
  static constexpr std::string_view kind = "force";
  static constexpr std::string_view meaning = "a piston under a given force";

  Coordinates force = no_coordinates;  ///< [M L/T^2]

  void keys(Parameters& keys, std::int64_t dimension) override;
  const Coordinates* direction() const override { return &force; }
  std::string_view direction_key() const override { return "force"; }
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

struct SprungPiston final : KindOf<SprungPiston, Piston> {
  static constexpr std::string_view kind = "spring";
  static constexpr std::string_view meaning = "a piston pulled by a spring whose far end moves at a given velocity";

  Coordinates velocity = no_coordinates;  ///< [L/T] of the far end
  double stiffness = unset;               ///< [M/T^2]

  void keys(Parameters& keys, std::int64_t dimension) override;
  const Coordinates* direction() const override { return &velocity; }
  std::string_view direction_key() const override { return "velocity"; }
  WallMotion<2> motion(Dimension<2>) const override { return made<2>(); }
  WallMotion<3> motion(Dimension<3>) const override { return made<3>(); }

 private:
  template <int D>
  WallMotion<D> made() const;
};

}  // namespace repose
