// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/team.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// How far a pair list looks.
struct PairReach {
  double cutoff = 1.0;   ///< a pair interacts closer than cutoff (R_i + R_j)
  double skin = 0.3;     ///< [L] extra distance within which pairs are listed
  double horizon = 0.0;  ///< [T] fast grains list what they can meet within this time, so that they force no rebuild
  double gravity = 0.0;  ///< [L/T^2] by which they may speed up meanwhile
  bool rolling = false;  ///< pairs remember a rolling displacement too
};

/// Pairs of grains that may touch before the list is next built: for each grain i its partners j > i in memory order,
/// ascending, each with the history of the contact beside it. Pairs of two fixed grains are left out.
///
/// The list stays valid while every grain has moved less than its allowance since the list was built: half the skin,
/// and for fast grains the way they go within the horizon besides.
template <int D>
class PairList {
 public:
  explicit PairList(const PairReach& reach) : reach_(reach) {}

  /// Sorts the grains by place, drops those that have left the box and lists the pairs; histories of pairs that were
  /// listed before are kept. Grains added since are at the end of the arrays. Returns, for each grain in its new place,
  /// where it was before.
  std::vector<std::uint32_t> build(Grains<D>& grains, const Box<D>& box, Team& team);

  /// Forces the next `stale` to say yes: grains were added.
  void invalidate() { valid_ = false; }

  /// Whether it is of the grains as they are; else it is built before the next step.
  bool valid() const { return valid_; }

  /// To be told after every step how far the fastest grain went [L].
  void moved(double furthest) { travelled_ += furthest; }

  /// Whether a cheap bound allows the list to be out of date; then `stale` decides.
  bool suspect() const { return !valid_ || travelled_ > slack_; }

  /// Looks at the true displacements: whether the list must be built again before the next forces. Anything else that
  /// moves, as a wall does, has gone `other_way` [L] since the list was built. With a time `ahead` [T], places are
  /// those that velocities will have brought about by then: for a method that must know whom a step may bring together.
  bool stale(const Grains<D>& grains, double other_way = 0.0, double ahead = 0.0);

  /// How far a grain may go from where it was when the list was built [L]: half the skin, more for fast ones.
  double allowance(std::size_t i) const { return allowance_[i]; }

  void exchange(Archive& archive) {
    archive.value("pairs/valid", valid_);
    archive.value("pairs/travelled", travelled_);
    archive.value("pairs/slack", slack_);
    archive.value("pairs/builds", builds_);
    archive.value("pairs/bandwidth", bandwidth);
    archive.array("pairs/built_at", built_at_);
    archive.array("pairs/allowance", allowance_);
    archive.array("pairs/row_start", row_start);
    archive.array("pairs/partner", partner);
    archive.array("pairs/history", history);
    archive.array("pairs/roll", roll);
    archive.check("pairs/partner", row_start.empty() ? partner.empty() : row_start.back() == partner.size());
    archive.check("pairs/history", history.size() == partner.size());
  }

  std::size_t rows() const { return row_start.empty() ? 0 : row_start.size() - 1; }
  std::size_t pairs() const { return partner.size(); }
  long builds() const { return builds_; }
  double travelled() const { return travelled_; }  ///< [L] bound on the displacement of any grain since the last check
  void set_travelled(double furthest) { travelled_ = furthest; }
  double slack() const { return slack_; }

  /// Pairs whose places in memory lie further apart than this are far pairs; `bandwidth` is the widest of the others.
  static constexpr std::uint32_t far = 1U << 15;
  std::uint32_t bandwidth = 0;

  std::vector<std::uint32_t> row_start;  ///< (n + 1) first pair of each grain
  std::vector<std::uint32_t> partner;    ///< (pairs) memory place of j
  std::vector<Tangent<D>> history;       ///< (pairs) [L] tangential displacement; zero when the pair is apart
  std::vector<Tangent<D>> roll;          ///< (pairs) [L] rolling displacement; empty unless asked for

 private:
  struct Extra {
    std::uint32_t low;
    std::uint32_t high;
  };
  double listed_within(const Grains<D>& grains, std::uint32_t i, std::uint32_t j) const {
    return reach_.cutoff * (grains.line[i].radius + grains.line[j].radius) + reach_.skin;
  }
  double set_allowances(const Grains<D>& grains);
  template <class Grid>
  std::vector<Extra> pairs_of_fast_grains(const Grains<D>& grains, const Box<D>& box, const Grid& grid,
                                          double furthest_travel) const;
  template <class Grid>
  void list_row(const Grains<D>& grains, const Box<D>& box, const Grid& grid, std::uint32_t i,
                std::vector<std::uint32_t>& row) const;

  PairReach reach_;
  bool valid_ = false;
  double travelled_ = 0.0;  // bound on the way of any grain since the last look
  double slack_ = 0.0;      // how far any grain may go after the last look
  long builds_ = 0;
  std::vector<Vec<D>> built_at_;   // positions when the list was built
  std::vector<double> allowance_;  // [L] how far each grain may go from there
};

}  // namespace repose
