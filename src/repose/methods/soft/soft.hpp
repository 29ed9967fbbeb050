// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"
#include "repose/methods/method.hpp"
#include "repose/methods/soft/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace repose {

/// Soft-particle dynamics: forces from overlap, explicit leapfrog.
/// Source: Baxter et al. (1997), section II, as corrected in docs/physics/soft.md.
template <int D, class Law>
class Soft final : public Method<D> {
 public:
  Soft(soft::LawsOfMaterials<Law> laws, SoftSettings<D> settings)
      : laws_(std::move(laws)),
        settings_(std::move(settings)),
        pairs_(PairReach{widest_reach(), settings_.skin, look_ahead_steps * settings_.time_step,
                         magnitude(settings_.gravity)}),
        plane_history_(settings_.planes.size()) {}

  void grains_added(Grains<D>& grains) override {
    pairs_.invalidate();
    if (!settings_.synchronised) return;
    for (auto i = grains.half_step.size(); i < grains.size(); ++i) {
      grains.half_step.push_back({grains.line[i].velocity, grains.line[i].rim_velocity});
    }
  }

  void refresh(Grains<D>& grains, Team& team) override {
    pairs_.invalidate();
    refresh_pairs(grains, team);
  }

  StepReport advance(Grains<D>& grains, long steps, Team& team) override {
    StepReport report;
    while (report.steps < steps && !report.trouble) {
      refresh_pairs(grains, team);
      const long before = report.steps;
      team.run([&](int member) {
        // Every member goes through the same numbers and comes to the same decisions.
        long done = before;
        double travelled = pairs_.travelled();
        bool trouble = false;
        while (done < steps && !trouble && travelled <= pairs_.slack()) {
          soft::sweep(input(started_ || done > 0), grains, shares_, team, member);
          double fastest2 = 0.0;
          for (const auto& share : shares_) {
            fastest2 = std::max(fastest2, share.fastest2);
            trouble |= share.trouble;
          }
          travelled += settings_.time_step * std::sqrt(fastest2);
          ++done;
        }
        if (team.size() > 1) team.wait();
        if (member != 0) return;
        pairs_.moved(travelled - pairs_.travelled());
        report.steps = done;
        report.trouble = trouble;
      });
      started_ = true;
    }
    return report;
  }

  Contacts<D> contacts(const Grains<D>& grains) const override;

  double time_step() const override { return settings_.time_step; }
  const PairList<D>& pairs() const { return pairs_; }

 private:
  /// Fast grains list what they can meet in this many steps: of the order of the time between two builds in a heap.
  static constexpr double look_ahead_steps = 256.0;

  double widest_reach() const {
    double widest = 0.0;
    for (const auto& law : laws_.all()) widest = std::max(widest, reach(law.normal));
    return widest;
  }

  void refresh_pairs(Grains<D>& grains, Team& team) {
    if (!pairs_.suspect() || !pairs_.stale(grains)) return;
    const auto order = pairs_.build(grains, settings_.box, team);
    for (auto& history : plane_history_) {
      std::vector<Tangent<D>> moved(order.size());
      for (std::size_t k = 0; k < order.size(); ++k) {
        if (order[k] < history.size()) moved[k] = history[order[k]];
      }
      history.swap(moved);
    }
    shares_ = soft::make_shares(pairs_, grains.size(), team.size());
    smallest_radius_ = std::numeric_limits<double>::infinity();
    for (const auto& grain : grains.line) smallest_radius_ = std::min(smallest_radius_, grain.radius);
  }

  soft::SweepInput<D, Law> input(bool started) {
    const double limit = smallest_radius_ / settings_.time_step;
    return {laws_,        settings_, pairs_, plane_history_, started ? settings_.time_step : 0.5 * settings_.time_step,
            limit * limit};
  }

  soft::LawsOfMaterials<Law> laws_;
  SoftSettings<D> settings_;
  PairList<D> pairs_;
  std::vector<std::vector<Tangent<D>>> plane_history_;  // per plane and grain
  std::vector<soft::Share<D>> shares_;
  double smallest_radius_ = 0.0;
  bool started_ = false;  // the first kick is half a step, from velocities at the time of the positions
};

template <int D, class Law>
Contacts<D> Soft<D, Law>::contacts(const Grains<D>& grains) const {
  Contacts<D> contacts;
  const auto report = [&](std::int64_t first, std::int64_t second, const Law& law, const soft::PairGeometry<D>& pair,
                          const ContactForce<Tangent<D>>& force, const Tangent<D>& history, double first_lever) {
    const double limit = coulomb_limit(law.tangential, force.normal);
    contacts.list.push_back({first, second, pair.normal, pair.touch.overlap, pair.touch.overlap / pair.touch.diameter,
                             force.normal.total, force.tangential, history, first_lever,
                             limit > 0.0 && magnitude(force.tangential) >= limit * (1.0 - 1e-9)});
  };
  const auto& box = settings_.box;
  for (std::uint32_t i = 0; i < pairs_.rows(); ++i) {
    for (auto k = pairs_.row_start[i]; k < pairs_.row_start[i + 1]; ++k) {
      const auto j = pairs_.partner[k];
      // Pairs by ascending id, whatever their order in memory.
      const bool swap = grains.id[j] < grains.id[i];
      const auto a = swap ? j : i;
      const auto b = swap ? i : j;
      const auto& law = laws_.of(grains.material[a], grains.material[b]);
      const auto& first = grains.line[a];
      const auto& second = grains.line[b];
      const Vec<D> d = separation(first.position, second.position, box);
      const double within = reach(law.normal) * (first.radius + second.radius);
      if (dot(d, d) >= within * within) continue;
      const auto pair = soft::pair_geometry(first, second, d, dot(d, d), within);
      Tangent<D> history = turned(swap ? swapped(pairs_.history[k]) : pairs_.history[k], pair.normal);
      ContactHistory<Tangent<D>> both{history, {}};
      const auto force = contact_force(law, pair.touch, pair.slip_velocity, Tangent<D>{}, 0.0, both);
      history = both.slip;
      report(grains.id[a], grains.id[b], law, pair, force, history, pair.lever * first.radius);
    }
  }
  for (std::size_t p = 0; p < settings_.planes.size(); ++p) {
    for (std::size_t i = 0; i < pairs_.rows(); ++i) {
      if (grains.line[i].fixed()) continue;
      const auto& law = laws_.of(grains.material[i], grains.material[i]);
      soft::PairGeometry<D> pair;
      if (!soft::plane_geometry(law, grains.line[i], settings_.planes[p], pair)) continue;
      Tangent<D> history = plane_history_[p][i];
      const auto force = soft::plane_contact(law, settings_.planes[p], pair, 0.0, history);
      report(grains.id[i], plane_partner(static_cast<std::int64_t>(p)), law, pair, force, history,
             grains.line[i].radius);
    }
  }
  contacts.sort();
  return contacts;
}

/// The soft method for two laws chosen at run time (one material).
template <int D>
std::unique_ptr<Method<D>> make_soft(const NormalLaw& normal, const TangentialLaw& tangential,
                                     const SoftSettings<D>& settings);

}  // namespace repose
