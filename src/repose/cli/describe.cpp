// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/describe.hpp"

#include "repose/laws/impact.hpp"
#include "repose/results/results.hpp"
#include "repose/simulation/expectation.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// The parameters of a law, name by name.
class ParameterText final : public Parameters {
 public:
  void number(std::string_view name, double& value, double, const Bounds&, std::string_view,
              std::string_view) override {
    text += fmt::format(", {} {:g}", name, value);
  }
  void flag(std::string_view name, bool& value, bool, std::string_view) override {
    if (value) text += fmt::format(", {}", name);
  }
  void one_of(const std::vector<Way>& ways, std::size_t& way, double& value, double) override {
    text += fmt::format(", {} {:g}", ways[way].name, value);
  }

  std::string text;
};

template <class Law>
std::string law_text(Law law, const Scene& scene) {
  const LawScales scales{scene.gravity, scene.grain_weight(), scene.grains.diameter, scene.contact.friction};
  ParameterText parameters_of;
  std::visit(
      [&](auto& one) {
        parameters_of.text = one.name;
        if constexpr (requires { one.friction; }) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, RollingSpring>) {
            parameters_of.text += fmt::format(", friction {:g}", one.friction);
          }
        }
        parameters(one, parameters_of, scales);
      },
      law);
  return parameters_of.text;
}

std::string laws_text(const Scene::Contact& contact, const Scene& scene, const std::string& of) {
  std::string text = fmt::format("normal law{}      {}\n", of, law_text(contact.normal, scene));
  text += fmt::format("tangential law{}  {}\n", of, law_text(contact.tangential, scene));
  if (!std::holds_alternative<FreeRolling>(contact.rolling)) {
    text += fmt::format("rolling{}         {}\n", of, law_text(contact.rolling, scene));
  }
  if (!std::holds_alternative<NoCohesion>(contact.cohesion)) {
    text += fmt::format("cohesion{}        {}\n", of, law_text(contact.cohesion, scene));
  }
  return text;
}

std::string species_text(const Scene::Species& species, const Scene& scene) {
  const auto& sizes = species.sizes;
  std::string text = fmt::format("species          {}: share {:g} by {}, {}", species.name, species.share,
                                 scene.grains.shares, sizes.kind);
  if (sizes.kind == "normal" || sizes.kind == "log-normal") {
    text += fmt::format(", mean {:g}, deviation {:g}", sizes.mean, sizes.deviation);
  }
  return text + fmt::format(", diameters {:g} to {:g}\n", sizes.smallest(), sizes.largest());
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

}  // namespace

namespace {

std::string describe_deposition(const Scene& scene) {
  const auto fixed = initial_grains(scene).size();
  std::string text = fmt::format("scene            {}\n", scene.title.empty() ? "(untitled)" : scene.title);
  text += fmt::format("grains           {} deposited on {} fixed; diameters {:g} to {:g}\n", scene.source.count, fixed,
                      scene.smallest_drawn(), scene.largest_drawn());
  for (const auto& species : scene.species) text += species_text(species, scene);
  text += fmt::format("base             {}, {} diameters wide, {}\n", scene.base.kind, scene.base.count,
                      scene.box.x == "periodic" ? "periodic" : "between walls");
  text += fmt::format("critical angle   {:g} deg{}\n", scene.method.critical_angle,
                      scene.snapped() ? ", places snapped to 2^-40 radii" : "");
  return text;
}

std::string impulse_text(const ImpulseLaw& law) {
  std::string text = fmt::format("rigid contacts   friction {:g}, restitution {:g}", law.friction, law.restitution);
  if (law.tangential_restitution != 0.0) text += fmt::format(", tangential {:g}", law.tangential_restitution);
  if (law.rolling_friction > 0.0) text += fmt::format(", rolling friction {:g}", law.rolling_friction);
  if (law.weakening_velocity > 0.0) {
    text += fmt::format(", friction {:g} from slip {:g} on", law.dynamic_friction, law.weakening_velocity);
  }
  return text + "\n";
}

/// The laws, the step and the solver of contact dynamics.
std::string describe_rigid(const Scene& scene) {
  const double step = scene.time_step();
  std::string text = impulse_text(scene.contact.impulse);
  for (const auto& pair : scene.pairs) {
    text += fmt::format("between          {} and {}\n{}", pair.first, pair.second, impulse_text(pair.contact.impulse));
  }
  text += fmt::format("time step        {:.6g} ({}; g dt^2 = {:.3g} radii)\n", step,
                      scene.method.time_step ? "given" : "auto",
                      scene.gravity * step * step / (0.5 * scene.smallest_diameter()));
  if (const auto limit = scene.speed_limit()) text += fmt::format("speed limit      {:.4g}\n", *limit);
  text += fmt::format("solver           {}, residual {:g} g dt, at most {} sweeps{}\n", scene.method.solver,
                      scene.method.tolerance, scene.method.most_sweeps,
                      scene.method.unconverged == "error" ? " or stop" : "");
  return text;
}

std::string describe_soft(const Scene& scene) {
  const double step = scene.time_step();
  std::string text = laws_text(scene.contact, scene, " ");
  for (const auto& pair : scene.pairs) {
    text += fmt::format("between          {} and {}\n", pair.first, pair.second);
    text += laws_text(pair.contact, scene, " ");
  }
  text += fmt::format(
      "time step        {:.6g} ({}; w dt = {:.3g} for the stiffest contact of a fall from the source; {:.3g} of the "
      "largest for a dense bed)\n",
      step, scene.method.time_step ? "given" : "auto", step * scene.contact_frequency(),
      step / scene.largest_step_of_bed());
  text +=
      fmt::format("velocities       {}{}\n", scene.synchronised() ? "synchronised" : "half-step",
                  scene.method.velocities == "auto"
                      ? fmt::format(" (auto; size ratio {:.3g})", scene.largest_diameter() / scene.smallest_diameter())
                      : "");
  return text;
}

const char* source_verb(const Scene& scene) {
  if (scene.source.kind == "sequential") return "laid down one by one";
  return scene.source.kind == "rain" ? "rained" : "poured";
}

/// How steps went that the solver gave up.
std::string describe_solver(const Record& record) {
  if (!record.scene.method.rigid()) return "";
  const auto all = solver_account(record);
  if (all.steps == 0) return "";
  std::string text = fmt::format("solver           {:.3g} sweeps a step\n",
                                 static_cast<double>(all.sweeps) / static_cast<double>(all.steps));
  if (all.unconverged > 0) {
    text += fmt::format(
        "warning          {} of {} steps did not converge within method.most_sweeps = {}: worst residual {:.2g} g dt, "
        "method.tolerance = {:g}; packings creep where that goes on\n",
        all.unconverged, all.steps, record.scene.method.most_sweeps, all.worst_residual, record.scene.method.tolerance);
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

}  // namespace

std::string describe(const Scene& scene) {
  if (scene.method.deposits()) return describe_deposition(scene);
  const auto initial = initial_grains(scene);
  const auto fixed = initial.size() - moving_count(initial);
  const double step = scene.time_step();
  std::string text = fmt::format("scene            {}\n", scene.title.empty() ? "(untitled)" : scene.title);
  text += fmt::format("grains           {} {}, {} placed, {} fixed; diameters {:g} to {:g}\n", scene.source.count,
                      source_verb(scene), moving_count(initial), fixed, scene.smallest_diameter(),
                      scene.largest_diameter());
  for (const auto& species : scene.species) text += species_text(species, scene);
  if (!scene.start.from.empty()) {
    text += fmt::format("start            {}: {} moving grains{}{}\n", scene.start.path, scene.start.moving,
                        scene.start.histories ? ", contacts remembered" : "", scene.start.at_rest ? ", from rest" : "");
  }
  text += scene.method.rigid() ? describe_rigid(scene) : describe_soft(scene);
  text += fmt::format("stop             {}\n", stop_text(scene));
  const double end = expected_end(scene);
  text += fmt::format("expected         {:.3g} steps, {:.3g} grain-steps to time {:.5g}\n", end / step,
                      expected_work(scene, end), end);
  return text;
}

std::string describe_contacts(const Scene& scene) {
  const auto names = scene.material_names();
  const auto laws = scene.material_laws();
  const double d = scene.grains.diameter;
  const double step = scene.time_step();
  const double weight = scene.grain_weight();
  const double column = scene.expected_column();
  // Of a fall of one diameter; without gravity, of a diameter in the time of the automatic step.
  const double speed = scene.gravity > 0.0 ? std::sqrt(2.0 * scene.gravity * d) : 1e-3 * d / step;
  std::string text = fmt::format(
      "contacts         grains of {:g} that meet at {:.3g}; overlaps at rest in diameters, a column of {:.0f} grains\n",
      d, speed, column);
  text += fmt::format("  {:24} {:>11} {:>12} {:>12} {:>12} {:>7}\n", "between", "restitution", "contact time",
                      "under one", "under column", "steps");
  std::string warnings;
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a; b < names.size(); ++b) {
      const AnyNormal law{laws.table[a * names.size() + b].normal};
      const double m = 2.0 * scene.mass_of(d, names[a]) * scene.mass_of(d, names[b]) /
                       (scene.mass_of(d, names[a]) + scene.mass_of(d, names[b]));
      const auto impact = head_on(law, {.mass = m, .reduced_mass = 0.5 * m, .diameter = d, .speed = speed});
      const double steps = impact.duration / step;
      const double under_column = static_overlap(law, m, d, column * weight) / d;
      const auto between = names.size() == 1 ? std::string("any two") : names[a] + " and " + names[b];
      text += fmt::format("  {:24} {:11.4f} {:12.4g} {:12.3g} {:12.3g} {:7.1f}\n", between, impact.restitution,
                          impact.duration, static_overlap(law, m, d, weight) / d, under_column, steps);
      constexpr double least_steps = 10.0;
      constexpr double most_overlap = 0.05;
      if (steps < least_steps) {
        warnings += fmt::format("warning          {}: fewer than {:g} steps in a contact\n", between, least_steps);
      }
      if (under_column > most_overlap) {
        warnings += fmt::format("warning          {}: overlaps of more than {:g} % under the column\n", between,
                                100.0 * most_overlap);
      }
    }
  }
  if (const double largest = scene.largest_step_of_bed(); step > largest) {
    warnings += fmt::format(
        "warning          grains of a dense bed under the column may never come to rest at this step; at {:.3g} and "
        "below they do\n",
        largest);
  }
  return text + warnings;
}

std::string describe_result(const Record& record, const Results& results) {
  const auto& facts = record.facts;
  std::string text = fmt::format(
      "stopped          {} (time {:.6g}, {} steps, {:.1f} s, {:.3g} grain-steps per second)\n", facts.message,
      facts.time, facts.steps, facts.wall_seconds, facts.grain_steps / std::max(facts.wall_seconds, 1e-9));
  text += fmt::format("grains           {} present, {} lost\n", moving_count(*record.grains), facts.lost);
  text += describe_solver(record);
  if (results.packing) text += describe_packing(*results.packing);
  if (!results.packing_problem.empty())
    text += fmt::format("packing          not measured: {}\n", results.packing_problem);
  if (record.scene.method.deposits()) {
    return text + fmt::format("deepest overlap  {:.2g} diameters; {} discs do not rest by the rule\n",
                              results.max_overlap, results.breaking_rule);
  }
  const auto& heap = results.heap;
  const auto flank = [](const std::optional<FlankLine>& line) {
    return line ? fmt::format("{:.1f}", line->angle_deg) : std::string("-");
  };
  text += fmt::format("angle of repose  left {} right {} moments {} deg\n", flank(heap.left), flank(heap.right),
                      heap.moments_angle_deg ? fmt::format("{:.1f}", *heap.moments_angle_deg) : "-");
  text += fmt::format("coordination     {} (contacts above {:g} grain weights)\n",
                      or_none(results.network.coordination, "{:.3f}"), record.scene.analysis.force_threshold);
  if (results.core.grains > 0) {
    text += fmt::format("core             {} grains, solid fraction {:.4f}, coordination {:.3f}\n", results.core.grains,
                        *results.core.solid_fraction, *results.core.coordination);
  }
  text += fmt::format("deepest overlap  {:.4f} diameters\n", results.max_overlap);
  if (results.dip) text += fmt::format("dip index        {:.3f}\n", results.dip->index);
  if (!results.motion.rows.empty()) {
    text += fmt::format("avalanches       {} of at least {} grains in {} intervals\n", results.motion.avalanches.size(),
                        record.scene.analysis.avalanche, results.motion.rows.size());
  }
  text += fmt::format("weight error     {}\n", or_none(results.weight_error, "{:.2e}"));
  return text;
}

}  // namespace repose
