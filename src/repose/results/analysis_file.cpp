// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/analysis_file.hpp"

#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/results/packing_datasets.hpp"

#include <limits>
#include <type_traits>

namespace repose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A column of values, one per row: counts become 64-bit integers, flags bytes.
template <class Row, class Value>
auto column(const std::vector<Row>& rows, const Value& value) {
  using Given = std::decay_t<decltype(value(rows.front()))>;
  using Kept = std::conditional_t<std::is_same_v<Given, bool>, std::uint8_t,
                                  std::conditional_t<std::is_integral_v<Given>, std::int64_t, double>>;
  std::vector<Kept> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(static_cast<Kept>(value(row)));
  return values;
}

void write_surface(Hdf5File& file, const Results& results, double bin_width) {
  const auto& heap = results.heap;
  file.group("surface");
  file.attribute("surface", "bin_width", bin_width);
  file.attribute("surface", "base_y", results.base_height);
  file.attribute("surface", "apex_x", heap.apex_x);
  file.attribute("surface", "apex_height", heap.apex_height);
  const auto line = [&](const std::string& side, const std::optional<FlankLine>& flank) {
    file.attribute("surface", side + "_slope", flank ? flank->slope : none);
    file.attribute("surface", side + "_intercept", flank ? flank->intercept : none);
  };
  line("left", heap.left);
  line("right", heap.right);
  const auto& bins = heap.surface;
  file.dataset("surface/x", column(bins, [](const auto& bin) { return bin.x; }), 1, "L", "centre of the bin");
  file.dataset("surface/height", column(bins, [](const auto& bin) { return bin.height; }), 1, "L",
               "highest grain top above the base centres");
  file.dataset("surface/used", column(bins, [](const auto& bin) { return bin.used; }), 1, "",
               "1: used for the line of its flank");
}

void write_base(Hdf5File& file, const BinnedProfile& base) {
  if (base.x.empty()) return;
  file.group("base");
  file.attribute("base", "bin_width", base.bin_width);
  file.dataset("base/x", base.x, 1, "L", "centre of the bin");
  file.dataset("base/count", base.count, 1, "", "base grains in it");
  file.dataset("base/normal", base.normal, 1, "grain weights", "mean over them, positive downward");
  file.dataset("base/normal_error", base.normal_error, 1, "grain weights", "standard error of the mean");
  file.dataset("base/shear", base.shear, 1, "grain weights", "mean over them, positive to the right");
  file.dataset("base/shear_error", base.shear_error, 1, "grain weights", "standard error of the mean");
}

void write_voronoi(Hdf5File& file, const std::vector<VoronoiCell>& cells) {
  if (cells.empty()) return;
  std::vector<std::int64_t> offset{0};
  std::vector<double> vertices;
  for (const auto& cell : cells) {
    for (const auto& vertex : cell.vertices) {
      vertices.push_back(vertex[0]);
      vertices.push_back(vertex[1]);
    }
    offset.push_back(static_cast<std::int64_t>(vertices.size() / 2));
  }
  file.group("voronoi");
  file.dataset("voronoi/id", column(cells, [](const auto& cell) { return cell.id; }), 1, "", "grain");
  file.dataset("voronoi/area", column(cells, [](const auto& cell) { return cell.area; }), 1, "L^2", "of its cell");
  file.dataset("voronoi/solid_fraction", column(cells, [](const auto& cell) { return cell.solid_fraction; }), 1, "",
               "area of the disc over that of its cell");
  file.dataset("voronoi/closed", column(cells, [](const auto& cell) { return cell.closed; }), 1, "",
               "1: ends at neighbours on all sides");
  file.dataset("voronoi/offset", offset, 1, "", "vertices of cell k are rows offset[k] to offset[k + 1]");
  file.dataset("voronoi/vertices", vertices, 2, "L", "counter-clockwise");
}

void write_forces(Hdf5File& file, const ForceStatistics& forces, double weight) {
  file.group("forces");
  file.attribute("forces", "mean", weight > 0.0 ? forces.mean / weight : none);
  file.attribute("forces", "bin_width", forces.bin_width);
  file.dataset("forces/f", forces.f, 1, "", "normal force over its mean, centre of the bin");
  file.dataset("forces/density", forces.density, 1, "", "probability density");
  file.dataset("forces/error", forces.error, 1, "", "of the density, from the square root of the count");
  file.dataset("forces/direction_deg", forces.direction_deg, 1, "deg", "from the horizontal, centre of the bin");
  file.dataset("forces/direction_all", forces.direction_all, 1, "1/deg", "probability density of all contacts");
  file.dataset("forces/direction_strong", forces.direction_strong, 1, "1/deg",
               "probability density of contacts above the mean force");
}

void write_chains(Hdf5File& file, const Chains& chains) {
  std::vector<double> extent;
  for (const auto& chain : chains.list) {
    extent.push_back(chain.width);
    extent.push_back(chain.height);
  }
  file.group("chains");
  file.dataset("chains/contacts", column(chains.list, [](const auto& chain) { return chain.contacts; }), 1, "",
               "contacts of the chain");
  file.dataset("chains/grains", column(chains.list, [](const auto& chain) { return chain.grains; }), 1, "",
               "grains of the chain");
  file.dataset("chains/direction_deg", column(chains.list, [](const auto& chain) { return chain.direction_deg; }), 1,
               "deg", "axis of its contacts, from the horizontal");
  file.dataset("chains/extent", extent, 2, "L", "width and height of the box around the centres of its grains");
  file.dataset("chains/chain", chains.chain_of_contact, 1, "", "of each contact; -1: not above the mean force");
}

void write_fields(Hdf5File& file, const Fields& fields) {
  if (fields.density.empty()) return;
  const auto columns = fields.x.size();
  file.group("fields");
  file.attribute("fields", "width", fields.width);
  file.attribute("fields", "cell", fields.cell);
  file.dataset("fields/x", fields.x, 1, "L", "centres of the cells");
  file.dataset("fields/y", fields.y, 1, "L", "centres of the cells");
  file.dataset("fields/density", fields.density, columns, "M/L^2", "mass of the heap per area");
  file.dataset("fields/solid_fraction", fields.solid_fraction, columns, "", "disc area of the heap per area");
  constexpr const char* names[] = {"xx", "xy", "yx", "yy"};
  for (std::size_t k = 0; k < 4; ++k) {
    file.dataset(std::string("fields/stress_") + names[k], fields.stress[k], columns, "M/T^2",
                 "contact stress, compression positive; first index: force, second: branch");
  }
  file.dataset("fields/support_x", fields.support[0], columns, "M/(L T^2)", "force of the supports per area");
  file.dataset("fields/support_y", fields.support[1], columns, "M/(L T^2)", "force of the supports per area");
}

void write_motion(Hdf5File& file, const std::vector<MotionRow>& rows) {
  file.group("motion");
  const auto add = [&](const char* name, auto value, const char* unit, const char* meaning) {
    file.dataset(std::string("motion/") + name, column(rows, value), 1, unit, meaning);
  };
  add(
      "start", [](const auto& row) { return row.start; }, "T", "of the interval");
  add(
      "end", [](const auto& row) { return row.end; }, "T", "of the interval");
  add(
      "grains", [](const auto& row) { return row.grains; }, "", "in the heap at both ends");
  add(
      "moved", [](const auto& row) { return row.moved; }, "", "of those, gone farther than analysis.moved");
  add(
      "moved_left", [](const auto& row) { return row.moved_left; }, "", "of those, left of the apex");
  add(
      "depth", [](const auto& row) { return row.depth; }, "L", "of the moving layer: 90th percentile");
  add(
      "kinetic_energy", [](const auto& row) { return row.kinetic_energy; }, "M L^2/T^2", "at the end");
  add(
      "angle_left", [](const auto& row) { return row.angle_left_deg; }, "deg", "of the surface at the end");
  add(
      "angle_right", [](const auto& row) { return row.angle_right_deg; }, "deg", "of the surface at the end");
}

template <class Event, class Add>
void write_times(const Add& add) {
  add(
      "start", [](const Event& event) { return event.start; }, "T", "");
  add(
      "end", [](const Event& event) { return event.end; }, "T", "");
  add(
      "duration", [](const Event& event) { return event.duration; }, "T", "");
  add(
      "waiting", [](const Event& event) { return event.waiting; }, "T", "since the end of the one before");
}

void write_events(Hdf5File& file, const Motion& motion, const Scene::Analysis& settings, double burst) {
  file.group("avalanches");
  file.attribute("avalanches", "interval", motion.rows.front().end - motion.rows.front().start);
  file.attribute("avalanches", "least", settings.avalanche);
  const auto add_avalanche = [&](const char* name, auto value, const char* unit, const char* meaning) {
    file.dataset(std::string("avalanches/") + name, column(motion.avalanches, value), 1, unit, meaning);
  };
  write_times<Avalanche>(add_avalanche);
  add_avalanche(
      "size", [](const auto& event) { return event.size; }, "", "distinct grains that moved");
  add_avalanche(
      "depth", [](const auto& event) { return event.depth; }, "L", "of the moving layer: 90th percentile");
  add_avalanche(
      "left", [](const auto& event) { return event.left; }, "", "share of the moves left of the apex");

  file.group("bursts");
  file.attribute("bursts", "threshold", burst);
  const auto add_burst = [&](const char* name, auto value, const char* unit, const char* meaning) {
    file.dataset(std::string("bursts/") + name, column(motion.bursts, value), 1, unit, meaning);
  };
  write_times<Burst>(add_burst);
  add_burst(
      "peak", [](const auto& event) { return event.peak; }, "M L^2/T^2", "largest kinetic energy");
}

}  // namespace

void write_analysis(const std::string& path, const Record& record, const Results& results) {
  const auto& scene = record.scene;
  Hdf5File file(path);
  file.attribute("/", "format", std::string("repose-analysis"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "time", record.facts.time);
  if (results.packing) write_packing(file, record, results);
  if (!scene.method->traits().has_forces()) return file.commit();
  write_surface(file, results, scene.analysis.bin_width);
  write_base(file, results.base);
  write_voronoi(file, results.cells);
  if (results.forces) {
    write_forces(file, *results.forces, scene.grain_weight());
    write_chains(file, results.chains);
  }
  write_fields(file, results.fields);
  if (!results.motion.rows.empty()) {
    write_motion(file, results.motion.rows);
    write_events(file, results.motion, scene.analysis,
                 scene.analysis.burst * scene.grain_weight() * scene.grains.diameter);
  }
  file.commit();
}

}  // namespace repose
