// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/size_distribution.hpp"
#include "repose/laws/impulse_law.hpp"
#include "repose/laws/registry.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What is there and what is to be done: a scene file, read and checked. Nothing here runs.
/// Every key is described once, in scene/keys.cpp, for the reader, the writer and the reference.
struct Scene {
  std::string title;
  std::string units = "reduced";
  std::int64_t seed = 1;
  double gravity = 1.0;  ///< [L/T^2] along -y

  struct Method {
    std::string kind;
    std::optional<double> time_step;  ///< [T]; none: "auto"
    std::string velocities;           ///< "auto", "half-step" or "synchronised"
    double skin = 0.0;                ///< [L]
    double critical_angle = 0.0;      ///< [deg] of deposition
    std::string arithmetic;           ///< of deposition: "auto", "snapped" or "double"

    // Of contact dynamics.
    std::optional<double> rolling_angle;  ///< [deg] the critical angle as a law of rolling
    std::optional<double> speed_limit;    ///< [L/T] of free velocities; none: "auto"
    std::string solver;                   ///< "accelerated" or "sweeps"
    double tolerance = 0.0;               ///< [gravity times time step]
    std::int64_t most_sweeps = 0;
    std::string unconverged;        ///< "warn" or "error"
    double overlap_recovery = 0.0;  ///< share of an overlap that a step takes back

    bool deposits() const { return kind == "deposition"; }
    /// Whether grains are rigid: contacts have impulses instead of forces.
    bool rigid() const { return kind == "contact-dynamics"; }
  } method;

  struct GrainSizes {
    double diameter = 1.0;        ///< [L] the largest, and that of base grains
    double mass = 1.0;            ///< [M] of a grain of that diameter
    double polydispersity = 0.0;  ///< sizes uniform in [(1 - p) d, d]
    std::string shares;           ///< of the species: by "number" or "mass"
  } grains;

  /// Grains of one kind.
  struct Species {
    std::string name;
    std::string material;
    double share = 1.0;  ///< over the sum of all shares
    struct Sizes {
      std::string kind;       ///< "fixed", "uniform", "normal", "log-normal", "table" or "sieve"
      double diameter = 0.0;  ///< [L] and so on
      double low = 0.0;
      double high = 0.0;
      double mean = 0.0;
      double deviation = 0.0;
      std::vector<double> diameters;
      std::vector<double> weights;
      std::vector<double> passing;

      double smallest() const;
      double largest() const;
      SizeDistribution distribution() const;  ///< of a sound scene
    } sizes;
  };
  std::vector<Species> species;  ///< empty: all grains as [grains] says

  /// What acts between two materials; friction is kept in the tangential law too.
  struct Contact {
    double friction = 0.0;
    NormalLaw normal;
    TangentialLaw tangential;
    RollingLaw rolling;
    CohesionLaw cohesion;
    ImpulseLaw impulse;  ///< of contact dynamics, instead of those above

    ContactLaws laws() const { return {normal, tangential, rolling, cohesion}; }
  } contact;

  struct Material {
    std::string name;
    double density = 1.0;  ///< over that of a grain of grains.mass and grains.diameter
  };
  std::vector<Material> materials;  ///< empty: all is of one

  struct Pair {
    std::string first;
    std::string second;
    Contact contact;
  };
  std::vector<Pair> pairs;

  struct Base {
    std::string kind;         ///< "row", "deposited", "plane" or "none"; "contiguous", "flat" or "disordered"
    std::int64_t count = 0;   ///< of deposition: the width in diameters, and the discs of a contiguous base
    double spacing = 0.0;     ///< [L] between the centres of a row
    double roughness = 0.0;   ///< [L] how far centres of a deposited base lie below height 0 at most
    double half_width = 0.0;  ///< [L]
    bool smooth = false;      ///< of a plane
    std::string material;

    bool of_grains() const { return kind == "row" || kind == "deposited" || kind == "contiguous"; }
  } base;

  struct Region {
    std::string x;                ///< "open" or "periodic"; "walls" of deposition
    double half_width = 0.0;      ///< [L]
    std::optional<double> floor;  ///< [L] grains that fall below are lost; none: "auto"
  } box;

  /// A plane (point, normal) or a straight piece of wall (from, to), and what moves it.
  struct Wall {
    std::string name;
    std::array<double, 2> point{};
    std::array<double, 2> normal{};
    std::array<double, 2> from{};
    std::array<double, 2> to{};
    bool smooth = false;
    std::string material;
    std::string motion;  ///< "fixed", "velocity", "force" or "spring"
    std::array<double, 2> velocity{};
    std::array<double, 2> force{};
    double stiffness = 0.0;          ///< [M/T^2] of the spring
    double mass = 0.0;               ///< [M]
    double drag = 0.0;               ///< [M/T]
    double start = 0.0;              ///< [T]
    std::optional<double> opens_at;  ///< [T] not there from then on
  };
  std::vector<Wall> planes;
  std::vector<Wall> pieces;

  struct Load {
    std::int64_t grain = -1;           ///< id, or -1: the moving grain nearest to the position
    std::array<double, 2> position{};  ///< [L]
    std::array<double, 2> force{};     ///< [M L/T^2]
    double start = 0.0;                ///< [T]
  };
  std::vector<Load> loads;

  struct Placed {
    std::array<double, 2> position{};
    std::array<double, 2> velocity{};
    double spin = 0.0;
    double diameter = 0.0;
    bool fixed = false;
    std::string material;
  };
  std::vector<Placed> placed;

  /// Grains that are there at the start, from elsewhere.
  struct Start {
    std::string from;        ///< a run folder, its run.h5, or a file of grains; "": nothing
    std::int64_t step = -1;  ///< of the snapshot of a LAMMPS dump; -1: the last
    bool at_rest = false;    ///< velocities are left behind

    // What `read_scene` finds there.
    std::string path;        ///< from, as the program opens it
    bool histories = false;  ///< contacts remember what they did in the run that it comes from
    bool base = false;       ///< some of the grains are base grains
    std::int64_t moving = 0;
    double smallest = 0.0;  ///< [L] diameter; 0 without grains
    double largest = 0.0;   ///< [L]
    double fall = 0.0;      ///< [L] height from which the fastest grain seems to fall
  } start;

  struct Source {
    std::string kind;  ///< "pour", "rain", "lattice", "sequential" or "none"
    std::int64_t count = 0;
    double rate = 0.0;         ///< [1/T]
    double height = 0.0;       ///< [L]
    std::string height_above;  ///< "base" or "apex"
    double half_width = 0.0;   ///< [L]
    double x = 0.0;            ///< [L]
    std::array<double, 2> velocity{};
    std::int64_t rows = 0;     ///< of a lattice
    std::int64_t columns = 0;  ///< of a block; 0: a pile
    double gap = 0.0;          ///< [L] of a block, between grains of the largest size
    double jitter = 0.0;       ///< of a block: displacements over half a gap
    double rest = 0.0;         ///< [gravity times time step] of a sequential source

    bool drops() const { return kind == "pour" || kind == "rain"; }
  } source;

  struct Stop {
    std::optional<double> at_rest;
    std::optional<double> time;  ///< [T]
  } stop;

  struct Output {
    double series = 0.0;      ///< [T] between two rows of the time series
    double frames = 0.0;      ///< [T] between two saved frames; 0: none
    double window = 0.0;      ///< [T] over which base forces are averaged
    double track = 0.0;       ///< [T] between two moments of the track; 0: none
    double checkpoint = 0.0;  ///< [s] of wall time between checkpoints; 0: only when interrupted
    bool energy = false;      ///< keep account of the energy
  } output;

  struct Analysis {
    double bin_width = 0.0;        ///< [L]
    double force_threshold = 0.0;  ///< [grain weights]
    double base_bin = 0.0;         ///< [L]
    double field_width = 0.0;      ///< [L]
    double core_depth = 0.0;       ///< [L]
    double moved = 0.0;            ///< [L]
    std::int64_t avalanche = 0;    ///< grains
    double burst = 0.0;            ///< [grain weights times diameters]

    bool packing = false;          ///< measure the packing in a slab
    std::array<double, 2> slab{};  ///< its edges above the base centres, over the mean height of the grains
    double contact_gap = 0.0;      ///< [mean diameters of the pair]
    std::int64_t direction_bins = 0;
    bool correlations = false;
    bool structure_factor = false;
    bool local_density = false;
  } analysis;

  /// Whether places are snapped in a deposition: where asked for, and at exactly 0 degrees unless asked not to.
  bool snapped() const {
    return method.arithmetic == "snapped" || (method.arithmetic == "auto" && method.critical_angle == 0.0);
  }

  double grain_weight() const { return grains.mass * gravity; }
  double base_pitch() const;  ///< [L] between neighbours of a lattice pile's lowest row
  /// Whether the grains of a block touch and lie in the hollows of the base row, as those of a pile do.
  bool block_nests() const;
  double block_pitch() const;  ///< [L] between neighbours in a row of a block
  /// The sizes of grains that are drawn: of all species, or of [grains].
  double smallest_drawn() const;
  double largest_drawn() const;
  /// Of everything that is there: drawn, placed, base and what a start brings.
  double smallest_diameter() const;
  double largest_diameter() const;
  std::vector<std::string> material_names() const;
  std::uint16_t material_number(const std::string& name) const;
  double mass_of(double diameter, const std::string& material) const;  ///< [M] goes with the square of the diameter
  /// The laws of every two materials.
  MaterialLaws material_laws() const;
  ImpulseLaws impulse_laws() const;
  /// The number of grains that may stand above one at the base, for overlaps at rest: all grains in a heap of 30
  /// degrees.
  double expected_column() const;
  double time_step() const;                   ///< [T] given or automatic
  double automatic_step() const;              ///< [T]
  double fastest_fall() const;                ///< [L/T] of any grain before it meets another, without a limit of speed
  std::optional<double> speed_limit() const;  ///< [L/T] of contact dynamics, given or automatic
  double largest_step_of_bed() const;         ///< [T] with which grains under the expected column come to rest
  bool synchronised() const;                  ///< given, or chosen for size ratios above 2
  double contact_frequency() const;           ///< [1/T] of the stiffest contact that the time step is judged by
};

/// Size ratio above which velocities are predicted for the full step unless the scene says otherwise.
inline constexpr double synchronised_above_ratio = 2.0;

}  // namespace repose
