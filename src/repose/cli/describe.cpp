// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/describe.hpp"

#include "repose/run/expectation.hpp"
#include "repose/run/reading.hpp"
#include "repose/run/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

struct LawText {
  std::string operator()(const Continuous& law) const {
    return fmt::format("continuous, F = m g (s/r)^{:g} out to {:g} diameters, damping {:g} of critical",
                       law.exponent + 1, law.cutoff, law.damping);
  }
  std::string operator()(const Hooke& law) const {
    return fmt::format("hooke, k = {:g}, damping {:g} of critical", law.stiffness, law.damping);
  }
  std::string operator()(const Cumulative& law) const {
    return fmt::format("cumulative, friction {:g}, alpha {:g}", law.friction, law.alpha);
  }
  std::string operator()(const Linear& law) const {
    return fmt::format("linear, friction {:g}, k_t = {:g}, damping {:g}", law.friction, law.stiffness, law.damping);
  }
  std::string operator()(const None&) const { return "none: smooth grains"; }
};

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

std::string describe(const Scene& scene) {
  const auto initial = initial_grains(scene);
  const auto fixed = initial.size() - moving_count(initial);
  const double step = scene.time_step();
  std::string text = fmt::format("scene            {}\n", scene.title.empty() ? "(untitled)" : scene.title);
  text += fmt::format("grains           {} poured, {} placed, {} fixed; diameters {:g} to {:g}\n", scene.source.count,
                      moving_count(initial), fixed, scene.smallest_diameter(), scene.largest_diameter());
  text += fmt::format("normal law       {}\n", std::visit(LawText{}, scene.contact.normal));
  text += fmt::format("tangential law   {}\n", std::visit(LawText{}, scene.contact.tangential));
  text +=
      fmt::format("time step        {:.6g} ({}; w dt = {:.3g} for the stiffest contact of a fall from the source)\n",
                  step, scene.method.time_step ? "given" : "auto", step * scene.contact_frequency());
  text +=
      fmt::format("velocities       {}{}\n", scene.synchronised() ? "synchronised" : "half-step",
                  scene.method.velocities == "auto"
                      ? fmt::format(" (auto; size ratio {:.3g})", scene.largest_diameter() / scene.smallest_diameter())
                      : "");
  text += fmt::format("stop             {}\n", stop_text(scene));
  const double end = expected_end(scene);
  text += fmt::format("expected         {:.3g} steps, {:.3g} grain-steps to time {:.5g}\n", end / step,
                      expected_work(scene, end), end);
  return text;
}

std::string describe_result(const Record& record, const Reading& reading) {
  const auto& facts = record.facts;
  std::string text = fmt::format(
      "stopped          {} (time {:.6g}, {} steps, {:.1f} s, {:.3g} grain-steps per second)\n", facts.message,
      facts.time, facts.steps, facts.wall_seconds, facts.grain_steps / std::max(facts.wall_seconds, 1e-9));
  text += fmt::format("grains           {} present, {} lost\n", moving_count(record.grains), facts.lost);
  const auto& heap = reading.heap;
  const auto flank = [](const std::optional<FlankLine>& line) {
    return line ? fmt::format("{:.1f}", line->angle_deg) : std::string("-");
  };
  text += fmt::format("angle of repose  left {} right {} moments {} deg\n", flank(heap.left), flank(heap.right),
                      heap.moments_angle_deg ? fmt::format("{:.1f}", *heap.moments_angle_deg) : "-");
  text += fmt::format("coordination     {} (contacts above {:g} grain weights)\n",
                      or_none(reading.network.coordination, "{:.3f}"), record.scene.analysis.force_threshold);
  if (reading.core.grains > 0) {
    text += fmt::format("core             {} grains, solid fraction {:.4f}, coordination {:.3f}\n", reading.core.grains,
                        *reading.core.solid_fraction, *reading.core.coordination);
  }
  text += fmt::format("deepest overlap  {:.4f} diameters\n", reading.max_overlap);
  if (reading.dip) text += fmt::format("dip index        {:.3f}\n", reading.dip->index);
  if (!reading.motion.rows.empty()) {
    text += fmt::format("avalanches       {} of at least {} grains in {} intervals\n", reading.motion.avalanches.size(),
                        record.scene.analysis.avalanche, reading.motion.rows.size());
  }
  text += fmt::format("weight error     {}\n", or_none(reading.weight_error, "{:.2e}"));
  return text;
}

}  // namespace repose
