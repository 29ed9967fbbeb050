// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/elasticity.hpp"
#include "repose/scene/base_kind.hpp"
#include "repose/scene/boundaries.hpp"
#include "repose/scene/contact.hpp"
#include "repose/scene/method_kind.hpp"
#include "repose/scene/output.hpp"
#include "repose/scene/source.hpp"
#include "repose/scene/source_kind.hpp"
#include "repose/scene/species.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What exists and what is to be done: a scene file, read and checked. Nothing here runs.
///
/// Each part lies with its keys and its checks in the file of its subject: contact, species, boundaries, source,
/// output, and a file for each kind of method, source and base. A scene may be read (scene/read.hpp) or filled in by
/// hand: numbers that are `unset`, empty texts and empty choices then get the defaults that they have in a file.
struct Scene {
  using Contact = MaterialContact;
  using Wall = SceneWall;
  using Load = SceneLoad;
  using Species = repose::Species;
  using Analysis = AnalysisKeys;

  std::string title;
  std::string units = "reduced";
  std::int64_t dimension = 2;  ///< 2: discs; 3: spheres
  std::int64_t seed = 1;
  double gravity = unset;                          ///< [L/T^2] its magnitude
  Coordinates gravity_direction = no_coordinates;  ///< down, along the last axis, unless the scene says otherwise

  Chosen<MethodKind> method;
  GrainSizes grains;
  std::vector<Species> species;  ///< empty: all grains as `grains` says
  Contact contact;
  std::vector<Material> materials;  ///< empty: all grains and walls are of one
  std::vector<MaterialPair> pairs;

  Chosen<BaseKind> base;
  Region box;
  std::vector<Wall> planes;  ///< endless walls
  std::vector<Wall> pieces;  ///< walls from one point to another
  std::vector<SceneDrum> drums;
  std::vector<Load> loads;

  StartFrom start;
  std::vector<PlacedGrain> placed;
  Chosen<SourceKind> source;

  StopKeys stop;
  OutputKeys output;
  AnalysisKeys analysis;

  // What follows from these. Sizes are of the grains that are drawn, those of all species or of `grains`; or of all
  // that exist: drawn, placed, base, and what a start brings.

  double smallest_drawn() const;
  double largest_drawn() const;
  double smallest_diameter() const;
  double largest_diameter() const;
  bool draws_grains() const;  ///< the source or the base draws sizes; else the sizes above are not those of any grain

  std::vector<std::string> material_names() const;
  std::uint16_t material_number(const std::string& name) const;
  bool has_moduli() const;                            ///< materials have elastic constants
  Elasticity elasticity(std::size_t material) const;  ///< of a material with moduli
  double nominal_mass() const;                        ///< [M] of a grain of the first material and d
  double usual_mass() const;  ///< [M] nominal_mass(), or where no grain is of nominal size the mean of those that are
  double usual_diameter() const;  ///< [L] of such a grain
  /// [M] goes with the square of the diameter of a disc, the cube of that of a sphere.
  double mass_of(double diameter, const std::string& material) const;
  double grain_weight() const { return usual_mass() * gravity; }  ///< [M L/T^2] the unit of force of measures
  /// [M L/T^2] Base forces are given in it: the grain weight, or 1 without gravity.
  double base_force_unit() const { return gravity > 0.0 ? grain_weight() : 1.0; }
  MaterialLaws material_laws() const;  ///< the laws of every two materials
  ImpulseLaws impulse_laws() const;

  /// [L] How high a grain rises that starts at a velocity; 0 without gravity.
  double rise(const Coordinates& velocity) const;
  double fastest_fall() const;  ///< [L/T] of any grain before it meets another, without a limit of speed
  /// The number of grains that may stand above one at the base, for overlaps at rest: all grains in a heap of 30
  /// degrees.
  double expected_column() const { return source->column(*this); }
  double contact_reach() const;        ///< two grains act on each other within this times the sum of their radii
  double contact_frequency() const;    ///< [1/T] of the stiffest contact that a time step is judged by
  double largest_step_of_bed() const;  ///< [T] with which grains under the expected column come to rest
  /// What a piston needs to be stable against the grains that may touch it at once.
  struct LeastPiston {
    double mass = 0.0;    ///< [M]
    double grains = 1.0;  ///< their estimated number
  };
  template <int D>
  LeastPiston least_piston(const repose::Wall<D>& piston) const;

  template <int D>
  Vec<D> gravity_vector() const;  ///< [L/T^2]
  std::size_t vertical() const {
    return static_cast<std::size_t>(dimension - 1);
  }  ///< place of the height in coordinates

  double time_step() const { return method->time_step(*this); }
  std::optional<double> speed_limit() const { return method->speed_limit(*this); }
  bool synchronised() const { return method->synchronised(*this); }
};

}  // namespace repose
