// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/keys.hpp"

#include "repose/scene/key_groups.hpp"

namespace repose {

namespace {

void deposition_keys(Scene& scene, Keys& keys) {
  keys.number("method.critical_angle", scene.method.critical_angle, required, {.low = 0.0, .high = 90.0}, "deg",
              "a disc sticks where its contact is less than this off upright: 0 steepest descent, 90 first touch");
  keys.choice(
      "method.arithmetic", scene.method.arithmetic, "auto", {"auto", "snapped", "double"},
      "snapped: places are multiples of 2^-40 radii, so that rounding cannot grow from layer to layer (auto: at "
      "exactly 0 degrees)");
}

void rigid_keys(Scene& scene, Keys& keys) {
  auto& method = scene.method;
  keys.optional_number("method.time_step", method.time_step, "auto", positive, "T",
                       "\"auto\": g dt^2 is a tenth of the smallest radius, and no fall goes half of that in a step");
  keys.optional_number(
      "method.critical_angle", method.rolling_angle, "", {.low = 0.0, .high = 90.0}, "deg",
      "theta_c of deposition as a law: rolling friction tan(theta_c), 90 for infinite, and no sliding");
  keys.optional_number("method.speed_limit", method.speed_limit, "auto", positive, "L/T",
                       "no grain is faster before it meets others; \"auto\": g dt for a sequential source, else none");
  keys.choice("method.solver", method.solver, "accelerated", {"accelerated", "sweeps"},
              "conjugate residuals over symmetric sweeps of nonlinear Gauss-Seidel, or the sweeps alone");
  keys.number("method.tolerance", method.tolerance, 1e-5, positive, "g dt",
              "largest residual velocity of a contact; the true residual, computed apart from the solver");
  keys.integer("method.most_sweeps", method.most_sweeps, 2000, 1, "forward and backward, before a step is given up");
  keys.choice("method.unconverged", method.unconverged, "warn", {"warn", "error"},
              "steps given up are counted and reported, or stop the run");
  keys.number("method.overlap_recovery", method.overlap_recovery, 0.05, {.low = 0.0, .high = 1.0}, "",
              "share of an overlap that a step takes back");
  keys.number("method.skin", method.skin, 0.3 * scene.grains.diameter, positive, "L",
              "extra reach of the pair list; changes speed, never results beyond rounding");
}

void method_keys(Scene& scene, Keys& keys) {
  keys.choice("method.kind", scene.method.kind, "soft", {"soft", "contact-dynamics", "deposition"},
              "how the grains are moved: by forces, as rigid grains by impulses, or dropped one by one by the "
              "critical-angle rule");
  if (scene.method.deposits()) return deposition_keys(scene, keys);
  if (scene.method.rigid()) return rigid_keys(scene, keys);
  keys.optional_number("method.time_step", scene.method.time_step, "auto", positive, "T",
                       "\"auto\": half a radian of the stiffest contact, and with which a dense bed comes to rest");
  keys.choice("method.velocities", scene.method.velocities, "auto", {"auto", "half-step", "synchronised"},
              "velocities in forces: of the half step, or predicted for the full one (auto: for size ratios above 2)");
  keys.number("method.skin", scene.method.skin, 0.3 * scene.grains.diameter, positive, "L",
              "extra reach of the pair list; changes speed, never results beyond rounding");
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
  keys.choice("grains.shares", scene.grains.shares, "number", {"number", "mass"},
              "of what the shares of the [[species]] are shares");
  method_keys(scene, keys);
  if (!scene.method.deposits()) law_keys(scene, keys);
  species_keys(scene, keys);
  boundary_keys(scene, keys);
  source_keys(scene, keys);
  run_keys(scene, keys);
}

}  // namespace repose
