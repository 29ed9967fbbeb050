// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"
#include "repose/methods/method.hpp"
#include "repose/methods/soft/audit.hpp"
#include "repose/methods/soft/general.hpp"
#include "repose/methods/soft/rows/fused.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace repose {

/// Soft-particle dynamics: forces from overlaps, integrated by explicit leapfrog.
/// Source: Baxter et al. (1997), section II, as corrected in docs/physics/soft.md.
///
/// The general kernel includes resistance to rolling and twisting, bonds, damping and the energy budget; the fused ones
/// are faster.
template <int D, class Law>
class Soft final : public Method<D> {
  static constexpr bool Full = std::is_same_v<Law, AnyPairLaw>;
  using Kernel = std::conditional_t<Full, soft::GeneralKernel<D, Law>, soft::FusedKernel<D, Law>>;

 public:
  Soft(MaterialTable<Law> laws, SoftSettings<D> settings)
      : laws_(std::move(laws)),
        settings_(std::move(settings)),
        pairs_(PairReach{widest_reach(), settings_.skin, look_ahead_steps * settings_.time_step,
                         magnitude(settings_.gravity), Full, makes_bonds(), keeps_twist()}),
        kernel_(settings_),
        walls_(settings_.walls.size()),
        wall_list_(settings_.walls.size()),
        crossings_(settings_.walls.size()) {
    REPOSE_ASSERT(Full || !settings_.audit);
  }

  void grains_added(Grains<D>& grains) override {
    pairs_.invalidate();
    if (settings_.synchronised) {
      for (auto i = grains.half_step.size(); i < grains.size(); ++i) {
        grains.half_step.push_back({grains.line[i].velocity, grains.line[i].rim_velocity});
      }
    }
    for (auto i = known_; settings_.audit && i < grains.size(); ++i)
      energy_.sources += soft::own_energy(grains, i, settings_, behind());
    known_ = grains.size();
  }

  void refresh(Grains<D>& grains, Team& team) override {
    pairs_.invalidate();
    build_pairs(grains, team);
  }

  TimeSteps time_steps() const override { return {settings_.time_step, true}; }
  double time() const override { return time_steps().after(step_); }

  StepReport advance(Grains<D>& grains, double until, Team& team) override {
    StepReport report;
    const long steps = time_steps().count(until) - step_;
    bool taken = false;  // whether the kernel has the state of the grains
    while (report.steps < steps && !report.trouble) {
      if (stale(grains, taken)) {
        if (std::exchange(taken, false)) give_back(grains, team);
        build_pairs(grains, team);
      }
      const auto stage = this->in_stage("forces and motion");
      const long before = report.steps;
      const long start = step_;
      team.run([&](int member) {
        // Every member computes the same numbers and takes the same decisions.
        auto& mine = parts_[static_cast<std::size_t>(member)];
        if (!taken) {
          kernel_.take(grains, mine, pairs_);
          team.wait();
        }
        long done = before;
        double travelled = pairs_.travelled();
        bool trouble = false;
        while (done < steps && !trouble && travelled <= pairs_.slack()) {
          const auto in = input(start + done - before);
          kernel_.step(in, grains, parts_, team, member);
          Vec<D> fastest{};
          for (const auto& part : parts_) {
            for (int k = 0; k < D; ++k) fastest[k] = std::max<double>(fastest[k], part.fastest[k]);
            trouble |= part.trouble;
          }
          double furthest = magnitude(fastest);
          soft::move_walls(in, mine);
          for (std::size_t w = 0; w < mine.walls.size(); ++w) {
            furthest = std::max(furthest, farthest_moved(settings_.walls[w], mine.walls[w].speed));
          }
          travelled += settings_.time_step * furthest;
          ++done;
        }
        if (team.size() > 1) team.wait();
        if (member != 0) return;
        pairs_.set_travelled(travelled);
        walls_ = mine.walls;
        report.steps = done;
        report.trouble = trouble;
      });
      step_ += report.steps - before;
      taken = true;
    }
    if (taken) give_back(grains, team);
    report.time = time();
    return report;
  }

  Contacts<D> contacts(const Grains<D>& grains) const override;

  void set_loads(const std::vector<Load<D>>& loads) override {
    loads_ = loads;
    load_work_.resize(loads_.size(), 0.0);
    pairs_.invalidate();  // the next build finds the loaded grains
  }

  void set_slip_displacements(const Grains<D>& grains, const Contacts<D>& contacts) override;

  const std::vector<WallState>& walls() const override { return walls_; }
  std::vector<Crossings> wall_crossings(const Grains<D>& grains) const override {
    return crossings_.until(grains, settings_.walls, walls_now(), settings_.box, time());
  }
  std::vector<Vec<D>> take_wall_impulses() override { return wall_list_.take_impulses(walls_.size()); }
  Energy energy(const Grains<D>& grains) const override;

  void exchange(Archive& archive) override {
    archive.value("step", step_);
    archive.array("walls/state", walls_);
    archive.array("walls/at_build", walls_at_build_);
    archive.array("loads/list", loads_);
    archive.array("loads/work", load_work_);
    archive.value("energy/account", energy_);
    archive.array("energy/work", work_);
    archive.value("energy/elastic_at_start", elastic_at_start_);
    archive.value("energy/known", known_);
    pairs_.exchange(archive);
    wall_list_.exchange(archive);
    crossings_.exchange(archive);
  }

  void restored(const Grains<D>& grains, const Team& team) override {
    if (pairs_.valid()) distribute(grains, team);
  }
  const PairList<D>& pairs() const { return pairs_; }

 private:
  /// Fast grains list all grains that they may reach within this many steps, about the number between two builds in a
  /// heap.
  static constexpr double look_ahead_steps = 256.0;

  /// Bonds may be longer than the reach of the normal laws.
  double widest_reach() const {
    double widest = 0.0;
    for (const auto& law : laws_.all()) widest = std::max({widest, reach(law.normal), reach_of_bonds_of(law)});
    return widest;
  }
  double reach_of_bonds_of(const Law& law) const { return reach_of_bonds(law.cohesion, settings_.smallest_diameter); }

  template <class Is>
  bool any_law(const Is& is) const {
    return std::any_of(laws_.all().begin(), laws_.all().end(), is);
  }
  bool makes_bonds() const {
    return any_law([&](const Law& law) { return reach_of_bonds_of(law) > 0.0; });
  }
  bool keeps_twist() const {
    if constexpr (Full && D == 3) return any_law([](const Law& law) { return law.twisting.law.index() > 0; });
    return false;
  }

  /// The time [T] by which velocities are behind positions: half a step, and 0 at the start.
  double behind() const { return step_ > 0 ? 0.5 * settings_.time_step : 0.0; }

  /// The walls with the positions of `back` [T] ago.
  std::vector<WallNow<D>> walls_now(double back = 0.0) const {
    std::vector<WallNow<D>> all;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      auto state = walls_[w];
      state.displacement -= state.speed * back;
      all.push_back(wall_now(settings_.walls[w], state, time()));
    }
    return all;
  }

  double furthest_wall() const {
    double furthest = 0.0;
    for (std::size_t w = 0; w < walls_at_build_.size(); ++w) {
      const double change = walls_[w].displacement - walls_at_build_[w].displacement;
      furthest = std::max(furthest, farthest_moved(settings_.walls[w], change));
    }
    return furthest;
  }

  bool stale(const Grains<D>& grains, bool taken) {
    const auto stage = this->in_stage("pair lists");
    if (!pairs_.may_be_stale()) return false;
    if (!taken) return pairs_.stale(grains, furthest_wall());
    return pairs_.stale_at([&](std::size_t k) { return kernel_.position(grains, k); }, furthest_wall());
  }

  void give_back(Grains<D>& grains, Team& team) {
    team.run([&](int member) { kernel_.give(grains, parts_[static_cast<std::size_t>(member)]); });
  }

  void build_pairs(Grains<D>& grains, Team& team) {
    const auto stage = this->in_stage("pair lists");
    if (settings_.audit) close_work(grains);
    const auto& order = pairs_.build(grains, settings_.box, team);
    known_ = grains.size();
    if (settings_.audit) work_.assign(grains.size(), {});
    const auto wall_stage = this->in_stage("wall lists");
    const auto now = walls_now();
    wall_list_.build(grains, order, settings_.walls, now, settings_.box, pairs_, widest_reach(), settings_.skin);
    crossings_.check(grains, settings_.walls, now, settings_.box, time());
    walls_at_build_ = walls_;
    distribute(grains, team);
    account_for_start(grains);
  }

  /// Counts the energy that contacts store at the start as energy of the sources.
  void account_for_start(const Grains<D>& grains) {
    if (!settings_.audit || step_ > 0) return;
    Energy start;
    add_elastic(start, grains);
    const double pressed = start.elastic + start.dissipated();  // without the energy in springs of friction
    energy_.sources += pressed - elastic_at_start_;
    elastic_at_start_ = pressed;
  }

  /// Distributes the present list among the members of the team.
  void distribute(const Grains<D>& grains, const Team& team) {
    const auto now = walls_now();
    loaded_ = soft::find_loaded(grains, loads_);
    parts_ = soft::make_parts<typename Kernel::Space>(pairs_, grains.size(), team.size());
    for (auto& part : parts_) {
      part.walls = walls_;
      part.walls_now = now;
      soft::find_special(grains, loaded_, wall_list_, part);
    }
    kernel_.prepare(parts_, laws_, pairs_, grains);
    smallest_radius_ = std::numeric_limits<double>::infinity();
    for (const auto& grain : grains.line) smallest_radius_ = std::min(smallest_radius_, grain.radius);
  }

  /// Adds the work of every grain, and the energy of grains that leave, to the budget before grains are reordered or
  /// dropped.
  void close_work(const Grains<D>& grains) {
    for (const auto& work : work_) soft::add(energy_, work);
    work_.clear();
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto& grain = grains.line[i];
      if (!grain.fixed() && settings_.box.outside(grain.position))
        energy_.lost += soft::own_energy(grains, i, settings_, behind());
    }
  }

  void add_elastic(Energy& account, const Grains<D>& grains) const;

  soft::SweepInput<D, Law> input(long step) {
    const double limit = smallest_radius_ / settings_.time_step;
    // The first kick is half a step, from velocities at the time of the positions.
    const double kick = step > 0 ? settings_.time_step : 0.5 * settings_.time_step;
    return {laws_, settings_, pairs_, wall_list_, work_, loaded_, load_work_, kick, step, limit};
  }

  /// Calls use(first id, second id or wall, law, geometry, force, history, lever of the first) for every pair in reach,
  /// in the order of the lists, with positions `back` [T] ago and histories advanced to that time. With half-step
  /// velocities a history belongs to the last force, and advances by `back`; with synchronised ones to the half step
  /// after it.
  template <class Use>
  void for_every_contact(const Grains<D>& grains, double back, const Use& use) const;

  MaterialTable<Law> laws_;
  SoftSettings<D> settings_;
  PairList<D> pairs_;
  Kernel kernel_;
  long step_ = 0;
  std::vector<WallState> walls_;
  std::vector<WallState> walls_at_build_;
  WallList<D> wall_list_;
  WallCrossings<D> crossings_;
  std::vector<Load<D>> loads_;
  std::vector<double> load_work_;             // [M L^2/T^2] work of each load
  std::vector<soft::LoadedGrain<D>> loaded_;  // loaded grains of the present list
  std::vector<typename Kernel::Space> parts_;
  double smallest_radius_ = 0.0;
  Energy energy_;                      // energy supplied and lost, and that dissipated before the present list
  std::vector<soft::GrainWork> work_;  // dissipated since the present list was built, for each grain
  double elastic_at_start_ = 0.0;      // stored by contacts at the start
  std::size_t known_ = 0;              // number of grains whose energy is in the budget
};

template <int D, class Law>
template <class Use>
void Soft<D, Law>::for_every_contact(const Grains<D>& grains, double back, const Use& use) const {
  const auto& box = settings_.box;
  const auto at = [&](const Grain<D>& now) {
    auto grain = now;
    grain.position -= now.velocity * back;
    return grain;
  };
  const auto with_times = [&](const auto& force_in) {
    return settings_.synchronised ? force_in(HalfSteps{.before = behind() - back}) : force_in(back);
  };
  for (std::uint32_t i = 0; i < pairs_.rows(); ++i) {
    for (auto k = pairs_.row_start[i]; k < pairs_.row_start[i + 1]; ++k) {
      const auto j = pairs_.partner[k];
      // Pairs by ascending id, independently of their order in memory.
      const bool swap = grains.id[j] < grains.id[i];
      const auto a = swap ? j : i;
      const auto b = swap ? i : j;
      const auto& law = laws_.of(grains.material[a], grains.material[b]);
      const auto first = at(grains.line[a]);
      const auto second = at(grains.line[b]);
      const Vec<D> d = separation(first.position, second.position, box);
      const double within = reach(law.normal) * (first.radius + second.radius);
      const bool bonded = !pairs_.bonded.empty() && pairs_.bonded[k] != 0;
      if (dot(d, d) >= within * within && !bonded) continue;
      const auto pair = soft::pair_geometry(first, second, d, dot(d, d), within);
      ContactHistory<Tangent<D>> history{.bonded = bonded};
      history.slip = turned(swap ? swapped(pairs_.slip[k]) : pairs_.slip[k], pair.normal);
      if constexpr (Full) history.roll = turned(swap ? -pairs_.roll[k] : pairs_.roll[k], pair.normal);
      if (!pairs_.twist.empty()) history.twist = pairs_.twist[k];
      const auto force = with_times([&](const auto& times) {
        return contact_force(law, pair.touch, pair.slip_velocity, pair.roll_velocity, times, history,
                             pair.twist_velocity);
      });
      use(grains.id[a], grains.id[b], law, pair, force, history, pair.lever * first.radius);
    }
  }
  if (!wall_list_.any()) return;
  const auto now = walls_now(back);
  WallContacts<D> contacts;
  for (std::size_t i = 0; i < pairs_.rows(); ++i) {
    auto row = wall_list_.row(i);
    const auto grain = at(grains.line[i]);
    soft::find_wall_contacts(laws_, grain, grains.material[i], row.data(), static_cast<std::uint32_t>(row.size()),
                             settings_.walls, now, settings_.box, contacts);
    pass_on_displacements(contacts, row.data());
    for (const auto& touch : contacts.all()) {
      if (!contacts.acts(touch)) continue;
      const auto& wall = settings_.walls[touch.wall];
      const auto& law = laws_.of(grains.material[i], wall.material);
      const auto pair =
          soft::wall_geometry(law, grain, wall, now[touch.wall], touch.place, surface_velocity(now[touch.wall], touch));
      auto history = soft::history_of(row[touch.entry], pair.normal);
      const auto force =
          with_times([&](const auto& times) { return soft::wall_contact(law, wall, pair, times, history); });
      use(grains.id[i], wall_partner(touch.wall), law, pair, force, history, grain.radius);
    }
  }
}

template <int D, class Law>
Contacts<D> Soft<D, Law>::contacts(const Grains<D>& grains) const {
  Contacts<D> contacts;
  for_every_contact(
      grains, 0.0,
      [&](std::int64_t first, std::int64_t second, const Law& law, const soft::PairGeometry<D>& pair,
          const ContactForce<Tangent<D>>& force, const ContactHistory<Tangent<D>>& history, double lever) {
        const double limit = coulomb_limit(law.tangential, force.normal, pair.slip_velocity);
        contacts.list.push_back({first, second, pair.normal, pair.touch.overlap,
                                 pair.touch.overlap / pair.touch.diameter, force.normal.total - force.attraction,
                                 force.tangential, history.slip, soft::resisting_torque(force, pair.normal), lever,
                                 limit > 0.0 && magnitude(force.tangential) >= limit * (1.0 - 1e-9)});
      });
  contacts.sort();
  return contacts;
}

template <int D, class Law>
void Soft<D, Law>::set_slip_displacements(const Grains<D>& grains, const Contacts<D>& contacts) {
  std::map<std::pair<std::int64_t, std::int64_t>, Tangent<D>> known;
  for (const auto& contact : contacts.list) known[{contact.first, contact.second}] = contact.slip;
  const auto of = [&](std::int64_t first, std::int64_t second) {
    const auto found = known.find({first, second});
    return found == known.end() ? Tangent<D>{} : found->second;
  };
  const bool bonds = makes_bonds();
  const auto bonded = [&](std::int64_t first, std::int64_t second) { return bonds && known.contains({first, second}); };
  for (std::uint32_t i = 0; i < pairs_.rows(); ++i) {
    for (auto k = pairs_.row_start[i]; k < pairs_.row_start[i + 1]; ++k) {
      const auto a = grains.id[i];
      const auto b = grains.id[pairs_.partner[k]];
      pairs_.slip[k] = b < a ? swapped(of(b, a)) : of(a, b);
      if (bonds) pairs_.bonded[k] = bonded(std::min(a, b), std::max(a, b)) ? 1 : 0;
    }
    if (!wall_list_.any()) continue;
    for (auto k = wall_list_.row_start[i]; k < wall_list_.row_start[i + 1]; ++k) {
      auto& contact = wall_list_.pairs[k];
      contact.slip = of(grains.id[i], wall_partner(contact.wall));
      contact.bonded = bonded(grains.id[i], wall_partner(contact.wall)) ? 1 : 0;
    }
  }
  account_for_start(grains);
}

template <int D, class Law>
void Soft<D, Law>::add_elastic(Energy& account, const Grains<D>& grains) const {
  if constexpr (Full) {
    for_every_contact(grains, behind(),
                      [&](std::int64_t, std::int64_t second, const Law& law, const soft::PairGeometry<D>& pair,
                          const ContactForce<Tangent<D>>& force, const ContactHistory<Tangent<D>>& history, double) {
                        const double springs = stored_energy(law.tangential, pair.touch, force.normal, history.slip) +
                                               stored_energy(law.rolling, pair.touch, force.normal, history.roll) +
                                               soft::twist_energy<D>(law, pair.touch, force.normal, history.twist);
                        account.elastic += elastic_energy(law, pair.touch, history.bonded) + springs;
                        (second < 0 ? account.walls : account.friction) -= springs;
                      });
  }
}

/// Kicks end at half steps, where the kinetic and the dissipated energy are known. So the potential energies are
/// computed there too: with positions half a step back and slip displacements of that time.
template <int D, class Law>
Energy Soft<D, Law>::energy(const Grains<D>& grains) const {
  Energy account = energy_;
  if constexpr (Full) {
    for (const auto k : by_id(grains)) {
      if (grains.line[k].fixed()) continue;
      soft::add_own(account, grains, k, settings_, behind());
      if (!work_.empty()) soft::add(account, work_[k]);
    }
    for (const auto work : load_work_) account.loads_work += work;
    for (const auto& wall : walls_) {
      account.walls_work += wall.work;
      account.walls += wall.dissipated;
    }
    add_elastic(account, grains);
  }
  return account;
}

/// The soft method for laws chosen at run time.
template <int D>
std::unique_ptr<Method<D>> make_soft(const MaterialLaws& laws, const SoftSettings<D>& settings);

}  // namespace repose
