// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

using Run = MeasuredIn<3>;

template <class Entry>
Column<AxialFields> axial_field(const std::string& name, Entry entry, const std::string& unit,
                                const std::string& meaning) {
  return matrix<AxialFields>(
      name, "rings",
      [=](const AxialFields& fields) {
        return Matrix{std::invoke(entry, fields), fields.r.size()};
      },
      unit, meaning);
}

}  // namespace

/// Fields about the axis.
void add_sphere_fields(RegistryIn<3>& to) {
  to.measures.push_back(measure<3>("field_mass_error", "",
                                   "integral of the density field over the mass of the heap, less 1",
                                   [](const Run& run) { return run.results.field_mass_error; }));
  Columns<AxialFields> columns{
      with_rows("rings", array("r", &AxialFields::r, "L", "middles of the rings")),
      array("z", &AxialFields::z, "L", "middles of the layers"),
      axial_field("volume", &AxialFields::volume, "L^3", "of each ring"),
      axial_field("density", &AxialFields::density, "M/L^3", "mass of the centres in the ring over its volume"),
      axial_field("solid_fraction", &AxialFields::solid_fraction, "", "volume of the spheres, cut at the ring"),
  };
  constexpr const char* names[] = {"rr", "tt", "zz", "rz", "zr"};
  for (std::size_t k = 0; k < 5; ++k) {
    columns.push_back(axial_field(
        std::string("stress_") + names[k], [=](const AxialFields& fields) -> const auto& { return fields.stress[k]; },
        "M/(L T^2)", "contact stress, compression positive; first index: force, second: normal of the plane"));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    columns.push_back(axial_field(
        k == 0 ? "support_r" : "support_z", [=](const AxialFields& fields) -> const auto& { return fields.support[k]; },
        "M/(L^2 T^2)", "force per volume of fixed grains and walls on the heap"));
  }
  const Group<AxialFields> group{
      "axial_fields",
      "layers",
      {attribute("ring", &AxialFields::ring, "L", "width of the rings: `analysis.field_width`, or more"),
       attribute("layer", &AxialFields::layer, "L", "height of the layers")},
      columns};
  to.groups.push_back(analysis_group<AxialFields, 3>(
      group, [](const Run& run) { return run.results.fields.density.empty() ? nullptr : &run.results.fields; }));
}

}  // namespace repose
