// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <vector>

namespace repose {

/// A triangular lattice that exists at the start: a pile, or a block.
///
/// A pile of any slope up to 60 degrees consists of the lattice centres (x, y), in pitches and rows, that lie under its
/// surface: y <= tan(slope) min(x, n - 1 - x) + 1e-9 with n grains in the lowest row, whose corner centres are at x = 0
/// and n - 1. A tent has a second slope from the distance break_at (n - 1) on, as in theory/pile_tent.hpp.
/// Source: Liffman et al. (1992), Figs. 7, 12 and 18. Validated by tests/unit/sources_test.cpp.
struct LatticeSource final : KindOf<LatticeSource, SourceKind> {
  static constexpr std::string_view kind = "lattice";
  static constexpr std::string_view meaning = "a triangular lattice at the start: a pile, or a block";

  std::int64_t rows = 0;        ///< of a block, or of a pile of 60 degrees
  std::int64_t columns = 0;     ///< of a block; 0: a pile
  double x = 0.0;               ///< [L]
  std::int64_t base_count = 0;  ///< of a pile; 0: as many as rows
  double slope = 60.0;          ///< [deg] of a pile, up to the break
  double upper_slope = 60.0;    ///< [deg] above the break
  double break_at = 0.5;        ///< of a pile: over the length of its base
  bool fixed_base = false;      ///< of a pile
  double gap = 0.0;             ///< [L] of a block, between grains of the largest size
  double jitter = 0.0;          ///< of a block: displacements over half a gap

  void keys(const Scene& scene, Parameters& keys) override;
  void check(const Scene& scene, Problems& problems) const override;
  std::int64_t placed() const override;
  double fall(const Scene& scene) const override;
  double column(const Scene&) const override;
  std::string describe() const override;
  using SourceKind::add_grains;
  void add_grains(const Scene& scene, Grains<2>& grains, std::int64_t& id) const override;

  bool is_pile() const { return columns == 0; }
  /// Its grains touch and lie in the hollows of the base: always those of a pile, and those of a block of equal grains
  /// without a gap.
  bool nests(const Scene& scene) const;
  double pitch(const Scene& scene) const;  ///< [L] between neighbours in a row
  /// Grains in each row of a pile, from the lowest up; with `fixed_base` the lowest is that of the base.
  std::vector<std::int64_t> row_counts() const;
  /// [L] x of the middle of a pile: the place nearest to `x` at which its grains lie in the hollows, or on the grains,
  /// of the base.
  double middle(const Scene& scene) const;

 private:
  void pile_keys(Parameters& keys);
  void block_keys(Parameters& keys);
  std::int64_t lowest_count() const { return base_count > 0 ? base_count : rows; }
  bool has_break() const { return break_at < 0.5; }
  double surface(double from_corner) const;
  void check_shape(Problems& problems) const;
  void check_pile(const Scene& scene, Problems& problems) const;
  void check_room(const Scene& scene, Problems& problems) const;
  void check_block(const Scene& scene, Problems& problems) const;
};

}  // namespace repose
