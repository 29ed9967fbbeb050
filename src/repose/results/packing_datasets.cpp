// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/packing_datasets.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace repose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<std::int64_t> counts(const std::vector<std::size_t>& values) { return {values.begin(), values.end()}; }

void write_exponent(Hdf5File& file, const std::string& group, const std::optional<Estimate>& exponent) {
  file.attribute(group, "exponent", exponent ? exponent->mean : none);
  file.attribute(group, "exponent_error", exponent ? exponent->error : none);
}

void write_contacts_of(Hdf5File& file, const Record& record, const Results& results) {
  const auto& coordination = results.packing->coordination;
  file.dataset("packing/id", record.grains->id, 1, "", "grain");
  file.dataset("packing/neighbours", results.neighbours, 1, "", "grains that touch it, base grains included");
  const std::vector<double> share(coordination.connectivity.begin(), coordination.connectivity.end());
  const std::vector<double> error(coordination.connectivity_error.begin(), coordination.connectivity_error.end());
  file.dataset("packing/connectivity", share, 1, "",
               "share of grains in the slab with 0 to 5, and 6 or more, contacts");
  file.dataset("packing/connectivity_error", error, 1, "", "standard error, by blocks along x");
}

void write_directions(Hdf5File& file, const Fabric& fabric) {
  file.group("packing/directions");
  file.attribute("packing/directions", "bin_width", fabric.bin_width);
  file.dataset("packing/directions/direction_deg", fabric.direction_deg, 1, "deg",
               "of a contact from the vertical, positive to the right, centre of the bin");
  file.dataset("packing/directions/count", counts(fabric.count), 1, "", "contacts");
  file.dataset("packing/directions/density", fabric.density, 1, "1/deg", "probability density");
  file.dataset("packing/directions/error", fabric.error, 1, "1/deg", "from the square root of the count");
  std::vector<std::int64_t> order;
  std::vector<double> cosine;
  std::vector<double> sine;
  for (const auto& harmonic : fabric.harmonics) {
    order.push_back(harmonic.order);
    cosine.push_back(harmonic.cosine);
    sine.push_back(harmonic.sine);
  }
  file.group("packing/harmonics");
  file.dataset("packing/harmonics/order", order, 1, "", "m");
  file.dataset("packing/harmonics/cosine", cosine, 1, "", "2 <cos(m theta)>");
  file.dataset("packing/harmonics/sine", sine, 1, "", "2 <sin(m theta)>");
}

void write_surface_of(Hdf5File& file, const PackingSurface& surface) {
  std::vector<double> x;
  for (std::size_t k = 0; k < surface.profile.height.size(); ++k) x.push_back(surface.profile.x(k));
  file.group("packing/surface");
  file.dataset("packing/surface/x", x, 1, "L", "centre of the column");
  file.dataset("packing/surface/height", surface.profile.height, 1, "L", "highest point of any grain over the column");
  file.group("packing/roughness");
  write_exponent(file, "packing/roughness", surface.scaling.exponent);
  file.dataset("packing/roughness/window", surface.scaling.window, 1, "L", "width of the windows");
  file.dataset("packing/roughness/width", surface.scaling.width, 1, "L", "rms height within them");
  file.group("packing/growth");
  write_exponent(file, "packing/growth", surface.growth.exponent);
  file.dataset("packing/growth/deposited", counts(surface.growth.deposited), 1, "", "grains");
  file.dataset("packing/growth/mean_height", surface.growth.mean_height, 1, "L", "of the profile after so many");
  file.dataset("packing/growth/width", surface.growth.width, 1, "L", "its rms height");
}

void write_correlation(Hdf5File& file, const std::string& name, const Correlation& correlation, const char* meaning) {
  const std::string group = "packing/" + name;
  file.group(group);
  file.dataset(group + "/distance", correlation.distance, 1, "L", "centre of the bin");
  file.dataset(group + "/pairs", counts(correlation.pairs), 1, "", "of grains");
  file.dataset(group + "/value", correlation.value, 1, "", meaning);
  file.dataset(group + "/error", correlation.error, 1, "", "from the square root of the pairs");
}

void write_structure(Hdf5File& file, const IsotropicStructureFactor& structure) {
  file.group("packing/structure_factor");
  file.dataset("packing/structure_factor/wave_number", structure.wave_number, 1, "1/L", "mean of the shell");
  file.dataset("packing/structure_factor/value", structure.value, 1, "", "mean S(q) of the shell");
  file.dataset("packing/structure_factor/error", structure.error, 1, "", "standard error of that");
  file.dataset("packing/structure_factor/vectors", counts(structure.vectors), 1, "", "wave vectors in the shell");
}

void write_density(Hdf5File& file, const LocalDensity& density) {
  file.group("packing/local_density");
  file.attribute("packing/local_density", "mean", density.density.mean);
  file.attribute("packing/local_density", "deviation", density.density.deviation);
  file.attribute("packing/local_density", "solid_fraction", density.solid_fraction);
  file.dataset("packing/local_density/centre", density.centre, 1, "", "of the bin");
  file.dataset("packing/local_density/count", counts(density.count), 1, "", "Voronoi cells");
  file.dataset("packing/local_density/probability", density.probability, 1, "", "density of cells");
}

}  // namespace

void write_packing(Hdf5File& file, const Record& record, const Results& results) {
  const auto& packing = *results.packing;
  file.group("packing");
  file.attribute("packing", "slab_low", packing.slab.low);
  file.attribute("packing", "slab_high", packing.slab.high);
  file.attribute("packing", "base_height", packing.slab.base_height);
  file.attribute("packing", "mean_height", packing.slab.mean_height);
  file.attribute("packing", "gap", record.scene.analysis.contact_gap);
  write_contacts_of(file, record, results);
  if (packing.fabric) write_directions(file, *packing.fabric);
  if (packing.surface) write_surface_of(file, *packing.surface);
  if (packing.pair_correlation) {
    write_correlation(file, "radial", packing.pair_correlation->radial, "pair correlation g(r)");
    write_correlation(file, "along_x", packing.pair_correlation->along_x, "density-density correlation along x");
    write_correlation(file, "along_y", packing.pair_correlation->along_y, "density-density correlation along y");
  }
  if (packing.structure_factor) write_structure(file, *packing.structure_factor);
  if (packing.local_density) write_density(file, *packing.local_density);
}

}  // namespace repose
