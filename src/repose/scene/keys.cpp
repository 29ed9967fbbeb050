// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/keys.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

std::string Bounds::text() const {
  const bool low_given = std::isfinite(low);
  const bool high_given = std::isfinite(high);
  if (low_given && high_given) {
    return fmt::format("must be {} {} and {} {}", low_allowed ? ">=" : ">", low, high_allowed ? "<=" : "<", high);
  }
  if (low_given) return fmt::format("must be {} {}", low_allowed ? ">=" : ">", low);
  if (high_given) return fmt::format("must be {} {}", high_allowed ? "<=" : "<", high);
  return "must be a finite number";
}

namespace {

void method_keys(Scene& scene, Keys& keys) {
  keys.choice("method.kind", scene.method.kind, "soft", {"soft"}, "how the grains are moved");
  keys.optional_number("method.time_step", scene.method.time_step, "auto", positive, "T",
                       "\"auto\": half a radian of the stiffest contact");
  keys.choice("method.velocities", scene.method.velocities, "auto", {"auto", "half-step", "synchronised"},
              "velocities in forces: of the half step, or predicted for the full one (auto: for size ratios above 2)");
  keys.number("method.skin", scene.method.skin, 0.3 * scene.grains.diameter, positive, "L",
              "extra reach of the pair list; changes speed, never results beyond rounding");
}

void normal_keys(Scene& scene, Keys& keys) {
  static const std::vector<std::string> laws = {"continuous", "hooke"};
  std::string law = laws[scene.contact.normal.index()];
  keys.choice("contact.normal.law", law, "continuous", laws, "normal force");
  const bool same = law == laws[scene.contact.normal.index()];
  if (law == "hooke") {
    auto hooke = same ? std::get<Hooke>(scene.contact.normal) : Hooke{};
    const double weight = scene.grain_weight();
    keys.number("contact.normal.stiffness", hooke.stiffness, 500.0 * (weight > 0 ? weight : 1) / scene.grains.diameter,
                positive, "M/T^2", "spring constant k");
    keys.number("contact.normal.damping", hooke.damping, 0.5, not_negative, "", "fraction of critical");
    keys.flag("contact.normal.attraction", hooke.attraction, false, "let the dashpot pull");
    scene.contact.normal = hooke;
  } else {
    auto continuous = same ? std::get<Continuous>(scene.contact.normal) : Continuous{};
    keys.number("contact.normal.exponent", continuous.exponent, 36.0, positive, "", "n of F = m g (s/r)^(n+1)");
    keys.number("contact.normal.cutoff", continuous.cutoff, 1.2, at_least_one, "diameters",
                "r0: the force acts at distances below this; at least 1, where grains touch");
    keys.number("contact.normal.damping", continuous.damping, 0.5, not_negative, "", "fraction of critical");
    keys.flag("contact.normal.attraction", continuous.attraction, false, "let the dashpot pull");
    scene.contact.normal = Continuous::make(continuous.exponent, continuous.cutoff, continuous.damping, scene.gravity,
                                            continuous.attraction);
  }
}

void tangential_keys(Scene& scene, Keys& keys) {
  static const std::vector<std::string> laws = {"cumulative", "linear", "none"};
  std::string law = laws[scene.contact.tangential.index()];
  keys.choice("contact.tangential.law", law, "cumulative", laws, "tangential force");
  const bool same = law == laws[scene.contact.tangential.index()];
  if (law == "cumulative") {
    auto cumulative = same ? std::get<Cumulative>(scene.contact.tangential) : Cumulative{};
    keys.number("contact.tangential.alpha", cumulative.alpha, 1.214, positive, "",
                "largest displacement over friction times normal engagement");
    cumulative.friction = scene.contact.friction;
    scene.contact.tangential = cumulative;
  } else if (law == "linear") {
    auto linear = same ? std::get<Linear>(scene.contact.tangential) : Linear{};
    keys.number("contact.tangential.stiffness", linear.stiffness, required, positive, "M/T^2", "spring constant k_t");
    keys.number("contact.tangential.damping", linear.damping, 0.0, not_negative, "", "fraction of critical");
    linear.friction = scene.contact.friction;
    scene.contact.tangential = linear;
  } else {
    scene.contact.tangential = None{};
  }
}

void surroundings_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  keys.choice("base.kind", scene.base.kind, "none", {"row", "plane", "none"},
              "what the heap stands on, at height 0: a row of fixed grains, a plane, or nothing");
  if (scene.base.kind == "row") {
    keys.number("base.spacing", scene.base.spacing, d, positive, "L", "between the centres, one of them at x = 0");
    keys.number("base.half_width", scene.base.half_width, required, positive, "L", "the row covers +- this");
  } else if (scene.base.kind == "plane") {
    keys.flag("base.smooth", scene.base.smooth, false,
              "no friction, and the height of the centre as distance (Baxter et al. 1997)");
  }
  keys.choice("box.x", scene.box.x, "open", {"open", "periodic"}, "grains that leave an open box are lost and counted");
  const double room = scene.base.kind == "row" ? scene.base.half_width : 200.0 * d;
  keys.number("box.half_width", scene.box.half_width, scene.box.x == "periodic" ? room : room + 20.0 * d, positive, "L",
              "x from -half_width to half_width");
  keys.tables(
      "plane",
      [&](std::size_t count) {
        if (count > 0) scene.planes.resize(count);
        return scene.planes.size();
      },
      [&](const std::string& prefix, std::size_t k) {
        keys.vector(prefix + "point", scene.planes[k].point, std::nullopt, "L", "a point of the plane");
        keys.vector(prefix + "normal", scene.planes[k].normal, std::nullopt, "", "towards the grains");
        keys.flag(prefix + "smooth", scene.planes[k].smooth, false, "as base.smooth");
      });
}

void grains_and_source_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  keys.tables(
      "grain",
      [&](std::size_t count) {
        if (count > 0) scene.placed.resize(count);
        return scene.placed.size();
      },
      [&](const std::string& prefix, std::size_t k) {
        auto& grain = scene.placed[k];
        keys.vector(prefix + "position", grain.position, std::nullopt, "L", "centre at the start");
        keys.vector(prefix + "velocity", grain.velocity, std::array<double, 2>{0.0, 0.0}, "L/T", "at the start");
        keys.number(prefix + "spin", grain.spin, 0.0, any, "1/T", "angular velocity, counter-clockwise");
        keys.number(prefix + "diameter", grain.diameter, d, positive, "L", "mass goes with its square");
        keys.flag(prefix + "fixed", grain.fixed, false, "never moves nor turns");
      });
  keys.choice("source.kind", scene.source.kind, "none", {"pour", "lattice", "none"},
              "where grains come from: poured, or there at the start as a triangular lattice pile on the base");
  if (scene.source.kind == "lattice") {
    keys.integer("source.rows", scene.source.rows, std::nullopt, 1,
                 "of the 60-degree pile: as many grains in the lowest, one less in each above");
    keys.number("source.x", scene.source.x, 0.0, any, "L", "of the apex");
  }
  if (scene.source.kind != "pour") return;
  keys.integer("source.count", scene.source.count, std::nullopt, 1, "grains released in all");
  keys.number("source.rate", scene.source.rate, required, positive, "1/T", "grains per time; the first at time 0");
  keys.number("source.height", scene.source.height, 100.0 * d, positive, "L", "of release, above the base");
  keys.number("source.half_width", scene.source.half_width, 3.0 * d, not_negative, "L", "released at x +- this");
  keys.number("source.x", scene.source.x, 0.0, any, "L", "centre of the opening");
}

void run_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  const double time_unit = scene.gravity > 0.0 ? std::sqrt(d / scene.gravity) : 1.0;
  keys.optional_number("stop.at_rest", scene.stop.at_rest, "", positive, "",
                       "after the last grain, once kinetic energy per grain (in m g d) and force residual are below");
  keys.optional_number("stop.time", scene.stop.time, "", positive, "T", "latest end");
  keys.number("output.series", scene.output.series, time_unit, positive, "T", "between rows of the time series");
  keys.number("output.frames", scene.output.frames, 100.0 * time_unit, not_negative, "T",
              "between saved frames; 0: none");
  keys.number("output.window", scene.output.window, 10.0 * time_unit, positive, "T",
              "at the end, over which base forces are averaged");
  keys.number("output.track", scene.output.track, 0.0, not_negative, "T",
              "between moments at which the place of every grain is kept, for avalanches; 0: none");
  keys.number("analysis.bin_width", scene.analysis.bin_width, 2.0 * d, positive, "L", "of the surface profile");
  keys.number("analysis.force_threshold", scene.analysis.force_threshold, 0.2, not_negative, "grain weights",
              "contacts that carry less do not count");
  keys.number("analysis.base_bin", scene.analysis.base_bin, 5.0 * d, positive, "L", "of the binned base profile");
  keys.number("analysis.field_width", scene.analysis.field_width, 1.5 * d, positive, "L",
              "standard deviation of the Gaussian that smooths stress and density");
  keys.number("analysis.core_depth", scene.analysis.core_depth, 4.0 * d, not_negative, "L",
              "below the surface, where the core of a heap begins");
  keys.number("analysis.moved", scene.analysis.moved, 0.5 * d, positive, "L",
              "a grain that goes farther between two moments of the track has moved");
  keys.integer("analysis.avalanche", scene.analysis.avalanche, 10, 1, "grains that move at once in an avalanche");
  keys.number("analysis.burst", scene.analysis.burst, 5.0, positive, "grain weights times diameters",
              "kinetic energy of the heap above which a burst is counted");
}

}  // namespace

void go_through(Scene& scene, Keys& keys) {
  keys.text("title", scene.title, "", "what this scene is");
  keys.choice("units", scene.units, "reduced", {"reduced", "SI"},
              "reduced: grain diameter, grain mass, gravity = 1; SI: m, kg, s");
  keys.integer("seed", scene.seed, 1, 0, "of everything random");
  const bool si = scene.units == "SI";
  keys.number("gravity", scene.gravity, si ? 9.81 : 1.0, not_negative, "L/T^2", "along -y");
  keys.number("grains.diameter", scene.grains.diameter, si ? required : 1.0, positive, "L",
              "of the largest grains and of base grains");
  keys.number("grains.mass", scene.grains.mass, si ? required : 1.0, positive, "M", "of a grain of that diameter");
  keys.number("grains.polydispersity", scene.grains.polydispersity, 0.0, fraction, "",
              "p: diameters uniform in [(1 - p) d, d]");
  method_keys(scene, keys);
  keys.number("contact.friction", scene.contact.friction, 0.5, not_negative, "", "Coulomb coefficient mu");
  normal_keys(scene, keys);
  tangential_keys(scene, keys);
  surroundings_keys(scene, keys);
  grains_and_source_keys(scene, keys);
  run_keys(scene, keys);
}

}  // namespace repose
