// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/series.hpp"

#include "repose/analysis/force_network.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/analysis/wall_span.hpp"
#include "repose/core/dimension.hpp"
#include "repose/record/find_pipe.hpp"
#include "repose/record/force_unit.hpp"
#include "repose/record/recorded_wall.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace repose {

namespace {

/// The median speed of the marked grains that move; 0 where none is marked.
template <int D>
double median_speed(const Grains<D>& grains, const std::vector<bool>& marked) {
  std::vector<double> speeds;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (marked[k] && !grains.line[k].fixed()) speeds.push_back(magnitude(grains.line[k].velocity));
  }
  if (speeds.empty()) return 0.0;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle;
}

}  // namespace

template <int D>
void Series<D>::add_row(const Simulation<D>& simulation, Method<D>& method) {
  const auto& scene = simulation.scene();
  const auto& grains = simulation.grains();
  // Geometry alone holds deposited discs: there are no forces to measure while they are laid down.
  const Contacts<D> none;
  const auto& contacts = scene.method->traits().has_forces() ? simulation.contacts() : none;
  SeriesRow row;
  row.time = simulation.time();
  row.grains = static_cast<std::int64_t>(simulation.moving());
  const double threshold = scene.analysis.force_threshold * force_unit(scene, contacts);
  row.contacts = std::count_if(contacts.list.begin(), contacts.list.end(),
                               [&](const auto& contact) { return std::fabs(contact.normal_force) > threshold; });
  row.kinetic_energy_per_grain = row.grains > 0 ? kinetic_energy(grains) / static_cast<double>(row.grains) : 0.0;
  row.force_residual = force_residual(grains, contacts, scene.template gravity_vector<D>());
  row.max_overlap = max_overlap(contacts);
  row.lost = simulation.lost();
  add_walls(simulation, contacts, method);
  add_column(simulation, contacts, method);
  if (scene.output.energy) row.energy = method.energy(grains);
  if (scene.method->traits().collides) row.collisions = method.take_collision_account();
  if (scene.method->solver() != nullptr) {
    row.solver = method.take_solver_account();
    row.creep_rate = median_speed(grains, supported(grains, contacts));
  }
  rows_.push_back(row);
}

template <int D>
void Series<D>::add_walls(const Simulation<D>& simulation, const Contacts<D>& contacts, Method<D>& method) {
  const auto impulses = method.take_wall_impulses();
  if (impulses.empty()) return;
  const double time = simulation.time();
  const double duration = time - (rows_.empty() ? 0.0 : rows_.back().time);
  for (std::size_t w = 0; w < impulses.size(); ++w) {
    WallRow<D> row;
    row.displacement = method.walls()[w].displacement;
    row.force = impulses[w] * (1.0 / duration);
    walls_.push_back(row);
  }
  if constexpr (D == 2) add_spans(simulation, contacts, method);
}

/// Lengths and moments of the walls, for their last rows.
template <int D>
void Series<D>::add_spans(const Simulation<D>& simulation, const Contacts<D>& contacts, const Method<D>& method) {
  if constexpr (D == 2) {
    const auto box = make_box(simulation.scene());
    const auto& grains = simulation.grains();
    const auto spans = spans_of(recorded_walls(simulation.scene(), method.walls(), simulation.time()), grains, box);
    const auto moments = wall_moments(spans, grains, contacts, box);
    for (std::size_t w = 0; w < spans.size(); ++w) {
      auto& row = walls_[walls_.size() - spans.size() + w];
      row.length = spans[w].length;
      row.moment = moments[w];
    }
  }
}

std::size_t followed_slices(const Scene& scene) {
  if (!scene.method->traits().has_forces()) return 0;
  const bool has_pipe =
      with_dimension(scene.dimension, [&](auto dimension) { return find_pipe<dimension>(scene).has_value(); });
  return has_pipe ? static_cast<std::size_t>(scene.output.slices) : 0;
}

template <int D>
void Series<D>::add_column(const Simulation<D>& simulation, const Contacts<D>& contacts, const Method<D>& method) {
  const auto& scene = simulation.scene();
  const auto pipe = scene.method->traits().has_forces() ? find_pipe<D>(scene) : std::nullopt;
  if (!pipe) return;
  const auto walls = recorded_walls<D>(scene, method.walls(), simulation.time());
  const auto column =
      measure_column(pipe->at(walls), simulation.grains(), contacts, static_cast<std::size_t>(scene.output.slices));
  columns_.push_back(column.row);
  slices_.insert(slices_.end(), column.slices.begin(), column.slices.end());
}

template <int D>
void Series<D>::exchange(Archive& archive, std::size_t walls, std::size_t slices) {
  archive.array("run/series", rows_);
  archive.array("run/walls", walls_);
  archive.check("run/walls", walls_.size() == rows_.size() * walls);
  archive.array("run/columns", columns_);
  archive.array("run/slices", slices_);
  archive.check("run/columns", columns_.size() == (slices > 0 ? rows_.size() : 0));
  archive.check("run/slices", slices_.size() == columns_.size() * slices);
}

template class Series<2>;
template class Series<3>;

}  // namespace repose
