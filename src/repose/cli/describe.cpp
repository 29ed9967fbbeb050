// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/describe.hpp"

#include "repose/laws/impact.hpp"
#include "repose/record/force_unit.hpp"
#include "repose/results/results.hpp"
#include "repose/results/warnings.hpp"
#include "repose/scene/materials.hpp"
#include "repose/simulation/expectation.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace repose {

namespace {

/// "1000 poured, 3 placed, on 151 fixed".
std::string grains_text(const Scene& scene) {
  const auto [all, moving] = with_dimension(scene.dimension, [&](auto dimension) {
    const auto initial = initial_grains<dimension>(scene);
    return std::pair(initial.size(), moving_count(initial));
  });
  const auto fixed = all - moving;
  std::string text = scene.source->describe();
  if (moving > 0 || text.empty()) text += fmt::format("{}{} placed", text.empty() ? "" : ", ", moving);
  if (fixed > 0) text += fmt::format(" on {} fixed", fixed);
  return text;
}

std::string stop_text(const Scene& scene) {
  std::string text;
  if (scene.stop.at_rest) text = fmt::format("at rest below {:g}", *scene.stop.at_rest);
  if (scene.stop.time) text += fmt::format("{}time {:g}", text.empty() ? "" : ", or ", *scene.stop.time);
  return text;
}

std::string or_none(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "not defined";
}

/// Mean sweeps per step, and impacts whose restitution gave way.
std::string describe_solver(const Scene& scene, const std::vector<SeriesRow>& series) {
  const auto* solver = scene.method->solver();
  if (solver == nullptr) return "";
  const auto all = solver_account(series);
  if (all.steps == 0) return "";
  std::string text = fmt::format("solver           {:.3g} sweeps a step\n",
                                 static_cast<double>(all.sweeps) / static_cast<double>(all.steps));
  if (all.reduced > 0) {
    text += fmt::format("restitution      gave way in {} of {} impacts, so that the kinetic energy does not rise\n",
                        all.reduced, all.impacts);
  }
  return text;
}

std::string describe_packing(const Packing& packing) {
  const auto with_error = [](const Estimate& value, const char* format) {
    return fmt::format(fmt::runtime(format), value.mean, value.error);
  };
  std::string text = fmt::format("slab             y {:.4g} to {:.4g}, {} grains in it\n", packing.slab.low,
                                 packing.slab.high, packing.coordination.discs);
  text += fmt::format("solid fraction   {}{}\n", with_error(packing.solid_fraction, "{:.4f} +- {:.4f}"),
                      packing.regime ? fmt::format(" ({})", name_of(*packing.regime)) : "");
  text += fmt::format("touching         {} neighbours\n", with_error(packing.coordination.mean, "{:.4f} +- {:.4f}"));
  if (packing.fabric) {
    text += fmt::format("fabric           anisotropy {}, direction {} deg from upright\n",
                        with_error(packing.fabric->all.anisotropy, "{:.4f} +- {:.4f}"),
                        with_error(packing.fabric->folded.direction_deg, "{:.2f} +- {:.2f}"));
  }
  return text;
}

std::string describe_stability(const Stability& found) {
  if (!found.problem.empty()) return fmt::format("stability        unknown: {}\n", found.problem);
  return fmt::format(
      "stability        smallest eigenvalue {:.4g} grain weights per diameter, {:.3g} of the mean stiffness;\n"
      "                 {} negative and {} neutral of {}\n",
      found.smallest, found.relative, found.negative, found.neutral, found.directions);
}

std::string describe_slips(const Slips& found) {
  if (!found.problem.empty()) return fmt::format("slips            none: {}\n", found.problem);
  std::string text = fmt::format("slips            {} of wall {} from time {:.4g} on, mean force {:.4g}\n",
                                 found.events.size(), found.wall, found.from, found.mean_force);
  const auto& drops = found.drops;
  if (drops.tail > 0) {
    text += fmt::format(
        "  drops          exponent {:.3f} +- {:.3f} from {:.3g} on, {} drops over {:.2f} decades, p {:.2f}\n",
        drops.exponent, drops.error, drops.x_min, drops.tail, drops.decades, drops.p_value);
  }
  return text + fmt::format("  power law      {}\n", drops.verdict);
}

std::string describe_force_range(const ForceRange& range) {
  if (!range.problem.empty()) return fmt::format("force range      none: {}\n", range.problem);
  std::string text = fmt::format("force range      {} unknowns, {} equations: {} forces are left open\n",
                                 range.unknowns, range.equations, range.degree());
  const auto bound = [](double value) {
    return std::isnan(value) ? std::string("no bound") : fmt::format("{:.3f}", value);
  };
  const auto value = [](double number) {
    return std::isnan(number) ? std::string("-") : fmt::format("{:.3f}", number);
  };
  const auto line = [&](const char* name, const AllowedRange& of, const char* unit) {
    if (std::isnan(of.warm)) return;
    text += fmt::format("  {:15}{} to {}{}; cold {}, warm {}\n", name, bound(of.least), bound(of.most), unit,
                        value(of.cold), value(of.warm));
  };
  line("central force", range.central_force, " grain weights");
  line("dip index", range.dip, "");
  line("largest force", range.largest, " grain weights");
  return text;
}

/// The overlap [L] at rest of two grains of diameter d and mass m under a load [M L/T^2].
double rest_overlap(const ContactLaws& laws, double m, double d, double load) {
  const auto* adhesion = std::get_if<Jkr>(&laws.cohesion);
  if (adhesion != nullptr) return at_radius(*adhesion, 0.25 * d).overlap_under(load);
  return static_overlap({laws.normal}, m, d, load);
}

/// The pull-off force of two grains of diameter d, where they adhere.
std::string adhesion_text(const ContactLaws& laws, double d, double weight, const std::string& between) {
  const auto* adhesion = std::get_if<Jkr>(&laws.cohesion);
  if (adhesion == nullptr) return "";
  const double pull = 1.5 * std::numbers::pi * adhesion->surface_energy * 0.25 * d;
  const auto in_weights = weight > 0.0 ? fmt::format(", {:.4g} grain weights", pull / weight) : "";
  return fmt::format("adhesion         {}: pull-off force {:.4g}{}, on a wall twice that; restitution is without it\n",
                     between, pull, in_weights);
}

/// The speed of a sound wave along a chain of usual grains of the first material, sqrt(k/m) d.
std::string sound_text(const Scene& scene, const ContactLaws& laws) {
  if (!(scene.gravity > 0.0)) return "";
  const AnyNormal law{laws.normal};
  const double d = scene.usual_diameter();
  const double m = scene.usual_mass();
  const auto speed = [&](double force) {
    const double distance = d - static_overlap(law, m, d, force);
    const auto touch = make_touch(distance, 1.0 / distance, d, reach(law) * d, 0.0, m);
    return std::sqrt(normal_force(law, touch).stiffness / m) * d;
  };
  const double weight = scene.grain_weight();
  return fmt::format("sound            {:.4g} under one grain, {:.4g} under the column{}\n", speed(weight),
                     speed(scene.expected_column() * weight), scene.units == "SI" ? " [m/s]" : "");
}

}  // namespace

std::string describe(const Scene& scene) {
  std::string text = fmt::format("scene            {}\n", scene.title.empty() ? "(untitled)" : scene.title);
  text += fmt::format("grains           {}; diameters {:g} to {:g}\n", grains_text(scene), scene.smallest_diameter(),
                      scene.largest_diameter());
  for (const auto& species : scene.species) text += describe_species(species, scene);
  text += fmt::format("base             {}\n", scene.base->describe());
  if (!scene.start.from.empty()) {
    text += fmt::format("start            {}: {} moving grains{}{}\n", scene.start.path, scene.start.moving,
                        scene.start.histories ? ", contacts remembered" : "", scene.start.at_rest ? ", from rest" : "");
    text += scene.start.description;
  }
  if (scene.method->traits().has_forces()) text += describe_materials(scene);
  text += scene.method->describe(scene);
  if (!scene.method->traits().follows_time) return text;
  text += fmt::format("stop             {}\n", stop_text(scene));
  const double end = expected_end(scene);
  text += fmt::format("expected         {:.3g} steps, {:.3g} grain-steps to time {:.5g}\n", end / scene.time_step(),
                      expected_work(scene, end), end);
  return text;
}

std::string describe_contacts(const Scene& scene) {
  const auto names = scene.material_names();
  const auto laws = scene.material_laws();
  const double d = scene.usual_diameter();
  const double step = scene.time_step();
  const double weight = scene.grain_weight();
  const double column = scene.expected_column();
  // The speed after a fall of one diameter; without gravity, a thousandth of a diameter in a time step.
  const double speed = scene.gravity > 0.0 ? std::sqrt(2.0 * scene.gravity * d) : 1e-3 * d / step;
  std::string text = fmt::format("contacts         grains of {:g} that meet at {:.3g}", d, speed);
  if (weight > 0.0) text += fmt::format("; overlaps at rest in diameters, a column of {:.0f} grains", column);
  text += "\n";
  text += fmt::format("  {:24} {:>11} {:>12} {:>12} {:>12} {:>7}\n", "between", "restitution", "contact time",
                      "under one", "under column", "steps");
  std::string adhesion;
  std::string warnings;
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a; b < names.size(); ++b) {
      const auto& of_pair = laws.table[a * names.size() + b];
      const AnyNormal law{of_pair.normal};
      const double m = 2.0 * scene.mass_of(d, names[a]) * scene.mass_of(d, names[b]) /
                       (scene.mass_of(d, names[a]) + scene.mass_of(d, names[b]));
      const auto impact = head_on(law, {.mass = m, .reduced_mass = 0.5 * m, .diameter = d, .speed = speed});
      const double steps = impact.duration / step;
      const double under_column = rest_overlap(of_pair, m, d, column * weight) / d;
      const auto between = names.size() == 1 ? std::string("any two") : names[a] + " and " + names[b];
      const auto shown = [&](double overlap) { return weight > 0.0 ? fmt::format("{:.3g}", overlap) : "-"; };
      text += fmt::format("  {:24} {:11.4f} {:12.4g} {:>12} {:>12} {:7.1f}\n", between, impact.restitution,
                          impact.duration, shown(rest_overlap(of_pair, m, d, weight) / d), shown(under_column), steps);
      adhesion += adhesion_text(of_pair, d, weight, between);
      constexpr double least_steps = 10.0;
      constexpr double most_overlap = 0.05;
      if (steps < least_steps) {
        warnings += fmt::format("warning          {}: fewer than {:g} steps in a contact\n", between, least_steps);
      }
      constexpr double nearly_undamped = 0.95;
      const auto& tangential = of_pair.tangential;
      if (impact.restitution > nearly_undamped && std::holds_alternative<Cumulative>(tangential)) {
        warnings += fmt::format(
            "warning          {}: the cumulative law creates energy in oblique impacts, several per cent at a friction "
            "of 0.5, which so little damping does not hide\n",
            between);
      }
      if (under_column > most_overlap) {
        warnings += fmt::format("warning          {}: overlaps of more than {:g} % under the column\n", between,
                                100.0 * most_overlap);
      }
    }
  }
  text += adhesion + sound_text(scene, laws.table.front());
  if (const double largest = scene.largest_step_of_bed(); step > largest) {
    warnings += fmt::format(
        "warning          grains of a dense bed under the column may never come to rest at this step; at {:.3g} and "
        "below they do\n",
        largest);
  }
  return text + warnings;
}

std::string describe_column(const ColumnState& column) {
  const auto number = [](double x, const char* format) {
    return std::isnan(x) ? std::string("-") : fmt::format(fmt::runtime(format), x);
  };
  const bool round = !std::isnan(column.radius);
  auto text = fmt::format("column           height {}, {} {:.4g}, solid fraction {}\n", number(column.height, "{:.3f}"),
                          round ? "radius" : "width", round ? column.radius : column.width,
                          number(column.solid_fraction, "{:.4f}"));
  if (std::isnan(column.load_ratio)) return text;
  text += fmt::format("floor carries    {:.3f} of the weight; by Janssen {}: K {}, friction at the walls {}\n",
                      column.load_ratio, number(column.janssen_ratio, "{:.3f}"),
                      column.stress_ratio
                          ? fmt::format("{:.3f} +- {:.2g}", column.stress_ratio->mean, column.stress_ratio->error)
                          : "-",
                      number(column.friction, "{:.3f}"));
  return text;
}

/// How the run ended, and what makes its results doubtful.
template <int D>
std::string describe_end(const Record<D>& record) {
  const auto& facts = record.facts;
  std::string text = fmt::format(
      "stopped          {} (time {:.6g}, {} steps, {:.1f} s, {:.3g} grain-steps per second)\n", facts.message,
      facts.time, facts.steps, facts.wall_seconds, facts.grain_steps / std::max(facts.wall_seconds, 1e-9));
  text += fmt::format("grains           {} present, {} lost\n", moving_count(*record.grains), facts.lost);
  text += describe_solver(record.scene, record.series);
  for (const auto& warning : warnings_of(record)) text += fmt::format("warning          {}\n", warning);
  return text;
}
template std::string describe_end(const Record<2>&);
template std::string describe_end(const Record<3>&);

std::string describe_result(const Record<2>& record, const Results<2>& results) {
  std::string text = describe_end(record);
  if (results.packing) text += describe_packing(*results.packing);
  if (!results.packing_problem.empty())
    text += fmt::format("packing          not measured: {}\n", results.packing_problem);
  if (!record.scene.method->traits().has_forces()) {
    return text + fmt::format("deepest overlap  {:.2g} diameters; {} discs break the rule of rest\n",
                              results.max_overlap, results.breaking_rule);
  }
  const auto& heap = results.heap;
  const auto flank = [](const std::optional<FlankLine>& line) {
    return line ? fmt::format("{:.1f}", line->angle_deg) : std::string("-");
  };
  text += fmt::format("angle of repose  left {} right {} moments {} deg\n", flank(heap.left), flank(heap.right),
                      heap.moments_angle_deg ? fmt::format("{:.1f}", *heap.moments_angle_deg) : "-");
  text += fmt::format("coordination     {} (contacts above {:g} {})\n", or_none(results.network.coordination, "{:.3f}"),
                      record.scene.analysis.force_threshold, force_unit_name(record.scene));
  if (results.core.grains > 0) {
    text += fmt::format("core             {} grains, solid fraction {:.4f}, coordination {:.3f}\n", results.core.grains,
                        *results.core.solid_fraction, *results.core.coordination);
  }
  if (results.column) text += describe_column(*results.column);
  text += fmt::format("deepest overlap  {:.4f} diameters\n", results.max_overlap);
  if (results.dip) text += fmt::format("dip index        {:.3f}\n", results.dip->index);
  if (results.force_range) text += describe_force_range(*results.force_range);
  if (results.stability) text += describe_stability(*results.stability);
  if (results.slips) text += describe_slips(*results.slips);
  if (!results.motion.rows.empty()) {
    text += fmt::format("avalanches       {} of at least {} grains in {} intervals\n", results.motion.avalanches.size(),
                        record.scene.analysis.avalanche, results.motion.rows.size());
  }
  if (record.scene.gravity > 0.0) text += fmt::format("weight error     {}\n", or_none(results.weight_error, "{:.2e}"));
  return text;
}

}  // namespace repose
