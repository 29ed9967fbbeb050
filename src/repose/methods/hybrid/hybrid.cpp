// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/hybrid.hpp"

#include "repose/methods/hybrid/relax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace repose {

using hybrid::nobody;
using hybrid::Touch;
using hybrid::wall_of;

namespace {

constexpr int most_halvings = 6;
constexpr double deepest_overlap = 0.75;  // as for other methods, of the sum of the radii
constexpr double touching = 1e-6;         // gap of grains that touch at the start, over the sum of their radii
constexpr double work_of_a_call = 2e5;    // grain-steps, about a second

}  // namespace

Hybrid::Hybrid(const ImpulseLaws& laws, const HybridSettings& settings)
    : laws_(laws),
      settings_(settings),
      gravity_(settings.gravity),
      wall_states_(settings.walls.size()),
      system_(hybrid::make_system(settings)),
      wall_impulses_(settings.walls.size()),
      relaxed_(settings.relaxed_start ? 0 : 1) {}

StepReport Hybrid::advance(Grains<2>& grains, double until, Team&) {
  const auto stage = in_stage("flights and collisions");
  StepReport report;
  const long end = time_steps().count(until);
  const long most = std::max(1L, static_cast<long>(work_of_a_call / static_cast<double>(grains.size() + 20)));
  if (relaxed_ == 0) {
    report.trouble = !relax(grains);
    relaxed_ = 1;
  }
  while (steps_ < end && report.steps < most && !report.trouble) {
    settings_.gravity = gravity_now();
    system_.gravity = settings_.gravity;
    report.trouble = !take_step(grains, settings_.time_step, 0);
    if (report.trouble) break;
    ++steps_;
    ++report.steps;
  }
  report.time = time();
  return report;
}

/// Gravity in the middle of the step.
Vec<2> Hybrid::gravity_now() const {
  const double middle = time() + 0.5 * settings_.time_step;
  return middle < settings_.gravity_ramp ? gravity_ * (middle / settings_.gravity_ramp) : gravity_;
}

/// A step; one without a solution is taken again as two halves.
bool Hybrid::take_step(Grains<2>& grains, double length, int halvings) {
  const double g = magnitude(settings_.gravity);
  const auto reach = [&](std::uint32_t k) {
    if (grains.line[k].fixed()) return 0.0;
    constexpr double margin = 1.5;  // collisions may make a grain faster
    return margin * length * (magnitude(grains.line[k].velocity) + g * length);
  };
  if (!near_.holds(grains, reach)) {
    double farthest = 0.0;
    for (std::uint32_t k = 0; k < grains.size(); ++k) farthest = std::max(farthest, reach(k));
    build_list(grains, farthest);
  }
  const auto line = grains.line;
  const auto reaction = grains.reaction;
  const auto touches = touches_;
  const auto surroundings = around();
  hybrid::Step step(surroundings, grains, touches_, system_, solver_, length);
  const bool taken = step.take();
  account_.iterations += taken ? 0 : step.account.iterations;
  if (taken) {
    account_ += step.account;
    for (std::size_t w = 0; w < wall_impulses_.size(); ++w) wall_impulses_[w] += step.wall_impulses[w];
    return step.deepest < deepest_overlap;
  }
  unsolved_ = step.unsolved;
  ++account_.halved;
  grains.line = line;
  grains.reaction = reaction;
  touches_ = touches;
  if (halvings == most_halvings) return false;
  return take_step(grains, 0.5 * length, halvings + 1) && take_step(grains, 0.5 * length, halvings + 1);
}

bool Hybrid::relax(Grains<2>& grains) {
  const auto stage = in_stage("equilibrium at the start");
  if (touches_.list.empty()) return true;
  hybrid::Relaxation progress{.length = settings_.time_step};
  for (;;) {
    const auto surroundings = around();
    const auto ended = hybrid::relax(surroundings, grains, touches_, system_, solver_, progress, account_);
    if (ended == hybrid::Relaxed::done) return true;
    unsolved_ = progress.worst;
    if (ended == hybrid::Relaxed::failed) return false;
    build_list(grains, 0.0);
  }
}

/// Builds the list of near grains for steps in which grains move up to `reach` [L]. In a periodic box they are wrapped
/// first, and wells with them.
void Hybrid::build_list(Grains<2>& grains, double reach) {
  const auto stage = in_stage("pair lists");
  if (settings_.box.periodic) {
    for (std::uint32_t k = 0; k < grains.size(); ++k) {
      auto& place = grains.line[k].position;
      const Vec<2> shift = settings_.box.wrapped(place) - place;
      place += shift;
      if (shift == Vec<2>{}) continue;
      for (auto& touch : touches_.list) {
        if (touch.grain != k || touch.partner >= 0) continue;
        touch.anchor += dot(shift, hybrid::wall_tangent(settings_.walls[wall_of(touch.partner)]));
      }
    }
  }
  constexpr double of_reach = 4.0;
  near_.build(grains, settings_.box, std::max(settings_.skin, of_reach * reach));
}

/// Contacts of a new grain are soft at once where it overlaps, and where it touches and neither parts nor comes fast.
void Hybrid::touch_slowly(const Grains<2>& grains, std::uint32_t grain) {
  const auto& own = grains.line[grain];
  const auto insert = [&](std::int64_t partner, double gap, double reach, double speed) {
    if (gap > touching * reach || (gap > -touching * reach && std::fabs(speed) > settings_.slow)) return;
    auto touch = hybrid::touch_between(grain, partner);
    if (partner < 0) {
      touch.armed = 1;
      touch.anchor = dot(own.position, hybrid::wall_tangent(settings_.walls[wall_of(partner)]));
      if (settings_.pinned_base && pinned_[grain] == 2) pinned_[grain] = 1;
    }
    touches_.insert(touch);
  };
  for (std::size_t w = 0; w < settings_.walls.size() && !own.fixed(); ++w) {
    const auto& wall = settings_.walls[w];
    const double reach = hybrid::wall_reach(wall, own.radius);
    insert(-1 - static_cast<std::int64_t>(w), dot(own.position - wall.point, wall.normal) - reach, reach,
           dot(own.velocity, wall.normal));
  }
  for (const auto other : near_.of(grain)) {
    const auto& its = grains.line[other];
    const Vec<2> apart = separation(own.position, its.position, settings_.box);
    const double distance = magnitude(apart);
    const double reach = own.radius + its.radius;
    insert(other, distance - reach, reach, dot(own.velocity - its.velocity, apart) / distance);
  }
}

void Hybrid::grains_added(Grains<2>& grains) {
  const auto known = static_cast<std::uint32_t>(pinned_.size());
  // Marked 2 while it is open whether they stand on a wall: those of the start alone can be pinned.
  pinned_.resize(grains.size(), known == 0 ? 2 : 0);
  build_list(grains, 0.0);
  for (auto k = known; k < grains.size(); ++k) touch_slowly(grains, k);
  for (auto& pinned : pinned_) pinned = pinned == 1 ? 1 : 0;
}

void Hybrid::refresh(Grains<2>& grains, Team&) {
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> place(grains.size(), nobody);
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    if (!grains.line[k].fixed() && settings_.box.outside(grains.line[k].position)) continue;
    place[k] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(k);
  }
  if (kept.size() == grains.size()) return;
  grains.reorder(kept);
  for (std::size_t k = 0; k < kept.size(); ++k) pinned_[k] = pinned_[kept[k]];
  pinned_.resize(kept.size());
  std::erase_if(touches_.list, [&](const Touch& touch) {
    return place[touch.grain] == nobody ||
           (touch.partner >= 0 && place[static_cast<std::size_t>(touch.partner)] == nobody);
  });
  for (auto& touch : touches_.list) {
    touch.grain = place[touch.grain];
    if (touch.partner >= 0) touch.partner = place[static_cast<std::size_t>(touch.partner)];
  }
  build_list(grains, 0.0);
}

void Hybrid::exchange(Archive& archive) {
  archive.value("hybrid/steps", steps_);
  archive.value("hybrid/relaxed", relaxed_);
  archive.value("hybrid/account", account_);
  archive.array("hybrid/touches", touches_.list);
  archive.array("hybrid/pinned", pinned_);
  archive.array("hybrid/wall_impulses", wall_impulses_);
  archive.check("hybrid/wall_impulses", wall_impulses_.size() == settings_.walls.size());
  near_.exchange(archive);
}

void Hybrid::restored(const Grains<2>& grains, const Team&) { near_.restore(grains, settings_.box); }

double Hybrid::overlap(const Grains<2>& grains, const Touch& touch, Vec<2>& normal) const {
  const auto& line = grains.line[touch.grain];
  if (touch.partner < 0) {
    const auto& wall = settings_.walls[wall_of(touch.partner)];
    normal = wall.normal;
    return hybrid::wall_reach(wall, line.radius) - dot(line.position - wall.point, wall.normal);
  }
  const auto& other = grains.line[static_cast<std::size_t>(touch.partner)];
  const Vec<2> apart = separation(line.position, other.position, settings_.box);
  const double distance = magnitude(apart);
  normal = apart * (1.0 / distance);
  return line.radius + other.radius - distance;
}

Contacts<2> Hybrid::contacts(const Grains<2>& grains) const {
  Contacts<2> found;
  for (const auto& touch : touches_.list) {
    const bool at_wall = touch.partner < 0;
    const auto other = at_wall ? touch.grain : static_cast<std::uint32_t>(touch.partner);
    Contact<2> contact;
    contact.first = grains.id[touch.grain];
    contact.second = at_wall ? touch.partner : grains.id[other];
    contact.overlap = overlap(grains, touch, contact.normal);
    if (!(contact.overlap > 0.0) && touch.normal_force == 0.0) continue;
    double own = grains.line[touch.grain].radius;
    double its = grains.line[other].radius;
    if (!at_wall && contact.second < contact.first) {
      std::swap(contact.first, contact.second);
      std::swap(own, its);
      contact.normal = -contact.normal;
    }
    const double reach = at_wall ? 2.0 * own : own + its;
    contact.relative_overlap = contact.overlap / reach;
    contact.normal_force = touch.normal_force;
    contact.tangential_force = touch.tangential_force;
    contact.first_lever = at_wall ? own - contact.overlap : (reach - contact.overlap) * own / reach;
    if (at_wall && settings_.walls[wall_of(touch.partner)].smooth) contact.first_lever += own;
    found.list.push_back(contact);
  }
  found.sort();
  return found;
}

double Hybrid::elastic_energy(const Grains<2>& grains) const {
  double sum = 0.0;
  for (const auto& touch : touches_.list) {
    Vec<2> normal;
    sum += hybrid::elastic_energy(settings_.spring, overlap(grains, touch, normal));
  }
  return sum;
}

std::vector<Vec<2>> Hybrid::take_wall_impulses() {
  return std::exchange(wall_impulses_, std::vector<Vec<2>>(settings_.walls.size()));
}

CollisionAccount Hybrid::take_collision_account() { return std::exchange(account_, {}); }

std::string Hybrid::trouble(const Grains<2>& grains) const {
  if (unsolved_ == nobody || unsolved_ >= grains.size()) return {};
  return fmt::format("the implicit step has no solution, even in {} parts: worst at grain {}", 1 << most_halvings,
                     grains.id[unsolved_]);
}

}  // namespace repose
