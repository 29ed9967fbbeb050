// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/coordinates.hpp"
#include "repose/scene/kind.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace repose {

class Problems;

/// The shape of a finite wall in three dimensions, as a scene chooses it.
class ShapeKind : public AnyKind<ShapeKind> {
 public:
  /// The keys of the wall that say where it is and how large, besides the kind.
  virtual void keys(Parameters& keys) = 0;
  /// Finds the files that the shape consists of: their names are relative to a folder. Call this before the check.
  virtual void find(const std::string& /*folder*/) {}
  /// The file that it consists of as it was found; "": none.
  virtual std::string found_file() const { return ""; }
  /// Names the copy of that file that lies beside the scene from now on.
  virtual void rename_file(const std::string& /*name*/) {}
  /// `prefix` is that of the keys, "wall[0].", and `diameter` [L] that of the scene: no length may be below 1e-6 of it.
  virtual void check(const std::string& prefix, double diameter, Problems& problems) const = 0;
  /// The wall of a sound scene, or those of its facets, at rest and of the first material.
  virtual std::vector<Wall<3>> walls() const = 0;
  virtual std::string describe() const = 0;
};

Kinds<ShapeKind>& shape_kinds();

struct DiscShape final : KindOf<DiscShape, ShapeKind> {
  static constexpr std::string_view kind = "disc";
  static constexpr std::string_view meaning = "a flat disc";

  Coordinates centre = no_coordinates;  ///< [L]
  Coordinates normal = no_coordinates;
  double radius = unset;  ///< [L]

  void keys(Parameters& keys) override;
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;
};

struct RingShape final : KindOf<RingShape, ShapeKind> {
  static constexpr std::string_view kind = "ring";
  static constexpr std::string_view meaning = "a flat disc with a round hole in its middle";

  Coordinates centre = no_coordinates;  ///< [L]
  Coordinates normal = no_coordinates;
  double inner_radius = unset;  ///< [L]
  double outer_radius = unset;  ///< [L]

  void keys(Parameters& keys) override;
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;
};

struct RectangleShape final : KindOf<RectangleShape, ShapeKind> {
  static constexpr std::string_view kind = "rectangle";
  static constexpr std::string_view meaning = "a flat rectangle between two sides that begin at one corner";

  Coordinates corner = no_coordinates;  ///< [L]
  Coordinates side_a = no_coordinates;  ///< [L]
  Coordinates side_b = no_coordinates;  ///< [L]

  void keys(Parameters& keys) override;
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;
};

struct CylinderShape final : KindOf<CylinderShape, ShapeKind> {
  static constexpr std::string_view kind = "cylinder";
  static constexpr std::string_view meaning = "the side of a cylinder, without lids";

  Coordinates from = no_coordinates;  ///< [L]
  Coordinates to = no_coordinates;    ///< [L]
  double radius = unset;              ///< [L]

  void keys(Parameters& keys) override;
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;
};

struct ConicalShape final : KindOf<ConicalShape, ShapeKind> {
  static constexpr std::string_view kind = "cone";
  static constexpr std::string_view meaning = "the side of a cone, whole or cut, without lids";

  Coordinates from = no_coordinates;  ///< [L]
  Coordinates to = no_coordinates;    ///< [L]
  double radius_from = unset;         ///< [L]
  double radius_to = unset;           ///< [L]

  void keys(Parameters& keys) override;
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;
};

struct SurfaceShape final : KindOf<SurfaceShape, ShapeKind> {
  static constexpr std::string_view kind = "surface";
  static constexpr std::string_view meaning = "the triangles of an STL file";

  std::string file;
  double scale = 1.0;
  Coordinates shift{};  ///< [L]

  void keys(Parameters& keys) override;
  void find(const std::string& folder) override;
  std::string found_file() const override { return path.empty() ? file : path; }
  void rename_file(const std::string& name) override { file = name; }
  void check(const std::string& prefix, double diameter, Problems& problems) const override;
  std::vector<Wall<3>> walls() const override;
  std::string describe() const override;

  std::string path;  ///< where the file was found; empty: under its name
};

}  // namespace repose
