// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// A plane at height 0.
struct PlaneBase final : KindOf<PlaneBase, BaseKind> {
  static constexpr std::string_view kind = "plane";
  static constexpr std::string_view meaning = "a plane";

  bool smooth = false;
  std::string material;

  void keys(const Scene& scene, Parameters& keys) override {
    keys.flag("base.smooth", smooth, "no friction, and the height of the centre as distance (Baxter et al. 1997)");
    material_key("base.material", material, scene, keys);
  }
  bool carries_pile() const override { return true; }
  double height_on_top(const Scene&, double diameter) const override { return smooth ? diameter : 0.5 * diameter; }
  std::optional<BasePlane> wall(const Scene& scene) const override {
    return BasePlane{smooth, scene.material_number(material)};
  }
  bool in_dimension(std::int64_t) const override { return true; }
  std::string describe() const override { return smooth ? "smooth plane" : "plane"; }
};

/// Nothing: walls and placed grains are all that there is.
struct NoBase final : KindOf<NoBase, BaseKind> {
  static constexpr std::string_view kind = "none";
  static constexpr std::string_view meaning = "nothing";

  void keys(const Scene&, Parameters&) override {}
  bool in_dimension(std::int64_t) const override { return true; }
};

}  // namespace repose
