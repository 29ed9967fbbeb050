// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Fixed spheres that were dropped at random on a level floor and rolled to rest: those that lie at the surface of the
/// deposit. Discs have a base of this name too (deposited.hpp).
struct DepositedBed final : KindOf<DepositedBed, BaseKind> {
  static constexpr std::string_view kind = "deposited";
  static constexpr std::string_view meaning =
      "fixed spheres of the sizes of the other grains at the surface of a random deposit";

  double radius = unset;  ///< [L] of the round base
  std::string material;

  bool in_dimension(std::int64_t dimension) const override { return dimension == 3; }
  void keys(const Scene& scene, Parameters& keys) override {
    keys.number("base.radius", radius, required, positive, "L", "centres lie within this of the middle");
    material_key("base.material", material, scene, keys);
  }
  void check(const Scene& scene, Problems& problems) const override;
  bool of_grains() const override { return true; }
  double reach(const Scene&) const override { return radius; }
  double depth(const Scene& scene) const override;
  double height_on_top(const Scene& scene, double diameter) const override;
  std::string describe() const override;
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const override;
};

}  // namespace repose
