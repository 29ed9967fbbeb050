// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/laws/registry.hpp"
#include "repose/scene/materials.hpp"

#include <optional>
#include <string>

namespace repose {

class Problems;
struct Scene;

/// What acts between two materials. Friction is kept in the tangential law too.
struct MaterialContact {
  double friction = unset;
  NormalLaw normal;
  TangentialLaw tangential;
  RollingLaw rolling;
  CohesionLaw cohesion;
  TwistingLaw twisting;                    ///< of spheres
  std::optional<double> second_stiffness;  ///< a stiffness that is given beside the moduli of the materials: an error
  /// The law of rigid grains, instead of those above.
  ImpulseLaw impulse{.restitution = unset,
                     .tangential_restitution = unset,
                     .friction = unset,
                     .rolling_friction = unset,
                     .dynamic_friction = unset,
                     .weakening_velocity = unset};

  ContactLaws laws() const { return {normal, tangential, rolling, cohesion, twisting}; }
};

/// Two materials between which something else acts than [contact] says.
struct MaterialPair {
  std::string first;
  std::string second;
  MaterialContact contact;
};

/// [[material]], contact.* and [[pair]].
void contact_keys(Scene& scene, Parameters& keys);
void check_contact(const Scene& scene, Problems& problems);

/// The name of a material of the scene; the first unless it is given.
void material_key(std::string_view key, std::string& material, const Scene& scene, Parameters& keys);

/// Lines for `repose check`: the laws of force, or the law of rigid grains, of all pairs.
std::string describe_force_laws(const Scene& scene);
std::string describe_impulse_laws(const Scene& scene);

}  // namespace repose
