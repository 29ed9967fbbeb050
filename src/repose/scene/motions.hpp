// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/scene/kind.hpp"

#include <array>
#include <optional>

namespace repose {

/// What moves a wall, as a scene chooses it.
class MotionKind : public AnyKind<MotionKind> {
 public:
  /// The keys of the wall that say how it moves, besides the kind.
  virtual void keys(Parameters& keys) = 0;

  /// The key of what sets the direction, and its value; null for a wall that stands still.
  virtual const std::array<double, 2>* direction() const { return nullptr; }
  virtual std::string_view direction_key() const { return ""; }
  /// The times [T] between which it moves; null for a wall that stands still. No stop: it moves for ever.
  virtual double start() const { return 0.0; }
  virtual const std::optional<double>* stop() const { return nullptr; }
  virtual WallMotion<2> motion() const = 0;  ///< of a sound scene
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
  WallMotion<2> between_times(WallMotion<2>::Kind kind) const;
};

Kinds<MotionKind>& motion_kinds();

struct StandingWall final : KindOf<StandingWall, MotionKind> {
  static constexpr std::string_view kind = "fixed";
  static constexpr std::string_view meaning = "it stands still";

  void keys(Parameters&) override {}
  WallMotion<2> motion() const override { return {}; }
};

struct DrivenWall final : KindOf<DrivenWall, MovingWall> {
  static constexpr std::string_view kind = "velocity";
  static constexpr std::string_view meaning = "it moves at a given velocity";

  std::array<double, 2> velocity{unset, unset};  ///< [L/T]

  void keys(Parameters& keys) override;
  const std::array<double, 2>* direction() const override { return &velocity; }
  std::string_view direction_key() const override { return "velocity"; }
  WallMotion<2> motion() const override;
};

struct VibratingWall final : KindOf<VibratingWall, MovingWall> {
  static constexpr std::string_view kind = "vibration";
  static constexpr std::string_view meaning =
      "it vibrates: amplitude times sin(2 pi frequency t + phase), t since start";

  std::array<double, 2> amplitude{unset, unset};  ///< [L]
  double frequency = unset;                       ///< [1/T]
  double phase = 0.0;                             ///< [deg]

  void keys(Parameters& keys) override;
  const std::array<double, 2>* direction() const override { return &amplitude; }
  std::string_view direction_key() const override { return "amplitude"; }
  WallMotion<2> motion() const override;
};

struct RotatingWall final : KindOf<RotatingWall, MovingWall> {
  static constexpr std::string_view kind = "rotation";
  static constexpr std::string_view meaning = "it rotates about a point";

  std::array<double, 2> centre{unset, unset};  ///< [L]
  double angular_velocity = unset;             ///< [1/T]

  void keys(Parameters& keys) override;
  WallMotion<2> motion() const override;
};

struct BeltWall final : KindOf<BeltWall, MovingWall> {
  static constexpr std::string_view kind = "belt";
  static constexpr std::string_view meaning = "it stays, and its surface runs round it, as a conveyor belt does";

  double speed = unset;  ///< [L/T]

  void keys(Parameters& keys) override;
  WallMotion<2> motion() const override;
};

/// A wall with a mass, which the grains push back.
class Piston : public MovingWall {
 public:
  double mass = unset;         ///< [M]
  double drag = 0.0;           ///< [M/T]
  double surface_speed = 0.0;  ///< [L/T]

 protected:
  void piston_keys(Parameters& keys);
  WallMotion<2> piston_motion(WallMotion<2>::Kind kind) const;
};

struct PushedPiston final : KindOf<PushedPiston, Piston> {
  static constexpr std::string_view kind = "force";
  static constexpr std::string_view meaning = "a piston under a given force";

  std::array<double, 2> force{unset, unset};  ///< [M L/T^2]

  void keys(Parameters& keys) override;
  const std::array<double, 2>* direction() const override { return &force; }
  std::string_view direction_key() const override { return "force"; }
  WallMotion<2> motion() const override;
};

struct SprungPiston final : KindOf<SprungPiston, Piston> {
  static constexpr std::string_view kind = "spring";
  static constexpr std::string_view meaning = "a piston pulled by a spring whose far end moves at a given velocity";

  std::array<double, 2> velocity{unset, unset};  ///< [L/T] of the far end
  double stiffness = unset;                      ///< [M/T^2]

  void keys(Parameters& keys) override;
  const std::array<double, 2>* direction() const override { return &velocity; }
  std::string_view direction_key() const override { return "velocity"; }
  WallMotion<2> motion() const override;
};

}  // namespace repose
