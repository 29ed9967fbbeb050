// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/packs.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/pack_groups.hpp"

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

constexpr auto nobody = static_cast<std::uint32_t>(Packs::none);

/// These packs and their neighbours. A pack that needs the results of the previous one has to wait for them.
std::uint64_t with_neighbours(std::uint64_t packs) { return packs | std::rotl(packs, 1) | std::rotr(packs, 1); }

}  // namespace

/// Puts each contact of a group into the oldest open pack that contains none of its moving bodies.
class Packs::Builder {
 public:
  Builder(Packs& packs, const Problem<2>& problem)
      : to_(packs), problem_(problem), contacts_(problem.contacts), copy_of_(problem.free.size(), nobody) {
    to_.packs_.clear();
    to_.contacts_.clear();
    to_.presence_.clear();
    to_.extra_bodies_.clear();
    for (const auto& body : problem.free) to_.presence_.push_back({0, body.inverse_mass > 0.0 ? ~std::uint64_t{0} : 0});
    nothing_.lever = 0.0;
    nothing_.first_turn = 0.0;
  }

  /// `alone`: other threads may relax other groups at the same time. A body that never moves is written by each contact
  /// nevertheless, always with the same numbers. So that no other thread writes it, the group has copies of such bodies
  /// and a cache line of distance from those of other groups.
  void add_group(const std::vector<std::uint32_t>& contacts, bool alone) {
    alone_ = alone;
    if (alone) to_.extra_bodies_.insert(to_.extra_bodies_.end(), 2, nobody);
    nothing_.first = nothing_.second = extra_body(nobody);
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) put(nothing_, lane, empty_);
    add_all(contacts);
    finish();
    for (std::size_t bits = open_; bits != 0; bits = open_) close(static_cast<std::size_t>(std::countr_zero(bits)));
    for (const auto k : contacts) {
      for (const auto body : {contacts_[k].first, contacts_[k].second}) {
        to_.presence_[body].packs = 0;
        copy_of_[body] = nobody;
      }
    }
  }

 private:
  void add_all(const std::vector<std::uint32_t>& contacts) {
    while (open_count_ < window) open();
    for (const auto k : contacts) {
      const auto taken = packs_with(contacts_[k]);
      auto fitting = open_ & ~with_neighbours(taken);
      if (!fitting) fitting = open_ & ~taken;
      if (!fitting) {
        open();
        fitting = bit(to_.size() - 1);
      }
      const auto pack = oldest(fitting);
      add(k, pack);
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
        k = nobody;
        put(nothing_, lanes - 1u, to_.packs_[last]);
      }
      to_.packs_.pop_back();
      to_.contacts_.pop_back();
    }
  }

  /// The body that the packs of the group refer to.
  std::uint32_t home(std::uint32_t body) {
    if (!alone_ || problem_.free[body].inverse_mass > 0.0) return body;
    if (copy_of_[body] == nobody) copy_of_[body] = extra_body(body);
    return copy_of_[body];
  }
  std::uint32_t extra_body(std::uint32_t like) {
    to_.extra_bodies_.push_back(like);
    return static_cast<std::uint32_t>(problem_.free.size() + to_.extra_bodies_.size() - 1);
  }

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
    auto c = contacts_[k];
    auto& first = to_.presence_[c.first];
    auto& second = to_.presence_[c.second];
    first.packs |= bit(pack) & first.moves;
    second.packs |= bit(pack) & second.moves;
    c.first = home(c.first);
    c.second = home(c.second);
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
    for (const auto k : to_.contacts_[pack]) {
      if (k == nobody) continue;
      to_.presence_[contacts_[k].first].packs &= ~bit(pack);
      to_.presence_[contacts_[k].second].packs &= ~bit(pack);
    }
  }

  Packs& to_;
  const Problem<2>& problem_;
  const std::vector<ContactLine<2>>& contacts_;
  std::vector<std::uint32_t> copy_of_;  // of each body, in the group at hand
  bool alone_ = false;
  ContactLine<2> nothing_;
  ContactPack empty_;
  std::array<std::uint8_t, remembered> used_{};  // lanes
  std::uint64_t open_ = 0;
  int open_count_ = 0;
};

void Packs::build(const Problem<2>& problem, std::size_t parts) {
  REPOSE_ASSERT(!problem.pistons);
  rolling_ = problem.rolling;
  const auto groups = group_contacts(problem, parts);
  const auto count = groups.contacts.size();
  Builder builder(*this, problem);
  group_start_.assign(1, 0);
  for (const auto& group : groups.contacts) {
    builder.add_group(group, count > 1);
    group_start_.push_back(size());
  }
  colour_start_ = groups.colour_start;
}

void Packs::add_bodies(std::vector<Body<2>>& bodies) const {
  for (const auto like : extra_bodies_) bodies.push_back(like == nobody ? Body<2>{} : bodies[like]);
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

void Packs::sweep_both_ways(PackSweep sweep, const Kernels& kernels, Team& team) const {
  sweep.packs = packs_.data();
  sweep.rolling = rolling_;
  const auto colours = colour_start_.size() - 1;
  if (colour_start_.back() == 1) {
    kernels.sweep_forward(sweep, {0, size()});
    kernels.sweep_back(sweep, {0, size()});
    return;
  }
  // The packs of a colour that belong to a member of the team.
  const auto own = [&](std::size_t colour, int member) {
    const auto first = colour_start_[colour];
    const auto groups = range_of(colour_start_[colour + 1] - first, member, team.size());
    return Range{group_start_[first + groups.begin], group_start_[first + groups.end]};
  };
  team.run([&](int member) {
    for (std::size_t colour = 0; colour < colours; ++colour) {
      if (colour > 0) team.wait();
      kernels.sweep_forward(sweep, own(colour, member));
    }
    for (std::size_t colour = colours; colour-- > 0;) {
      if (colour + 1 < colours) team.wait();
      kernels.sweep_back(sweep, own(colour, member));
    }
  });
}

double Packs::separate_energy(const double* changes, const Kernels& kernels) const {
  return kernels.separate_energy(packs_.data(), changes, rolling_, packs_.size());
}

}  // namespace repose::contact_dynamics
