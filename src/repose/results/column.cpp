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
  WindowMean(const std::vector<SeriesRow>& rows, double start) {
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

/// `area` [L^(D-1)]: of the cross-section.
template <int D>
std::vector<ColumnLayer> mean_layers(const Record<D>& record, const WindowMean& mean, const ColumnState& column,
                                     double area) {
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
  // All slices hold the same area of discs, or volume of spheres: that of the inner ones follows from their solid
  // fraction.
  const auto within = inner(layers);
  const double solid = within.empty() ? ColumnState::none
                                      : column.solid_fraction * area * (within.back().top - within.front().bottom) /
                                            static_cast<double>(within.size());
  for (std::size_t k = 0; k < slices; ++k) {
    auto& layer = layers[k];
    const double above = k + 1 < slices ? layers[k + 1].load : 0.0;
    layer.stress = 0.5 * (layer.load + above) / area;
    layer.solid_fraction = solid / (area * (layer.top - layer.bottom));
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

/// The forces of the walls at the sides.
struct SideForces {
  double load = 0.0;     ///< [M L/T^2] upwards on the grains, mean over all steps
  double upwards = 0.0;  ///< [M L/T^2] the same by what `normal` is measured by
  double normal = 0.0;   ///< [M L/T^2] on them; of two walls on one
};

SideForces side_forces(const Record<2>& record, const PipeWalls& pipe, const WindowMean&) {
  const auto forces = mean_wall_forces(record);
  const auto& left = forces.walls[pipe.left].force;
  const auto& right = forces.walls[pipe.right].force;
  const double load = -(left[1] + right[1]);
  return {load, load, right[0] - left[0]};
}

/// The normal forces on a cylinder cancel in its sum, so they are those of the slices, at the rows of the series.
SideForces side_forces(const Record<3>& record, const WallsOfPipe<3>& pipe, const WindowMean& mean) {
  const auto walls = record.walls.size();
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  const double perimeter = pipe.at(record.walls).perimeter();
  const auto sum = [&](double ColumnSlice::*member) {
    return mean([&](std::size_t row) {
      const auto* slice = &record.column_slices[row * slices];
      double force = 0.0;
      double bottom = 0.0;
      for (std::size_t k = 0; k < slices; ++k) {
        force += slice[k].*member * perimeter * (slice[k].top - bottom);
        bottom = slice[k].top;
      }
      return force;
    });
  };
  SideForces forces;
  forces.load = -mean([&](std::size_t row) { return record.wall_series[row * walls + pipe.side].force[2]; });
  forces.upwards = sum(&ColumnSlice::shear);
  forces.normal = sum(&ColumnSlice::pressure);
  return forces;
}

/// The downward force on what lies below the column: level walls below its centre, else base grains.
template <int D>
double floor_load(const Record<D>& record, const WallsOfPipe<D>& pipe, const WindowMean& mean) {
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  if (!pipe.floor) {
    return mean([&](std::size_t row) { return record.column_slices[row * slices].load; });
  }
  const auto walls = record.walls.size();
  const double floor = record.walls[*pipe.floor].wall.point[up<D>];
  const double middle = floor + record.column_series.back().centre;
  double load = 0.0;
  for (std::size_t w = 0; w < walls; ++w) {
    if (pipe.is_side(w) || !(record.walls[w].wall.point[up<D>] < middle)) continue;
    load -= mean([&](std::size_t row) { return record.wall_series[row * walls + w].force[up<D>]; });
  }
  return load;
}

/// Sets what a moving floor does to the column.
template <int D>
void follow_floor(const Record<D>& record, const WallsOfPipe<D>& pipe, const WindowMean& mean, ColumnState& column) {
  if (!pipe.floor) return;
  const auto& motion = record.walls[*pipe.floor].wall.motion;
  if (motion.kind == WallMotion<D>::Kind::none || std::fabs(motion.direction[up<D>]) < 0.5) return;
  const auto& rows = record.series;
  const auto walls = record.walls.size();
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  std::size_t start = 0;
  while (start + 1 < rows.size() && rows[start + 1].time <= motion.start) ++start;
  const auto floor = [&](std::size_t row) {
    return record.wall_series[row * walls + *pipe.floor].displacement * motion.direction[up<D>];
  };
  const auto slice = [&](std::size_t row, std::size_t k) { return record.column_slices[row * slices + k].top; };
  const auto middle = [&](std::size_t row, std::size_t k) {
    return 0.5 * (slice(row, k) + (k > 0 ? slice(row, k - 1) : 0.0)) + floor(row);
  };
  // A spring first gives way under the weight: what counts begins where the floor turns.
  const double sense = motion.speed * motion.direction[up<D>] < 0.0 ? -1.0 : 1.0;
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

void set_place(const Pipe& pipe, ColumnState& column) { column.width = pipe.width(); }
void set_place(const CylinderPipe& pipe, ColumnState& column) {
  column.radius = pipe.radius;
  column.axis = pipe.axis;
}

bool always_empty(const std::vector<ColumnRow>& rows) {
  return std::none_of(rows.begin(), rows.end(), [](const auto& row) { return row.height > 0.0; });
}

}  // namespace

template <int D>
std::optional<ColumnState> measure_column_of(const Record<D>& record) {
  const auto pipe = find_pipe<D>(record.scene);
  const auto rows = record.series.size();
  const auto slices = static_cast<std::size_t>(record.scene.output.slices);
  if (!pipe || rows == 0 || record.column_series.size() != rows) return std::nullopt;
  if (record.column_slices.size() != rows * slices) return std::nullopt;
  if (record.wall_series.size() != rows * record.walls.size()) return std::nullopt;
  if (D == 3 && always_empty(record.column_series)) return std::nullopt;
  const double start = rows_of_window(record.series, record.scene.output.window).start;
  const WindowMean mean(record.series, start * (1.0 + 1e-12));
  const auto place = pipe->at(record.walls);
  ColumnState column;
  set_place(place, column);
  column.floor = place.floor;
  if (pipe->floor) column.floor_wall = static_cast<std::int64_t>(*pipe->floor);
  column.height = mean([&](std::size_t row) { return record.column_series[row].height; });
  column.solid_fraction = mean([&](std::size_t row) { return record.column_series[row].solid_fraction; });
  if (!(column.height > 0.0)) return column;
  const double area = place.cross_section();
  column.layers = mean_layers(record, mean, column, area);
  column.mass = 0.0;
  for (const auto& layer : column.layers) column.mass += layer.mass;
  const auto sides = side_forces(record, *pipe, mean);
  column.wall_load = sides.load;
  if (sides.normal > 0.0) column.friction = sides.upwards / sides.normal;
  const double load = floor_load(record, *pipe, mean);
  const double gravity = record.scene.gravity;
  column.stress_ratio = stress_ratio_of(column.layers);
  if (column.stress_ratio) {
    column.screening_length = area / (place.perimeter() * column.stress_ratio->mean * column.friction);
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

template std::optional<ColumnState> measure_column_of(const Record<2>&);
template std::optional<ColumnState> measure_column_of(const Record<3>&);

}  // namespace repose
