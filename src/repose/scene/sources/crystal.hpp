// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// A crystal of spheres that exists at the start: a block or a pyramid of equal layers.
///
/// Layers are square in the structures "sc" (each sphere on top of another) and "fcc" (in the hollows of four), and
/// triangular in "hcp". A pyramid has one column and one row less in each layer than in the one below.
struct CrystalSource final : KindOf<CrystalSource, SourceKind> {
  static constexpr std::string_view kind = "crystal";
  static constexpr std::string_view meaning = "a crystal at the start: a block or a pyramid";

  std::string structure = "fcc";  ///< or "hcp", "sc"
  std::string shape = "block";    ///< or "pyramid"
  std::int64_t columns = 0;       ///< along x
  std::int64_t rows = 0;          ///< along y
  std::int64_t layers = 0;
  double gap = 0.0;     ///< [L] between spheres of the largest size
  double jitter = 0.0;  ///< displacements over half a gap
  double x = 0.0;       ///< [L]
  double y = 0.0;       ///< [L]

  bool in_dimension(std::int64_t dimension) const override { return dimension == 3; }
  void keys(const Scene& scene, Parameters& keys) override;
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t placed() const override;
  double fall(const Scene& scene) const override;
  double column(const Scene&) const override { return static_cast<double>(layers); }
  std::string describe() const override;
  using SourceKind::add_grains;
  void add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const override;

  bool is_pyramid() const { return shape == "pyramid"; }
  double pitch(const Scene& scene) const { return scene.largest_drawn() + gap; }  ///< [L] between neighbours
  double rise(const Scene& scene) const;                                          ///< [L] from layer to layer
  /// Spheres along x and y in a layer.
  std::int64_t columns_of(std::int64_t layer) const { return is_pyramid() ? columns - layer : columns; }
  std::int64_t rows_of(std::int64_t layer) const { return is_pyramid() ? rows - layer : rows; }
};

}  // namespace repose
