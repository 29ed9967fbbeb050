// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/team.hpp"
#include "repose/neighbours/cell_grid.hpp"
#include "repose/neighbours/spots.hpp"
#include "repose/neighbours/wide_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The distances and times that decide which pairs are listed.
struct PairReach {
  double cutoff = 1.0;    ///< a pair interacts if it is closer than cutoff (R_i + R_j)
  double skin = 0.3;      ///< [L] pairs up to this much farther apart are listed too
  double horizon = 0.0;   ///< [T] fast grains list all grains that they may reach within this time
  double gravity = 0.0;   ///< [L/T^2] acceleration of fast grains during the horizon
  bool rolling = false;   ///< whether pairs keep a rolling displacement too
  bool bonds = false;     ///< whether pairs keep that they are bonded
  bool twisting = false;  ///< whether pairs keep a displacement about their normal too
};

/// Pairs of grains that may touch before the list is next built. For each grain i it lists the partners j > i in memory
/// order, ascending, each with the slip displacement of the contact. Pairs of two fixed grains are left out.
///
/// The list stays valid while every grain has moved less than its allowance since the list was built. The allowance is
/// half the skin; for a fast grain the distance that it may move within the horizon is added.
template <int D>
class PairList {
 public:
  explicit PairList(const PairReach& reach) : reach_(reach) {}

  /// Sorts the grains by position, drops those that have left the box and lists the pairs. Pairs that were listed
  /// before keep their displacements. Grains added since the last build must be at the end of the arrays. Returns the
  /// old index of each grain, in the new order. All arrays of the list before are used again.
  const std::vector<std::uint32_t>& build(Grains<D>& grains, const Box<D>& box, Team& team);

  /// Call this when grains were added: the list is then stale.
  void invalidate() { valid_ = false; }

  /// Whether the list belongs to the present grains. If not, it is built before the next step.
  bool valid() const { return valid_; }

  /// Call this after every step with the largest displacement of a grain in it [L].
  void moved(double furthest) { travelled_ += furthest; }

  /// Whether the list may be stale by a cheap bound. If so, `stale` decides.
  bool may_be_stale() const { return !valid_ || travelled_ > slack_; }

  /// Whether the list must be built again before the next forces, from the true displacements. `wall_displacement` [L]
  /// is the largest displacement of a wall since the list was built. With `ahead` [T], positions are extrapolated by
  /// that time with the present velocities, for a method that needs the pairs which a step may bring together.
  bool stale(const Grains<D>& grains, double wall_displacement = 0.0, double ahead = 0.0);

  /// The same where `position(k)` is that of grain k, for a method that moves copies of the grains.
  template <class Position>
  bool stale_at(const Position& position, double wall_displacement) {
    if (!valid_) return true;
    const double half_skin = 0.5 * reach_.skin;
    double least = half_skin - wall_displacement;
    double furthest2 = 0.0;  // of grains that are not fast, which share one allowance and one root
    for (std::size_t k = 0; k < built_at_.size(); ++k) {
      const Vec<D> d = position(k) - built_at_[k];
      const double distance2 = dot(d, d);
      if (allowance_[k] > half_skin) {
        least = std::min(least, allowance_[k] - std::sqrt(distance2));
      } else {
        furthest2 = std::max(furthest2, distance2);
      }
    }
    least = std::min(least, half_skin - std::sqrt(furthest2));
    // With so little left, the next check would come after one step.
    if (least < 0.05 * reach_.skin) return true;
    slack_ = least;
    travelled_ = 0.0;
    return false;
  }

  /// The distance [L] that a grain may move from its position at the last build: half the skin, more for a fast grain.
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
    archive.array("pairs/history", slip);
    archive.array("pairs/roll", roll);
    if (reach_.twisting) archive.array("pairs/twist", twist);
    if (reach_.bonds) archive.array("pairs/bonded", bonded);
    archive.check("pairs/partner", row_start.empty() ? partner.empty() : row_start.back() == partner.size());
    archive.check("pairs/history", slip.size() == partner.size());
    archive.check("pairs/twist", twist.size() == (reach_.twisting ? partner.size() : 0));
    archive.check("pairs/bonded", bonded.size() == (reach_.bonds ? partner.size() : 0));
    if (archive.restoring()) any_far = has_far_pairs();
  }

  std::size_t rows() const { return row_start.empty() ? 0 : row_start.size() - 1; }
  std::size_t pairs() const { return partner.size(); }
  long builds() const { return builds_; }
  double travelled() const { return travelled_; }  ///< [L] bound on the displacement of any grain since the last check
  void set_travelled(double furthest) { travelled_ = furthest; }
  double slack() const { return slack_; }

  /// A pair whose indices differ by more than this is a far pair; `bandwidth` is the largest difference in the others.
  static constexpr std::uint32_t far = 1U << 15;
  std::uint32_t bandwidth = 0;
  bool any_far = false;  ///< whether the list has far pairs

  std::vector<std::uint32_t> row_start;  ///< (n + 1) first pair of each grain
  std::vector<std::uint32_t> partner;    ///< (pairs) index of j
  std::vector<Tangent<D>> slip;          ///< (pairs) [L] slip displacement; zero while the pair is apart
  std::vector<Tangent<D>> roll;          ///< (pairs) [L] rolling displacement; empty unless `PairReach::rolling`
  std::vector<double> twist;         ///< (pairs) [L] displacement about the normal; empty unless `PairReach::twisting`
  std::vector<std::uint8_t> bonded;  ///< (pairs) 1: bonded; empty unless `PairReach::bonds`

 private:
  /// What is kept of a pair from one list to the next.
  struct Kept {
    std::vector<std::uint32_t> row_start;
    std::vector<std::uint32_t> partner;
    std::vector<Tangent<D>> slip;
    std::vector<Tangent<D>> roll;
    std::vector<double> twist;
    std::vector<std::uint8_t> bonded;
  };
  /// The rows that one member lists.
  struct Part {
    std::vector<std::uint32_t> partner;  // of these rows, then room for more
    std::size_t pairs = 0;
    std::uint32_t bandwidth = 0;

    void make_room(std::size_t count) {
      if (partner.size() < count) partner.resize(2 * count);
    }
  };

  bool has_far_pairs() const {
    for (std::size_t i = 0; i < rows(); ++i) {
      if (row_start[i] < row_start[i + 1] && partner[row_start[i + 1] - 1] - i > far) return true;
    }
    return false;
  }
  void sort_grains(Grains<D>& grains, const Box<D>& box);
  void note_spots(const Grains<D>& grains, double furthest);
  void list_rows(const Grains<D>& grains, const Box<D>& box, const Range& rows, Part& part);
  void keep_displacements(const Range& rows, Part& part);

  PairReach reach_;
  bool valid_ = false;
  double travelled_ = 0.0;  // [L] bound on the displacement of any grain since the last check of true displacements
  double slack_ = 0.0;      // [L] displacement that every grain was still allowed at that check
  long builds_ = 0;
  std::vector<Vec<D>> built_at_;   // [L] positions at the last build
  std::vector<double> allowance_;  // [L] allowed displacement of each grain from there

  // Working memory.
  Spots<D> spots_;
  bool any_large_ = false;
  bool any_fast_ = false;
  WidePairs<D> wide_;
  CellGrid<D> grid_;
  std::vector<Vec<D>> positions_;
  std::vector<std::uint32_t> present_;
  std::vector<std::uint32_t> order_;
  Grains<D> spare_;
  Kept old_;
  std::vector<Part> parts_;
};

}  // namespace repose
