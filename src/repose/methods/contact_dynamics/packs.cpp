// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/packs.hpp"

#include "repose/core/errors.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"

#include <algorithm>
#include <bit>

namespace repose::contact_dynamics {

namespace {

/// The number of latest packs whose bodies are remembered: pack k is bit k modulo 64.
constexpr std::size_t remembered = 64;
/// The smallest number of open packs, so that a contact can avoid the packs next to those of its bodies. More open
/// packs do not make sweeps faster; fewer keep closer to the order of the contacts.
constexpr int window = 12;

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

/// These packs and their neighbours. A pack that needs the results of the previous one has to wait for them.
std::uint64_t with_neighbours(std::uint64_t packs) { return packs | std::rotl(packs, 1) | std::rotr(packs, 1); }

}  // namespace

/// Puts each contact into the oldest open pack that contains none of its moving bodies.
class Packs::Builder {
 public:
  Builder(Packs& packs, const Problem<2>& problem) : to_(packs), contacts_(problem.contacts) {
    to_.packs_.clear();
    to_.contacts_.clear();
    to_.presence_.clear();
    for (const auto& body : problem.free) to_.presence_.push_back({0, body.inverse_mass > 0.0 ? ~std::uint64_t{0} : 0});
    // The body that unused lanes refer to.
    to_.presence_.push_back({0, 0});
    nothing_.lever = 0.0;
    nothing_.first_turn = 0.0;
    nothing_.first = nothing_.second = static_cast<std::uint32_t>(problem.free.size());
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) put(nothing_, lane, empty_);
  }

  void add_all() {
    while (open_count_ < window) open();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto taken = packs_with(contacts_[k]);
      auto fitting = open_ & ~with_neighbours(taken);
      if (!fitting) fitting = open_ & ~taken;
      if (!fitting) {
        open();
        fitting = bit(to_.size() - 1);
      }
      const auto pack = oldest(fitting);
      add(static_cast<std::uint32_t>(k), pack);
      if (used(pack) < pack_lanes) continue;
      close(pack);
      if (open_count_ < window) open();
    }
  }

  /// Empties the last packs as far as earlier packs have room.
  void finish() {
    while (to_.size() > 0 && (open_ & bit(to_.size() - 1))) {
      const auto last = to_.size() - 1;
      close(last);
      for (auto& lanes = used(last); lanes > 0; --lanes) {
        auto& k = to_.contacts_[last][lanes - 1u];
        const auto fitting = open_ & ~packs_with(contacts_[k]);
        if (!fitting) return;
        const auto pack = oldest(fitting);
        add(k, pack);
        if (used(pack) == pack_lanes) close(pack);
        k = static_cast<std::uint32_t>(none);
        put(nothing_, lanes - 1u, to_.packs_[last]);
      }
      to_.packs_.pop_back();
      to_.contacts_.pop_back();
    }
  }

 private:
  static std::uint64_t bit(std::size_t pack) { return std::uint64_t{1} << pack % remembered; }
  std::uint8_t& used(std::size_t pack) { return used_[pack % remembered]; }

  /// The packs that contain a moving body of the contact.
  std::uint64_t packs_with(const ContactLine<2>& c) const {
    return to_.presence_[c.first].packs | to_.presence_[c.second].packs;
  }

  std::size_t oldest(std::uint64_t packs) const {
    const auto start = to_.size() % remembered;
    const auto after = static_cast<std::size_t>(std::countr_zero(std::rotr(packs, static_cast<int>(start))));
    return to_.size() - remembered + after;
  }

  void add(std::uint32_t k, std::size_t pack) {
    const auto& c = contacts_[k];
    auto& first = to_.presence_[c.first];
    auto& second = to_.presence_[c.second];
    first.packs |= bit(pack) & first.moves;
    second.packs |= bit(pack) & second.moves;
    const std::size_t lane = used(pack)++;
    put(c, lane, to_.packs_[pack]);
    to_.contacts_[pack][lane] = k;
  }

  void open() {
    const auto pack = to_.size();
    if (open_ & bit(pack)) close(pack);  // the old pack with the same bit
    if (pack >= remembered) forget(pack - remembered);
    to_.packs_.push_back(empty_);
    to_.contacts_.emplace_back().fill(none);
    used(pack) = 0;
    open_ |= bit(pack);
    ++open_count_;
  }

  void close(std::size_t pack) {
    open_ &= ~bit(pack);
    --open_count_;
  }

  void forget(std::size_t pack) {
    for (const auto k : to_.packs_[pack].first) to_.presence_[k].packs &= ~bit(pack);
    for (const auto k : to_.packs_[pack].second) to_.presence_[k].packs &= ~bit(pack);
  }

  Packs& to_;
  const std::vector<ContactLine<2>>& contacts_;
  ContactLine<2> nothing_;
  ContactPack empty_;
  std::array<std::uint8_t, remembered> used_{};  // lanes
  std::uint64_t open_ = 0;
  int open_count_ = 0;
};

void Packs::build(const Problem<2>& problem) {
  REPOSE_ASSERT(!problem.pistons);
  rolling_ = problem.rolling;
  Builder builder(*this, problem);
  builder.add_all();
  builder.finish();
}

void Packs::load(const std::vector<ContactLine<2>>& contacts, double* impulses) const {
  std::fill_n(impulses, numbers() * size(), 0.0);
  for (std::size_t pack = 0; pack < size(); ++pack, impulses += numbers()) {
    for (std::size_t lane = 0; lane < pack_lanes && contact(pack, lane) != none; ++lane) {
      const auto& impulse = contacts[contact(pack, lane)].impulse;
      impulses[lane] = impulse.normal;
      impulses[pack_lanes + lane] = impulse.tangent;
      if (rolling_) impulses[2 * pack_lanes + lane] = impulse.roll;
    }
  }
}

void Packs::store(const double* impulses, std::vector<ContactLine<2>>& contacts) const {
  for (std::size_t pack = 0; pack < size(); ++pack, impulses += numbers()) {
    for (std::size_t lane = 0; lane < pack_lanes && contact(pack, lane) != none; ++lane) {
      auto& impulse = contacts[contact(pack, lane)].impulse;
      impulse.normal = impulses[lane];
      impulse.tangent = impulses[pack_lanes + lane];
      if (rolling_) impulse.roll = impulses[2 * pack_lanes + lane];
    }
  }
}

void Packs::sweep_both_ways(PackSweep sweep, const Kernels& kernels) const {
  sweep.packs = packs_.data();
  sweep.rolling = rolling_;
  kernels.sweep_forward(sweep, {0, packs_.size()});
  kernels.sweep_back(sweep, {0, packs_.size()});
}

double Packs::separate_energy(const double* changes, const Kernels& kernels) const {
  return kernels.separate_energy(packs_.data(), changes, rolling_, packs_.size());
}

}  // namespace repose::contact_dynamics
