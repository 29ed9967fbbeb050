// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/team.hpp"
#include "repose/methods/contact_dynamics/problem.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::contact_dynamics {

/// The number of contacts in a pack: that of doubles in the widest registers.
inline constexpr std::size_t pack_lanes = 8;
/// The number of entries of a pack in impulses and in changes: normal of all lanes, then tangent, then roll if any
/// contact resists rolling.
REPOSE_FN constexpr std::size_t pack_numbers(bool rolling) { return (rolling ? 3 : 2) * pack_lanes; }

/// Contacts without a common moving body, property by property: the fields of ContactLine without the impulse. Unused
/// lanes are zero and refer to a body that never moves.
struct alignas(64) ContactPack {
  using Lanes = double[pack_lanes];
  Lanes normal_x, normal_y;
  Lanes normal_bias, tangent_bias;
  Lanes normal_mass, tangent_mass;
  Lanes friction;
  Lanes lever;
  std::uint32_t first[pack_lanes], second[pack_lanes];
  Lanes roll_mass, rolling_friction, first_turn;  // last, so that sweeps without rolling do not load them
};
static_assert(sizeof(ContactPack) == 12 * 64);

struct Kernels;
struct PackSweep;

/// The contacts of a problem in packs, each relaxed at once. A sweep over packs gives the same bits as one over the
/// single contacts in the same order.
class Packs {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::uint32_t>::max();

  /// Chooses the packs and their order, which follows that of the contacts closely within each of `parts` of the
  /// problem (see PackGroups). The problem must have no pistons.
  void build(const Problem<2>& problem, std::size_t parts = 1);

  /// Appends to the bodies of the problem those that the packs refer to beside them: bodies of unused lanes, with
  /// inverse mass 0, and copies of bodies that never move.
  void add_bodies(std::vector<Body<2>>& bodies) const;

  std::size_t size() const { return packs_.size(); }
  /// Index of a contact in the problem, or `none`.
  std::size_t contact(std::size_t pack, std::size_t lane) const { return contacts_[pack][lane]; }
  const ContactPack& operator[](std::size_t pack) const { return packs_[pack]; }

  /// Impulses and changes: `numbers()` for each pack, aligned to 64 bytes; 0 in unused lanes. Without rolling
  /// resistance, rolling impulses stay as they are.
  std::size_t numbers() const { return pack_numbers(rolling_); }
  void load(const std::vector<ContactLine<2>>& contacts, double* impulses) const;
  void store(const double* impulses, std::vector<ContactLine<2>>& contacts) const;

  /// Relaxes all packs, first to last and back, the second time in mirrored order. The bodies of the sweep are
  /// those of the problem and of `add_bodies`. The change in its history gets the sum of the changes of both
  /// directions. Its packs are set here, and whether
  /// they roll.
  /// The members of the team share each colour of groups; the result is the same for any number of them.
  void sweep_both_ways(PackSweep sweep, const Kernels& kernels, Team& team) const;

  /// The sum of the separate energies of changes, contact by contact in the order of the packs.
  double separate_energy(const double* changes, const Kernels& kernels) const;

 private:
  class Builder;
  struct Presence {
    std::uint64_t packs;  // bits of the latest packs that contain the body
    std::uint64_t
        moves;  // all bits if the body moves, else none: a body that never moves may be in any number of packs
  };

  bool rolling_ = true;
  std::vector<ContactPack> packs_;
  std::vector<std::size_t> group_start_;     // (groups + 1) first pack of each group
  std::vector<std::size_t> colour_start_;    // (colours + 1) first group of each colour
  std::vector<std::uint32_t> extra_bodies_;  // that follow those of the problem: copies of these, or `none`
  std::vector<std::array<std::uint32_t, pack_lanes>> contacts_;
  std::vector<Presence> presence_;  // one entry per body
};

}  // namespace repose::contact_dynamics
