// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/inertia_factor.hpp"
#include "repose/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// The part of a grain that a pair force reads and writes in every step: one 64-byte line in 2D, two in 3D.
template <int D>
struct alignas(64) Grain {
  Vec<D> velocity{};          ///< [L/T]
  Spin<D> rim_velocity{};     ///< [L/T] angular velocity times radius
  double inverse_mass = 0.0;  ///< [1/M] 0: fixed, neither moves nor rotates
  Vec<D> position{};          ///< [L]
  double radius = 0.0;        ///< [L]
  double mass = 0.0;          ///< [M] nominal mass; fixed grains have one too

  bool fixed() const { return inverse_mass == 0.0; }
};
static_assert(sizeof(Grain<2>) == 64);
static_assert(sizeof(Grain<3>) == 128);

/// Velocities half a step behind the positions. Methods keep them if their `line` holds velocities predicted for the
/// full step.
template <int D>
struct HalfStep {
  Vec<D> velocity{};       ///< [L/T]
  Spin<D> rim_velocity{};  ///< [L/T]
};

/// The grains of a simulation: `line` holds what pair forces need, and each further property has an array. All arrays
/// have one entry per grain, in memory order, which follows space and changes. `id` is stable and names a grain in
/// every output.
template <int D>
struct Grains {
  std::vector<Grain<D>> line;
  std::vector<std::int64_t> id;
  std::vector<std::uint16_t> material;
  std::vector<std::uint8_t> base;  ///< 1: belongs to the base
  /// [M L/T] contact force on a fixed grain, summed over time since the last reset. A method without forces may empty
  /// it; it then stays empty.
  std::vector<Vec<D>> reaction;
  std::vector<HalfStep<D>> half_step;  ///< empty unless the method predicts velocities

  std::size_t size() const { return line.size(); }

  void add(const Grain<D>& grain, std::int64_t stable_id, bool is_base = false, std::uint16_t material_number = 0) {
    line.push_back(grain);
    id.push_back(stable_id);
    material.push_back(material_number);
    base.push_back(is_base ? 1 : 0);
    if (!reaction.empty() || line.size() == 1) reaction.push_back({});
    if (!half_step.empty()) half_step.push_back({grain.velocity, grain.rim_velocity});
  }

  /// Makes room for this many grains in total.
  void reserve(std::size_t count) {
    line.reserve(count);
    id.reserve(count);
    material.reserve(count);
    base.reserve(count);
    reaction.reserve(count);
  }

  void exchange(Archive& archive) {
    archive.array("grains/line", line);
    archive.array("grains/id", id);
    archive.array("grains/material", material);
    archive.array("grains/base", base);
    archive.array("grains/reaction", reaction);
    archive.array("grains/half_step", half_step);
    for (const auto count : {id.size(), material.size(), base.size()}) {
      archive.check("grains", count == size());
    }
    archive.check("grains/reaction", reaction.empty() || reaction.size() == size());
    archive.check("grains/half_step", half_step.empty() || half_step.size() == size());
  }

  /// Takes grains of another array: entry k is its entry order[k]. The memory of this array is used again.
  void take(const Grains& from, const std::vector<std::uint32_t>& order) {
    take(from.line, order, line);
    take(from.id, order, id);
    take(from.material, order, material);
    take(from.base, order, base);
    reaction.clear();
    if (!from.reaction.empty()) take(from.reaction, order, reaction);
    half_step.clear();
    if (!from.half_step.empty()) take(from.half_step, order, half_step);
  }

  void swap(Grains& other) noexcept {
    line.swap(other.line);
    id.swap(other.id);
    material.swap(other.material);
    base.swap(other.base);
    reaction.swap(other.reaction);
    half_step.swap(other.half_step);
  }

  /// Reorders (or drops) grains: entry k of the new arrays is entry order[k] of the old.
  void reorder(const std::vector<std::uint32_t>& order) {
    Grains taken;
    taken.take(*this, order);
    swap(taken);
  }

 private:
  template <class T>
  static void take(const std::vector<T>& from, const std::vector<std::uint32_t>& order, std::vector<T>& to) {
    to.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) to[k] = from[order[k]];
  }
};

/// The order of the grains by ascending stable id: entry k is the index in memory of the k-th smallest id.
template <int D>
std::vector<std::uint32_t> by_id(const Grains<D>& grains);

/// Number of grains that can move.
template <int D>
std::size_t moving_count(const Grains<D>& grains);

/// Kinetic energy of translation and rotation [M L^2/T^2] of one grain, from its nominal mass.
template <int D>
double kinetic_energy(const Grain<D>& grain) {
  return 0.5 * grain.mass *
         (dot(grain.velocity, grain.velocity) + squared(grain.rim_velocity) / inverse_inertia_factor<D>);
}

/// Kinetic energy of translation and rotation [M L^2/T^2] of all grains that can move, summed in order of id.
template <int D>
double kinetic_energy(const Grains<D>& grains);

}  // namespace repose
