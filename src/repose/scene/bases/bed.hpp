// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <cmath>

namespace repose {

/// Fixed spheres of the diameter of the scene on a triangular lattice at height 0, perhaps displaced at random.
struct BedBase final : KindOf<BedBase, BaseKind> {
  static constexpr std::string_view kind = "bed";
  static constexpr std::string_view meaning = "fixed spheres of diameter d on a triangular lattice, perhaps displaced";

  double spacing = unset;  ///< [L]
  double radius = unset;   ///< [L] of the round base
  double disorder = 0.0;   ///< [L]
  double roughness = 0.0;  ///< [L]
  std::string material;

  bool suits(const MethodTraits&) const override { return true; }
  bool in_dimension(std::int64_t dimension) const override { return dimension == 3; }
  void keys(const Scene& scene, Parameters& keys) override {
    keys.number("base.spacing", spacing, {scene.grains.diameter, "d"}, positive, "L",
                "distance between the centres, one of them at x = y = 0");
    keys.number("base.radius", radius, required, positive, "L", "centres lie within this of the middle");
    keys.number("base.disorder", disorder, not_negative, "L",
                "each is displaced along x and along y by up to this, at random");
    keys.number("base.roughness", roughness, not_negative, "L",
                "centres lie at random between this below height 0 and 0");
    if (scene.method->traits().has_forces()) material_key("base.material", material, scene, keys);
  }
  void check(const Scene& scene, Problems& problems) const override;
  bool of_grains() const override { return true; }
  bool of_one_size() const override { return true; }
  double reach(const Scene&) const override { return radius; }
  std::optional<double> area_of_grain() const override { return 0.5 * std::sqrt(3.0) * spacing * spacing; }
  double depth(const Scene&) const override { return roughness; }
  double height_on_top(const Scene& scene, double diameter) const override;
  std::string describe() const override;
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const override;
};

}  // namespace repose
