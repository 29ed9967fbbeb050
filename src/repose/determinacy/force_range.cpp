// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/force_range.hpp"

#include "repose/contact_problem/contact_solution.hpp"
#include "repose/core/errors.hpp"
#include "repose/determinacy/base_sums.hpp"
#include "repose/determinacy/equilibrium.hpp"
#include "repose/record/find_pipe.hpp"
#include "repose/simulation/loads.hpp"
#include "repose/simulation/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace repose {

namespace {

using End = LinearProgramme::End;

/// By which the balance of a grain may be missed, beside what the recorded forces miss [grain weights].
constexpr double margin = 1e-6;

/// A grain whose recorded forces miss its balance by more is not at rest [grain weights].
constexpr double most_unbalanced = 0.05;

/// The cold solution may take more sweeps than a step of a run, which starts near its solution.
constexpr long most_cold_sweeps = 20000;

/// A wall that goes at a speed, or is pulled by a spring, holds grains in equilibrium as one that stands does, while it
/// goes slowly: the balance of the recorded forces shows whether it does.
bool goes_straight(const WallMotion<2>& motion) {
  return motion.kind == WallMotion<2>::Kind::velocity || motion.kind == WallMotion<2>::Kind::spring;
}

/// The record with these walls at rest where they are, and the grains that they carry along at rest too.
Record<2> with_standing_walls(Record<2> record) {
  if (std::none_of(record.walls.begin(), record.walls.end(),
                   [](const auto& w) { return goes_straight(w.wall.motion); })) {
    return record;
  }
  auto grains = *record.grains;
  for (auto& grain : grains.line) {
    grain.velocity = {};
    grain.rim_velocity = {};
  }
  record.grains = OrderedGrains<2>(std::move(grains), record.box);
  auto wall = record.walls.begin() + (record.scene.base->wall(record.scene) ? 1 : 0);
  const auto shifted = [](const Coordinates& point, const Vec<2>& shift) {
    return Coordinates{point[0] + shift[0], point[1] + shift[1], 0.0};
  };
  for (auto* walls : {&record.scene.planes, &record.scene.pieces}) {
    for (auto& from : *walls) {
      auto& at = *wall++;
      if (!goes_straight(at.wall.motion)) continue;
      const Vec<2> shift = at.wall.point - at.start;
      from.point = shifted(from.point, shift);
      from.from = shifted(from.from, shift);
      from.to = shifted(from.to, shift);
      from.motion = StandingWall();
      at.wall.motion = {};
    }
  }
  return record;
}

std::string reason_against(const Record<2>& record) {
  if (record.facts.status == Status::failed) return "the run failed: its last state is not to be trusted";
  if (!(record.scene.grain_weight() > 0.0)) return "grains have no weight";
  if (std::any_of(record.walls.begin(), record.walls.end(), [](const auto& w) {
        return w.wall.motion.kind != WallMotion<2>::Kind::none && !goes_straight(w.wall.motion);
      })) {
    return "a wall shakes, turns, or bears a given force";
  }
  return "";
}

/// The loads that act at the time of the record. A load that names no grain acts on the one that is now nearest.
std::vector<Load<2>> loads_at(const Record<2>& record) {
  Loads<2> loads(record.scene, make_method(record.scene)->time_steps());
  loads.begin_due(record.facts.time, *record.grains);
  return loads.acting();
}

/// The forces of a problem [grain weights].
ContactForces forces_of(const ContactProblem& posed, double weight) {
  ContactForces forces;
  for (const auto& c : posed.problem.contacts) forces.push_back(c.impulse * (1.0 / (posed.time_step * weight)));
  return forces;
}

/// The contacts that touch within this gap [mean diameters], and all that carry force.
std::vector<std::size_t> touching(const ContactProblem& posed, double contact_gap) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < posed.problem.contacts.size(); ++k) {
    const auto& c = posed.problem.contacts[k];
    const double first = posed.places[c.first].radius;
    const double second = posed.places[c.second].radius;
    const double mean_diameter = second > 0.0 ? first + second : 2.0 * first;
    const double gap = c.normal_bias * posed.time_step;
    if (gap <= contact_gap * mean_diameter || c.impulse.normal > 0.0) found.push_back(k);
  }
  return found;
}

std::vector<Vec<2>> outer_forces(const Record<2>& record, const ContactProblem& posed,
                                 const std::vector<Load<2>>& loads) {
  const double weight = record.scene.grain_weight();
  std::vector<Vec<2>> outer(posed.places.size());
  for (std::size_t k = 0; k < posed.places.size(); ++k) {
    const double inverse_mass = posed.problem.free[k].inverse_mass;
    if (inverse_mass > 0.0) outer[k] = {{0.0, -record.scene.gravity / (inverse_mass * weight)}};
    for (const auto& load : loads) {
      if (load.grain == posed.places[k].id) outer[k] += load.force * (1.0 / weight);
    }
  }
  return outer;
}

/// The loaded part of the base that the dip index refers to.
std::optional<BaseDip> dip_of(const Results<2>& results, const BaseProfile& recorded) {
  return results.dip ? results.dip : base_dip(recorded);
}

class Ranges {
 public:
  Ranges(const BaseSums& base, Equilibrium& equilibrium, const ContactForces& cold, ForceRange& range)
      : base_(base), equilibrium_(equilibrium), cold_(cold), range_(range) {}

  void of_dip(const BaseDip& dip) {
    const auto mean_in = [&](DipZone zone) {
      return base_.mean_normal([&](double x) { return dip_zone(x, dip.centre, dip.half_width) == zone; });
    };
    const auto inner = mean_in(DipZone::inner);
    const auto outer = mean_in(DipZone::outer);
    if (inner.terms.empty() || outer.terms.empty()) return;
    range_.central_force = {number(equilibrium_.least(inner)), number(equilibrium_.most(inner)), inner(cold_),
                            inner(equilibrium_.recorded())};
    const auto ratio_in = [&](const ContactForces& forces) {
      const double below = inner(forces);
      return below > 0.0 ? outer(forces) / below : AllowedRange::none;
    };
    range_.dip.cold = ratio_in(cold_);
    range_.dip.warm = ratio_in(equilibrium_.recorded());
    if (std::isnan(range_.dip.warm)) return;
    range_.dip.least = extreme_ratio(outer, inner, range_.dip.warm, false);
    // Where the central force may vanish, the index has no upper bound.
    if (range_.central_force.least > margin) {
      range_.dip.most = extreme_ratio(outer, inner, range_.dip.warm, true);
    }
  }

  /// The range of a sum of forces, over the weight [grain weights] of what they act on.
  AllowedRange over_weight(const ForceSum& sum, double weight) {
    if (sum.terms.empty() || !(weight > 0.0)) return {};
    return {number(equilibrium_.least(sum)) / weight, number(equilibrium_.most(sum)) / weight, sum(cold_) / weight,
            sum(equilibrium_.recorded()) / weight};
  }

  /// Whether the simplex method gave up on a programme: recorded forces show that each has a solution.
  bool failed() const { return failed_; }

  /// Needs the range of the bins.
  void of_largest() {
    std::vector<ForceSum> loaded;
    for (std::size_t k = 0; k < base_.x.size(); ++k) {
      if (base_.loaded(k)) loaded.push_back(base_.normal[k]);
    }
    if (loaded.empty()) return;
    const auto largest = [&](const ContactForces& forces) {
      double most = 0.0;
      for (const auto& sum : loaded) most = std::max(most, sum(forces));
      return most;
    };
    range_.largest.cold = largest(cold_);
    range_.largest.warm = largest(equilibrium_.recorded());
    range_.largest.least = number(equilibrium_.least_of_largest(loaded));
    range_.largest.most = most_of_any();
  }

  void of_bins(const BinnedProfile& bins) {
    range_.base.bin_width = bins.bin_width;
    range_.base.x = bins.x;
    std::vector<ForceSum> means;
    for (const double centre : bins.x) {
      means.push_back(
          base_.mean_normal([&](double x) { return base_bin(x, bins.bin_width) == base_bin(centre, bins.bin_width); }));
    }
    // States that are extreme in neighbouring bins are alike, so that each search is short.
    for (const auto& mean : means) range_.base.least.push_back(number(equilibrium_.least(mean)));
    for (const auto& mean : means) range_.base.most.push_back(number(equilibrium_.most(mean)));
  }

 private:
  /// The value of an extreme; none where there is no bound.
  double number(const Equilibrium::Extreme& extreme) {
    failed_ = failed_ || extreme.end == End::failed || extreme.end == End::infeasible;
    return extreme.end == End::found ? extreme.value : AllowedRange::none;
  }

  /// An extreme of outer / inner over all states, by Dinkelbach's iteration: the ratio of a state that makes
  /// outer - ratio inner extreme is nearer to the extreme one, until no state beats it. `start` is a ratio that exists.
  double extreme_ratio(const ForceSum& outer, const ForceSum& inner, double start, bool largest) {
    constexpr int most_steps = 50;
    constexpr double precision = 1e-7;
    double ratio = start;
    for (int step = 0; step < most_steps; ++step) {
      auto difference = outer;
      difference.add(inner, -ratio);
      const auto found = largest ? equilibrium_.most(difference) : equilibrium_.least(difference);
      if (std::isnan(number(found))) return AllowedRange::none;
      const double below = inner(found.forces);
      if (!(below > 0.0)) return AllowedRange::none;
      const double better = outer(found.forces) / below;
      if (std::fabs(better - ratio) <= precision * std::max(1.0, std::fabs(better))) return better;
      ratio = better;
    }
    failed_ = true;
    return AllowedRange::none;
  }

  /// The largest force that any base grain can bear: a programme for each that may bear more than those before. No
  /// grain bears more than all of its bin, unless others in it pull.
  double most_of_any() {
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t k = 0; k < base_.x.size(); ++k) {
      if (base_.loaded(k)) candidates.emplace_back(bound_by_bin(k), k);
    }
    std::sort(candidates.begin(), candidates.end(), std::greater<>());
    double largest = 0.0;
    for (const auto& [bound, k] : candidates) {
      if (bound <= largest) break;
      const double most = number(equilibrium_.most(base_.normal[k]));
      if (std::isnan(most)) return most;
      largest = std::max(largest, most);
    }
    return largest;
  }

  double bound_by_bin(std::size_t k) const {
    const auto bin = [&](double x) { return base_bin(x, range_.base.bin_width); };
    double members = 0.0;
    for (std::size_t m = 0; m < base_.x.size(); ++m) {
      if (bin(base_.x[m]) != bin(base_.x[k])) continue;
      if (!equilibrium_.never_negative(base_.normal[m])) return LinearProgramme::infinity;
      members += 1.0;
    }
    for (std::size_t b = 0; b < range_.base.x.size(); ++b) {
      if (bin(range_.base.x[b]) == bin(base_.x[k]) && !std::isnan(range_.base.most[b])) {
        return range_.base.most[b] * members;
      }
    }
    return LinearProgramme::infinity;
  }

  const BaseSums& base_;
  Equilibrium& equilibrium_;
  const ContactForces& cold_;
  ForceRange& range_;
  bool failed_ = false;
};

/// The forces on the walls of a column.
struct WallSums {
  ForceSum floor;  ///< downwards, on the level walls below it
  ForceSum sides;  ///< outwards, on the left and the right wall
};

WallSums wall_sums(const Record<2>& record, const PipeWalls& pipe, const ContactProblem& posed) {
  WallSums sums;
  if (record.column_series.empty() || !pipe.floor) return sums;
  const double middle = record.walls[*pipe.floor].wall.point[1] + record.column_series.back().centre;
  for (std::size_t k = 0; k < posed.problem.contacts.size(); ++k) {
    const auto body = posed.problem.contacts[k].second;
    const auto wall = -1 - posed.places[body].id;
    if (wall < 0) continue;
    const auto w = static_cast<std::size_t>(wall);
    if (w == pipe.left || w == pipe.right) {
      sums.sides.terms.push_back(force_on_body(posed.problem, k, body, {{w == pipe.left ? -1.0 : 1.0, 0.0}}));
    } else if (record.walls[w].wall.point[1] < middle) {
      sums.floor.terms.push_back(force_on_body(posed.problem, k, body, {{0.0, -1.0}}));
    }
  }
  return sums;
}

ContactForces cold_forces(const Record<2>& record, ContactProblem posed, ForceRange& range) {
  const auto& limits = *record.scene.method->solver();
  contact_dynamics::SolverSettings settings;
  settings.tolerance = limits.tolerance;
  settings.most_sweeps = std::max<long>(limits.most_sweeps, most_cold_sweeps);
  range.cold_residual = solve(posed, settings, false).residual.worst();
  return forces_of(posed, record.scene.grain_weight());
}

}  // namespace

ForceRange force_range(const Record<2>& given, const Results<2>& results) {
  const auto record = with_standing_walls(given);
  const auto& scene = record.scene;
  if (scene.method->solver() == nullptr) {
    throw InputError(
        fmt::format("no force range: the method of the run is {}, and only the rigid grains of "
                    "contact-dynamics have one",
                    scene.method->name()));
  }
  ForceRange range;
  range.problem = reason_against(given);
  if (!range.problem.empty()) return range;
  // The key exists where the packing is measured.
  range.contact_gap = *scene.analysis.packing ? scene.analysis.contact_gap : scene.method->traits().contact_gap;
  const auto loads = loads_at(record);
  const auto posed = pose_contact_problem(record, loads);
  EquilibriumInput input{posed.problem, touching(posed, range.contact_gap), outer_forces(record, posed, loads), margin};
  Equilibrium equilibrium(input, forces_of(posed, scene.grain_weight()));
  range.contacts = static_cast<std::int64_t>(input.touching.size());
  range.unknowns = static_cast<std::int64_t>(equilibrium.unknowns());
  range.equations = static_cast<std::int64_t>(equilibrium.equations());
  range.unbalanced = equilibrium.unbalanced();
  if (range.unbalanced > most_unbalanced) {
    range.problem = fmt::format(
        "the state is not in equilibrium: the recorded forces miss the balance of a grain by "
        "{:.3g} grain weights, where {:g} is allowed",
        range.unbalanced, most_unbalanced);
    return range;
  }
  const auto base = base_sums(record, posed);
  const auto cold = cold_forces(record, posed, range);
  Ranges ranges(base, equilibrium, cold, range);
  if (const auto dip = dip_of(results, base.profile(equilibrium.recorded()))) ranges.of_dip(*dip);
  ranges.of_bins(binned(base.profile(equilibrium.recorded()), scene.analysis.base_bin));
  ranges.of_largest();
  if (const auto pipe = find_pipe(scene); pipe && results.column) {
    const auto sums = wall_sums(record, *pipe, posed);
    const double weight = results.column->mass / scene.usual_mass();
    range.load_ratio = ranges.over_weight(sums.floor, weight);
    range.wall_ratio = ranges.over_weight(sums.sides, weight);
  }
  if (ranges.failed()) {
    range.central_force = range.dip = range.largest = range.load_ratio = range.wall_ratio = {};
    range.base = {};
    range.problem = "the simplex method found no extreme for a sum of forces: rounding is too large";
  }
  return range;
}

}  // namespace repose
