// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// A row of fixed discs of the diameter of the scene with centres at height 0.
struct RowBase final : KindOf<RowBase, BaseKind> {
  static constexpr std::string_view kind = "row";
  static constexpr std::string_view meaning = "fixed discs of diameter d side by side, one of them at x = 0";

  double spacing = unset;     ///< [L]
  double half_width = unset;  ///< [L]
  std::string material;

  void keys(const Scene& scene, Parameters& keys) override {
    keys.number("base.spacing", spacing, {scene.grains.diameter, "d"}, positive, "L",
                "distance between the centres, one of them at x = 0");
    keys.number("base.half_width", half_width, required, positive, "L", "the row covers +- this");
    material_key("base.material", material, scene, keys);
  }
  void check(const Scene& scene, Problems& problems) const override;
  bool of_grains() const override { return true; }
  bool of_one_size() const override { return true; }
  double reach(const Scene&) const override { return half_width; }
  bool carries_pile() const override { return true; }
  std::optional<double> pitch() const override { return spacing; }
  double height_on_top(const Scene& scene, double diameter) const override;
  std::string describe() const override;
  using BaseKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;
};

}  // namespace repose
