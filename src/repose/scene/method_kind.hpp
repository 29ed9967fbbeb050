// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/dimension.hpp"
#include "repose/scene/kind.hpp"
#include "repose/scene/problems.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace repose {

struct Scene;
template <int D>
class Method;

/// What the rest of the program asks of a method, instead of its name.
struct MethodTraits {
  /// Grains move in time. False: they are put in place one by one, and time counts them; there are no walls, loads,
  /// placed grains, starts and stops then.
  bool follows_time = true;
  bool force_laws = false;     ///< contacts have laws of force, and explicit steps are judged by their stiffness
  bool impulse_laws = false;   ///< grains are rigid: contacts have the law of impulses
  bool keeps_energy = false;   ///< can keep the energy budget
  bool collides = false;       ///< counts hard collisions and contacts that turn soft
  double contact_gap = 1e-9;   ///< [mean diameters] closer grains touch in a packing, unless the scene says otherwise
  double typical_speed = 1e7;  ///< grain-steps of discs per second of one core, roughly

  /// Contacts carry forces, and have laws in the scene.
  bool has_forces() const { return force_laws || impulse_laws; }
  std::string_view time_unit() const { return follows_time ? "T" : "discs"; }
};

/// How the solver of a method goes about it.
struct SolverLimits {
  double tolerance = 1e-5;          ///< [gravity times time step] largest residual velocity of a contact
  std::int64_t most_sweeps = 2000;  ///< forward and backward, before a step is given up
  std::string unconverged = "warn";

  /// Whether a step that is given up ends the run.
  bool stops() const { return unconverged == "error"; }
};

/// The contacts of a method whose grains are rigid in flight and springs at rest.
struct RestingContacts {
  double stiffness = 0.0;  ///< [M/T^2] of every contact that carries force, with grains and with walls
  bool pinned = false;     ///< walls hold the grains that stand on them along themselves
};

/// A method as a scene chooses it.
class MethodKind : public AnyKind<MethodKind> {
 public:
  /// Whether it moves grains in so many dimensions.
  virtual bool in_dimension(std::int64_t dimension) const { return dimension == 2; }
  virtual MethodTraits traits() const = 0;

  /// The keys method.*, besides the kind.
  virtual void keys(const Scene& scene, Parameters& keys) = 0;
  virtual void check(const Scene& scene, Problems& problems) const = 0;

  virtual double automatic_step(const Scene& scene) const = 0;  ///< [T]
  virtual double time_step(const Scene& scene) const = 0;       ///< [T] given or automatic

  /// [L/T] No grain is faster before it meets others; none: there is no limit.
  virtual std::optional<double> speed_limit(const Scene& /*scene*/) const { return std::nullopt; }
  /// Forces are computed from velocities predicted for the full step.
  virtual bool synchronised(const Scene& /*scene*/) const { return false; }
  /// [deg] Grains roll on others that lean more than this: sets the usual law of impulses.
  virtual std::optional<double> usual_rolling_angle() const { return std::nullopt; }
  /// None where the laws of the contacts decide, or contacts are rigid.
  virtual std::optional<RestingContacts> resting_contacts(const Scene& /*scene*/) const { return std::nullopt; }
  /// Null for a method without a solver.
  virtual const SolverLimits* solver() const { return nullptr; }
  /// [deg] Of the rule by which grains are put in place; none where nothing is.
  virtual std::optional<double> sticking_angle() const { return std::nullopt; }

  /// Lines for `repose check`: laws, step, and what else decides how it runs.
  virtual std::string describe(const Scene& scene) const = 0;

  /// The method ready to run: defined in simulation/methods, so that a scene needs to know nothing that runs.
  virtual std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const = 0;
  /// Null for a method that moves discs alone.
  virtual std::unique_ptr<Method<3>> make(const Scene& scene, Dimension<3>) const;
};

Kinds<MethodKind>& method_kinds();

inline constexpr std::string_view usual_method = "soft";  ///< of a scene that names none

}  // namespace repose
