// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <limits>

namespace repose {

namespace {

/// Adds a group /packing/NAME made from a part of the packing, to which `part` gives a pointer, or null.
template <class Part, class Get>
void add(Registry& to, const std::string& name, const std::string& rows, Attributes<Part> attributes,
         Columns<Part> columns, Get part) {
  to.groups.push_back(analysis_group<Part>(
      {"packing/" + name, rows, std::move(attributes), std::move(columns)},
      [=](const Measured& run) -> const Part* { return run.results.packing ? part(*run.results.packing) : nullptr; }));
}

/// A pointer to what a std::optional holds.
template <class Part>
const Part* in(const std::optional<Part>& part) {
  return part ? &*part : nullptr;
}

void add_contact_structure(Registry& to) {
  const auto slab = [](const std::string& name, double Slab::*member, const std::string& meaning) {
    return attribute<Measured>(
        name, [=](const Measured& run) { return run.results.packing->slab.*member; }, "L", meaning);
  };
  const auto of_grains = [](const std::string& name, auto entry, const std::string& meaning) {
    return array<Measured>(name, entry, "", meaning);
  };
  const auto by_number = [](const std::string& name, std::array<double, 7> Coordination::*member,
                            const std::string& meaning) {
    return with_rows("7", array<Measured>(
                              name,
                              [=](const Measured& run) {
                                const auto& values = run.results.packing->coordination.*member;
                                return std::vector<double>(values.begin(), values.end());
                              },
                              "", meaning));
  };
  to.groups.push_back(analysis_group(
      {"packing",
       "N",
       {
           slab("slab_low", &Slab::low, "lower edge of the slab"),
           slab("slab_high", &Slab::high, "upper edge of the slab"),
           slab("base_height", &Slab::base_height, "y of the base centres, 0 without base grains"),
           slab("mean_height", &Slab::mean_height, "of the deposited centres above those of the base"),
           attribute<Measured>(
               "gap", [](const Measured& run) { return run.record.scene.analysis.contact_gap; }, "mean diameters",
               "grains closer than this touch: `analysis.contact_gap`"),
       },
       {
           of_grains(
               "id", [](const Measured& run) -> const auto& { return run.record.grains->id; }, "grain"),
           of_grains(
               "neighbours", [](const Measured& run) -> const auto& { return run.results.neighbours; },
               "grains that touch it, base grains included"),
           by_number("connectivity", &Coordination::connectivity,
                     "fraction of grains in the slab with 0 to 5, and 6 or more, contacts"),
           by_number("connectivity_error", &Coordination::connectivity_error, "standard error, by blocks along x"),
       }},
      [](const Measured& run) { return run.results.packing.has_value(); }));
}

void add_directions(Registry& to) {
  const auto fabric = [](const Packing& packing) { return in(packing.fabric); };
  add<Fabric>(to, "directions", "bins", {attribute("bin_width", &Fabric::bin_width, "deg", "")},
              {
                  array("direction_deg", &Fabric::direction_deg, "deg",
                        "theta of a contact from the vertical, positive to the right, in (-90, 90], centre of the bin"),
                  array("count", &Fabric::count, "", "contacts"),
                  array("density", &Fabric::density, "1/deg", "probability density"),
                  array("error", &Fabric::error, "1/deg", "from the square root of the count"),
              },
              fabric);
  const Columns<std::vector<Harmonic>> harmonics{
      column("order", &Harmonic::order, "", "m"),
      column("cosine", &Harmonic::cosine, "", "2 <cos(m theta)>"),
      column("sine", &Harmonic::sine, "", "2 <sin(m theta)>"),
  };
  const auto list = [](const Fabric& found) {
    return std::vector<Harmonic>(found.harmonics.begin(), found.harmonics.end());
  };
  add<Fabric>(to, "harmonics", "3", {}, columns_of<Fabric>(harmonics, list), fabric);
}

/// Attributes of a fitted exponent.
template <class Part>
Attributes<Part> exponent_of() {
  const auto number = [](double Estimate::*member) {
    return [=](const Part& part) {
      return part.exponent ? (*part.exponent).*member : std::numeric_limits<double>::quiet_NaN();
    };
  };
  return {
      attribute<Part>("exponent", number(&Estimate::mean), "", "slope in logarithms; NaN for fewer than three rows"),
      attribute<Part>("exponent_error", number(&Estimate::error), "", "its standard error"),
  };
}

void add_packing_surface(Registry& to) {
  const auto of_surface = [](auto PackingSurface::*member) {
    return [=](const Packing& packing) { return packing.surface ? &((*packing.surface).*member) : nullptr; };
  };
  const auto centres = [](const SurfaceProfile& profile) {
    std::vector<double> x;
    for (std::size_t k = 0; k < profile.height.size(); ++k) x.push_back(profile.x(k));
    return x;
  };
  add<SurfaceProfile>(to, "surface", "columns", {},
                      {
                          array<SurfaceProfile>("x", centres, "L", "centre of the column, a mean diameter wide"),
                          array("height", &SurfaceProfile::height, "L", "highest point of any grain over the column"),
                      },
                      of_surface(&PackingSurface::profile));
  add<RoughnessScaling>(to, "roughness", "windows", exponent_of<RoughnessScaling>(),
                        {
                            array("window", &RoughnessScaling::window, "L", "width of the windows"),
                            array("width", &RoughnessScaling::width, "L", "rms height within them"),
                        },
                        of_surface(&PackingSurface::scaling));
  add<SurfaceGrowth>(to, "growth", "numbers", exponent_of<SurfaceGrowth>(),
                     {
                         array("deposited", &SurfaceGrowth::deposited, "", "grains"),
                         array("mean_height", &SurfaceGrowth::mean_height, "L", "of the surface after so many"),
                         array("width", &SurfaceGrowth::width, "L", "its rms height"),
                     },
                     of_surface(&PackingSurface::growth));
}

void add_correlations(Registry& to) {
  const auto correlation = [&](const std::string& name, Correlation PairCorrelation::*member,
                               const std::string& meaning) {
    add<Correlation>(to, name, "bins", {},
                     {
                         array("distance", &Correlation::distance, "L",
                               "centre of the bin; bins begin 2e-4 diameters below multiples of their width"),
                         array("pairs", &Correlation::pairs, "", "of grains"),
                         array("value", &Correlation::value, "", meaning),
                         array("error", &Correlation::error, "", "from the square root of the pairs"),
                     },
                     [=](const Packing& packing) {
                       return packing.pair_correlation ? &((*packing.pair_correlation).*member) : nullptr;
                     });
  };
  correlation("radial", &PairCorrelation::radial, "pair correlation g(r)");
  correlation("along_x", &PairCorrelation::along_x, "density-density correlation along x");
  correlation("along_y", &PairCorrelation::along_y, "density-density correlation along y");
  using Structure = IsotropicStructureFactor;
  add<Structure>(to, "structure_factor", "shells", {},
                 {
                     array("wave_number", &Structure::wave_number, "1/L", "mean of the shell"),
                     array("value", &Structure::value, "", "mean S(q) of the shell"),
                     array("error", &Structure::error, "", "standard error of that"),
                     array("vectors", &Structure::vectors, "", "wave vectors in the shell"),
                 },
                 [](const Packing& packing) { return in(packing.structure_factor); });
}

void add_local_density(Registry& to) {
  const auto density = [](double Estimate::*member) {
    return [=](const LocalDensity& local) { return local.density.*member; };
  };
  add<LocalDensity>(to, "local_density", "bins",
                    {
                        attribute<LocalDensity>("mean", density(&Estimate::mean), "", "over closed cells"),
                        attribute<LocalDensity>("deviation", density(&Estimate::deviation), "",
                                                "standard deviation over closed cells"),
                        attribute("solid_fraction", &LocalDensity::solid_fraction, "",
                                  "area of their discs over area of their cells"),
                    },
                    {
                        array("centre", &LocalDensity::centre, "", "of the bin"),
                        array("count", &LocalDensity::count, "", "Voronoi cells"),
                        array("probability", &LocalDensity::probability, "", "density of cells"),
                    },
                    [](const Packing& packing) { return in(packing.local_density); });
}

}  // namespace

/// The groups of a packing in analysis.h5.
void add_packing_structure(Registry& to) {
  add_contact_structure(to);
  add_directions(to);
  add_packing_surface(to);
  add_correlations(to);
  add_local_density(to);
}

}  // namespace repose
