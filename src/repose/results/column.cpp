// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/column.hpp"

#include "repose/core/errors.hpp"
#include "repose/record/find_pipe.hpp"
#include "repose/results/wall_forces.hpp"
#include "repose/theory/column_walls.hpp"
#include "repose/theory/screening_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace repose {

namespace {

constexpr double least_moved = 0.01;  // diameters: below it, a floor has not moved yet

/// The layers whose stresses tell K: the floor changes the lowest tenth, the surface the highest.
std::vector<ColumnLayer> inner(const std::vector<ColumnLayer>& layers) {
  const auto tenth = std::max<std::size_t>(1, (layers.size() + 5) / 10);
  if (layers.size() <= 2 * tenth) return {};
  const auto edge = static_cast<std::ptrdiff_t>(tenth);
  return {layers.begin() + edge, layers.end() - edge};
}

/// Means over the rows from `first` on, each weighted by its time.
class WindowMean {
 public:
  WindowMean(const Record<2>& record, double start) {
    const auto& rows = record.series;
    for (std::size_t row = rows.size(); row-- > 0;) {
      const double before = row > 0 ? rows[row - 1].time : 0.0;
      rows_.push_back(row);
      lengths_.push_back(rows[row].time - before);
      if (before <= start) break;
    }
  }

  template <class Value>
  double operator()(const Value& value) const {
    double sum = 0.0;
    double time = 0.0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      sum += lengths_[k] * value(rows_[k]);
      time += lengths_[k];
    }
    return sum / time;
  }

 private:
  std::vector<std::size_t> rows_;
  std::vector<double> lengths_;
};

std::vector<ColumnLayer> mean_layers(const Record<2>& record, const WindowMean& mean, const ColumnState& column) {
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  const auto of = [&](std::size_t slice, double ColumnSlice::*member) {
    return mean([&](std::size_t row) { return record.column_slices[row * slices + slice].*member; });
  };
  std::vector<ColumnLayer> layers;
  for (std::size_t k = 0; k < slices; ++k) {
    ColumnLayer layer;
    layer.bottom = k > 0 ? layers[k - 1].top : 0.0;
    layer.top = of(k, &ColumnSlice::top);
    layer.depth = column.height - 0.5 * (layer.bottom + layer.top);
    layer.mass = of(k, &ColumnSlice::mass);
    layer.pressure = of(k, &ColumnSlice::pressure);
    layer.shear = of(k, &ColumnSlice::shear);
    layer.load = of(k, &ColumnSlice::load);
    layers.push_back(layer);
  }
  // All slices have the same disc area: that of the inner ones follows from their solid fraction.
  const auto within = inner(layers);
  const double disc_area = within.empty()
                               ? ColumnState::none
                               : column.solid_fraction * column.width * (within.back().top - within.front().bottom) /
                                     static_cast<double>(within.size());
  for (std::size_t k = 0; k < slices; ++k) {
    auto& layer = layers[k];
    const double above = k + 1 < slices ? layers[k + 1].load : 0.0;
    layer.stress = 0.5 * (layer.load + above) / column.width;
    layer.solid_fraction = disc_area / (column.width * (layer.top - layer.bottom));
  }
  return layers;
}

/// K from p = K s through the origin, over the inner layers; its error from the scatter about that line.
std::optional<Estimate> stress_ratio_of(const std::vector<ColumnLayer>& layers) {
  const auto within = inner(layers);
  double products = 0.0;
  double squares = 0.0;
  for (const auto& layer : within) {
    products += layer.pressure * layer.stress;
    squares += layer.stress * layer.stress;
  }
  if (within.size() < 2 || !(squares > 0.0)) return std::nullopt;
  Estimate ratio;
  ratio.mean = products / squares;
  ratio.count = within.size();
  double residuals = 0.0;
  for (const auto& layer : within) residuals += std::pow(layer.pressure - ratio.mean * layer.stress, 2);
  ratio.error = std::sqrt(residuals / static_cast<double>(within.size() - 1) / squares);
  return ratio;
}

ColumnFit fit_of(const ColumnState& column, double gravity) {
  ColumnFit fit;
  theory::ApparentMasses data;
  for (const auto& layer : column.layers) {
    const double depth = column.height - layer.bottom;
    if (depth <= 0.0) continue;
    data.height.push_back(depth);
    data.mass.push_back(layer.load / gravity);
  }
  const theory::ScreeningLaw law{.mass_per_height = column.mass / column.height,
                                 .sense = column.friction < 0.0 ? -1.0 : 1.0};
  auto one = law;
  one.parameters = 1;
  try {
    const auto found = theory::fit_screening(one, data);
    fit.lambda = found.lambda_1;
    fit.lambda_error = found.lambda_1_error;
    fit.residual = found.rms_residual;
    const auto two = theory::fit_screening(law, data);
    fit.lambda_1 = two.lambda_1;
    fit.lambda_1_error = two.lambda_1_error;
    fit.lambda_2 = two.lambda_2;
    fit.lambda_2_error = two.lambda_2_error;
    fit.residual_two = two.rms_residual;
  } catch (const InputError&) {
    // These loads determine no length: the walls carry nothing, or the loads bend the other way.
  }
  return fit;
}

/// The downward force on what lies below the column: level walls below its centre, else base grains.
double floor_load(const Record<2>& record, const PipeWalls& pipe, const WindowMean& mean) {
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  if (!pipe.floor) {
    return mean([&](std::size_t row) { return record.column_slices[row * slices].load; });
  }
  const auto walls = record.walls.size();
  const double floor = record.walls[*pipe.floor].wall.point[1];
  const double middle = floor + record.column_series.back().centre;
  double load = 0.0;
  for (std::size_t w = 0; w < walls; ++w) {
    if (w == pipe.left || w == pipe.right || !(record.walls[w].wall.point[1] < middle)) continue;
    load -= mean([&](std::size_t row) { return record.wall_series[row * walls + w].force[1]; });
  }
  return load;
}

/// Sets what a moving floor does to the column.
void follow_floor(const Record<2>& record, const PipeWalls& pipe, const WindowMean& mean, ColumnState& column) {
  if (!pipe.floor) return;
  const auto& motion = record.walls[*pipe.floor].wall.motion;
  if (motion.kind == WallMotion<2>::Kind::none || std::fabs(motion.direction[1]) < 0.5) return;
  const auto& rows = record.series;
  const auto walls = record.walls.size();
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  std::size_t start = 0;
  while (start + 1 < rows.size() && rows[start + 1].time <= motion.start) ++start;
  const auto floor = [&](std::size_t row) {
    return record.wall_series[row * walls + *pipe.floor].displacement * motion.direction[1];
  };
  const auto slice = [&](std::size_t row, std::size_t k) { return record.column_slices[row * slices + k].top; };
  const auto middle = [&](std::size_t row, std::size_t k) {
    return 0.5 * (slice(row, k) + (k > 0 ? slice(row, k - 1) : 0.0)) + floor(row);
  };
  // A spring first gives way under the weight: what counts begins where the floor turns.
  const double sense = motion.speed * motion.direction[1] < 0.0 ? -1.0 : 1.0;
  for (std::size_t row = start + 1; row < rows.size(); ++row) {
    if (sense * floor(row) < sense * floor(start)) start = row;
  }
  const double height = record.column_series[start].height;
  double shortened = ColumnState::none;  // when all slices follow
  for (std::size_t row = start + 1; row < rows.size(); ++row) {
    ColumnMotion at;
    at.time = rows[row].time;
    at.floor = floor(row) - floor(start);
    at.shortening = height - record.column_series[row].height;
    at.top = at.floor - at.shortening;
    std::size_t moved = 0;
    const bool moves = std::fabs(at.floor) > least_moved * record.scene.usual_diameter();
    while (moves && moved < slices &&
           std::fabs(middle(row, moved) - middle(start, moved)) >= 0.5 * std::fabs(at.floor)) {
      ++moved;
    }
    at.front = moved > 0 ? slice(start, moved - 1) : 0.0;
    if (moved == slices && std::isnan(column.top_follows)) {
      column.top_follows = at.floor;
      shortened = at.shortening;
    }
    column.motion.push_back(at);
  }
  column.shortening = height - mean([&](std::size_t row) { return record.column_series[row].height; });
  column.later_shortening = column.shortening - shortened;
}

}  // namespace

std::optional<ColumnState> measure_column_of(const Record<2>& record) {
  const auto pipe = find_pipe(record.scene);
  const auto rows = record.series.size();
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  if (!pipe || rows == 0 || record.column_series.size() != rows) return std::nullopt;
  if (record.column_slices.size() != rows * slices) return std::nullopt;
  if (record.wall_series.size() != rows * record.walls.size()) return std::nullopt;
  const auto wall_forces = mean_wall_forces(record);
  const WindowMean mean(record, wall_forces.window_start * (1.0 + 1e-12));
  ColumnState column;
  column.width = pipe->at(record.walls).width();
  column.height = mean([&](std::size_t row) { return record.column_series[row].height; });
  column.solid_fraction = mean([&](std::size_t row) { return record.column_series[row].solid_fraction; });
  if (!(column.height > 0.0)) return column;
  column.layers = mean_layers(record, mean, column);
  column.mass = 0.0;
  for (const auto& layer : column.layers) column.mass += layer.mass;
  const auto& left = wall_forces.walls[pipe->left];
  const auto& right = wall_forces.walls[pipe->right];
  column.wall_load = -(left.force[1] + right.force[1]);
  const double normal = right.force[0] - left.force[0];
  if (normal > 0.0) column.friction = column.wall_load / normal;
  const double load = floor_load(record, *pipe, mean);
  const double gravity = record.scene.gravity;
  column.stress_ratio = stress_ratio_of(column.layers);
  if (column.stress_ratio) {
    column.screening_length = column.width / (2.0 * column.stress_ratio->mean * column.friction);
  }
  if (gravity > 0.0) {
    const double weight = column.mass * gravity;
    column.apparent_mass = load / gravity;
    column.load_ratio = load / weight;
    column.balance = (load + column.wall_load) / weight - 1.0;
    column.janssen_ratio = theory::fraction_at_bottom(column.height / column.screening_length);
    column.fit = fit_of(column, gravity);
  }
  follow_floor(record, *pipe, mean, column);
  return column;
}

}  // namespace repose
