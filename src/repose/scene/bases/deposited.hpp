// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Fixed discs of the sizes of the other grains, each touching the next, at random heights.
struct DepositedBase final : KindOf<DepositedBase, BaseKind> {
  static constexpr std::string_view kind = "deposited";
  static constexpr std::string_view meaning =
      "fixed discs of the sizes of the other grains, each touching the next, at random heights";

  double roughness = unset;   ///< [L] how far centres lie below height 0 at most
  double half_width = unset;  ///< [L]
  std::string material;

  void keys(const Scene& scene, Parameters& keys) override {
    keys.number("base.roughness", roughness, {0.25 * scene.smallest_drawn(), "a quarter of the smallest diameter"},
                not_negative, "L", "centres lie between this below height 0 and 0; at most half the smallest diameter");
    keys.number("base.half_width", half_width, required, positive, "L", "the base covers +- this");
    material_key("base.material", material, scene, keys);
  }
  void check(const Scene& scene, Problems& problems) const override;
  bool of_grains() const override { return true; }
  double reach(const Scene&) const override { return half_width; }
  double depth(const Scene&) const override { return roughness; }
  double height_on_top(const Scene&, double diameter) const override { return diameter; }
  std::string describe() const override;
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;
};

}  // namespace repose
