// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose::contact_dynamics {

/// Contacts in a pack: what the widest registers hold.
inline constexpr std::size_t pack_lanes = 8;
/// Numbers that a pack has in impulses and in changes: normal, tangent and roll of each lane, in this order.
inline constexpr std::size_t pack_numbers = 3 * pack_lanes;

/// Contacts that share no moving body, property by property: ContactLine without the impulse. Unused lanes are all zero
/// and touch only a body that never moves.
struct alignas(64) ContactPack {
  using Lanes = double[pack_lanes];
  Lanes normal_x, normal_y;
  Lanes normal_bias, tangent_bias;
  Lanes normal_mass, tangent_mass;
  Lanes friction;
  Lanes lever;
  std::uint32_t first[pack_lanes], second[pack_lanes];
  Lanes roll_mass, rolling_friction, first_turn;  // last, so that sweeps without rolling pass them over
};
static_assert(sizeof(ContactPack) == 12 * 64);

/// Which instructions a sweep uses; the results are the same to the bit.
enum class InstructionSet { baseline, avx2, avx512 };
bool has(InstructionSet set);
InstructionSet fastest_instruction_set();

/// The contacts of a problem in packs that are relaxed at once: a sweep over them gives to the bit what one over the
/// single contacts gives in the same order.
class Packs {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::uint32_t>::max();

  /// Chooses packs and their order, which follows that of the contacts closely. The problem has no pistons.
  void build(const Problem<2>& problem);

  std::size_t size() const { return packs_.size(); }
  /// Index of a contact in the problem, or `none`.
  std::size_t contact(std::size_t pack, std::size_t lane) const { return contacts_[pack][lane]; }
  const ContactPack& operator[](std::size_t pack) const { return packs_[pack]; }

  /// Impulses and changes: `pack_numbers` for each pack, aligned to 64 bytes; 0 in unused lanes.
  void load(const std::vector<ContactLine<2>>& contacts, double* impulses) const;
  void store(const double* impulses, std::vector<ContactLine<2>>& contacts) const;

  /// Relaxes all packs, first to last and back, each the mirrored way. `bodies` has one more than the problem: the last
  /// has inverse mass 0. `changes` gets the sum of both ways. `shares`: of the change of friction that is made, one for
  /// each lane, aligned to 64 bytes; nullptr: all of it.
  void sweep_to_and_fro(double* impulses, Body<2>* bodies, double* changes, const double* shares, bool rolling,
                        InstructionSet set = fastest_instruction_set()) const;

 private:
  class Builder;
  struct Presence {
    std::uint64_t packs;  // of the latest packs, those that it is in
    std::uint64_t moves;  // all bits, or none: then it is in no pack that matters
  };

  std::vector<ContactPack> packs_;
  std::vector<std::array<std::uint32_t, pack_lanes>> contacts_;
  std::vector<Presence> presence_;  // of the bodies
};

}  // namespace repose::contact_dynamics
