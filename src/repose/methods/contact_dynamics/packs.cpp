// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/packs.hpp"

#include "repose/core/errors.hpp"
#include "repose/methods/contact_dynamics/pack_sweep.hpp"

#include <algorithm>
#include <bit>

namespace repose::contact_dynamics {

namespace {

/// Packs that are open at a time, and packs that are remembered, one bit each. Few keep near the order of the contacts.
constexpr unsigned window = 32;
constexpr unsigned remembered = 64;

void put(const ContactLine<2>& c, std::size_t lane, ContactPack& pack) {
  pack.normal_x[lane] = c.normal[0];
  pack.normal_y[lane] = c.normal[1];
  pack.normal_bias[lane] = c.normal_bias;
  pack.tangent_bias[lane] = c.tangent_bias;
  pack.normal_mass[lane] = c.normal_mass;
  pack.tangent_mass[lane] = c.tangent_mass;
  pack.friction[lane] = c.friction;
  pack.lever[lane] = c.lever;
  pack.first[lane] = c.first;
  pack.second[lane] = c.second;
  pack.roll_mass[lane] = c.roll_mass;
  pack.rolling_friction[lane] = c.rolling_friction;
  pack.first_turn[lane] = c.first_turn;
}

/// The packs beside these: the results of a pack are waited for where the next one needs them.
std::uint64_t with_neighbours(std::uint64_t packs) { return packs | std::rotl(packs, 1) | std::rotr(packs, 1); }

}  // namespace

bool has([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
  if (set == InstructionSet::avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return set == InstructionSet::baseline;
}

InstructionSet fastest_instruction_set() {
  static const InstructionSet fastest = has(InstructionSet::avx512) ? InstructionSet::avx512
                                        : has(InstructionSet::avx2) ? InstructionSet::avx2
                                                                    : InstructionSet::baseline;
  return fastest;
}

void Packs::build(const Problem<2>& problem) {
  REPOSE_ASSERT(!problem.pistons);
  const auto idle = static_cast<std::uint32_t>(problem.free.size());
  packs_.clear();
  contacts_.clear();
  near_.assign(problem.free.size(), 0);
  std::array<std::uint8_t, remembered> used{};  // lanes
  std::uint64_t open = 0;                       // pack k is bit k modulo `remembered`
  const auto forget = [&](std::size_t pack) {
    const auto bit = ~(std::uint64_t{1} << pack % remembered);
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
      if (contacts_[pack][lane] == none) break;
      near_[packs_[pack].first[lane]] &= bit;
      near_[packs_[pack].second[lane]] &= bit;
    }
  };
  const auto open_one = [&] {
    const auto pack = packs_.size();
    if (pack >= window) open &= ~(std::uint64_t{1} << (pack - window) % remembered);
    if (pack >= remembered) forget(pack - remembered);
    auto& fresh = packs_.emplace_back();
    std::fill_n(fresh.first, pack_lanes, idle);
    std::fill_n(fresh.second, pack_lanes, idle);
    contacts_.emplace_back().fill(none);
    open |= std::uint64_t{1} << pack % remembered;
    used[pack % remembered] = 0;
  };
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    const auto& c = problem.contacts[k];
    const bool first_moves = problem.free[c.first].inverse_mass > 0.0;
    const bool second_moves = problem.free[c.second].inverse_mass > 0.0;
    const auto taken = (first_moves ? near_[c.first] : 0) | (second_moves ? near_[c.second] : 0);
    auto fitting = open & ~with_neighbours(taken);
    if (!fitting) fitting = open & ~taken;
    if (!fitting) {
      open_one();
      fitting = std::uint64_t{1} << (packs_.size() - 1) % remembered;
    }
    // The oldest that fits.
    const auto start = static_cast<int>(packs_.size() % remembered);
    const auto age = std::countr_zero(std::rotr(fitting, start));
    const auto bit = (static_cast<unsigned>(start) + static_cast<unsigned>(age)) % remembered;
    const auto pack = packs_.size() - remembered + static_cast<std::size_t>(age);
    const std::size_t lane = used[bit]++;
    put(c, lane, packs_[pack]);
    contacts_[pack][lane] = static_cast<std::uint32_t>(k);
    if (first_moves) near_[c.first] |= std::uint64_t{1} << bit;
    if (second_moves) near_[c.second] |= std::uint64_t{1} << bit;
    if (used[bit] == pack_lanes) open &= ~(std::uint64_t{1} << bit);
  }
}

void Packs::load(const std::vector<ContactLine<2>>& contacts, double* impulses) const {
  std::fill_n(impulses, pack_numbers * size(), 0.0);
  for (std::size_t pack = 0; pack < size(); ++pack, impulses += pack_numbers) {
    for (std::size_t lane = 0; lane < pack_lanes && contact(pack, lane) != none; ++lane) {
      const auto& impulse = contacts[contact(pack, lane)].impulse;
      impulses[lane] = impulse.normal;
      impulses[pack_lanes + lane] = impulse.tangent;
      impulses[2 * pack_lanes + lane] = impulse.roll;
    }
  }
}

void Packs::store(const double* impulses, std::vector<ContactLine<2>>& contacts) const {
  for (std::size_t pack = 0; pack < size(); ++pack, impulses += pack_numbers) {
    for (std::size_t lane = 0; lane < pack_lanes && contact(pack, lane) != none; ++lane) {
      contacts[contact(pack, lane)].impulse = {impulses[lane], impulses[pack_lanes + lane],
                                               impulses[2 * pack_lanes + lane]};
    }
  }
}

void Packs::sweep_to_and_fro(double* impulses, Body<2>* bodies, double* changes, const double* shares, bool rolling,
                             InstructionSet set) const {
  const PackSweep sweep{packs_.data(), packs_.size(), impulses, bodies, changes, shares, rolling};
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return sweep_avx512(sweep);
  if (set == InstructionSet::avx2) return sweep_avx2(sweep);
#endif
  REPOSE_ASSERT(set == InstructionSet::baseline);
  sweep_baseline(sweep);
}

}  // namespace repose::contact_dynamics
