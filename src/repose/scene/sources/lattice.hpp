// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// A triangular lattice that exists at the start: a pile, or a block.
struct LatticeSource final : KindOf<LatticeSource, SourceKind> {
  static constexpr std::string_view kind = "lattice";
  static constexpr std::string_view meaning = "a triangular lattice at the start: a pile, or a block";

  std::int64_t rows = 0;
  std::int64_t columns = 0;  ///< of a block; 0: a pile
  double x = 0.0;            ///< [L]
  double gap = 0.0;          ///< [L] of a block, between grains of the largest size
  double jitter = 0.0;       ///< of a block: displacements over half a gap

  void keys(const Scene&, Parameters& keys) override {
    keys.integer(
        "source.rows", rows, std::nullopt, {.low = 1},
        "rows of a block, or of a 60-degree pile with as many grains in its lowest row and one less in each above");
    keys.integer("source.columns", columns, {.low = 0}, "grains in each row of a block; 0: a pile");
    keys.number("source.x", x, any, "L", "place of the apex, or of the middle of the block");
    if (is_pile()) return;
    keys.number("source.gap", gap, not_negative, "L", "gap between grains of the largest size");
    keys.number("source.jitter", jitter, zero_to_one, "",
                "each grain is displaced by up to this times half the gap, so that none touch");
  }
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t placed() const override { return rows * (columns > 0 ? columns : (rows + 1) / 2); }
  double fall(const Scene& scene) const override;
  double column(const Scene&) const override { return static_cast<double>(rows); }
  std::string describe() const override;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;

  bool is_pile() const { return columns == 0; }
  /// Its grains touch and lie in the hollows of the base: always those of a pile, and those of a block of equal grains
  /// without a gap.
  bool nests(const Scene& scene) const;
  double pitch(const Scene& scene) const;  ///< [L] between neighbours in a row

 private:
  void check_pile(const Scene& scene, Problems& problems) const;
  void check_block(const Scene& scene, Problems& problems) const;
};

}  // namespace repose
