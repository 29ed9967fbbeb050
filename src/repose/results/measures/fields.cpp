// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

/// A field over the grid.
template <class Entry>
Column<Fields> field(const std::string& name, Entry entry, const std::string& unit, const std::string& meaning) {
  return matrix<Fields>(
      name, "columns",
      [=](const Fields& fields) {
        return Matrix{std::invoke(entry, fields), fields.x.size()};
      },
      unit, meaning);
}

Columns<Fields> columns_of_fields() {
  Columns<Fields> columns{
      with_rows("columns", array("x", &Fields::x, "L", "centres of the cells, ascending")),
      array("y", &Fields::y, "L", "centres of the cells, ascending"),
      field("room", &Fields::room, "",
            "fraction of the cell that walls leave to the heap; a density over it is the mean before the wall"),
      field("density", &Fields::density, "M/L^2", "mass of the grains in the heap per area"),
      field("solid_fraction", &Fields::solid_fraction, "", "their disc area per area"),
  };
  constexpr const char* names[] = {"xx", "xy", "yx", "yy"};
  for (std::size_t k = 0; k < 4; ++k) {
    columns.push_back(field(
        std::string("stress_") + names[k], [=](const Fields& fields) -> const auto& { return fields.stress[k]; },
        "M/T^2", "contact stress, compression positive; first index: force, second: branch"));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    columns.push_back(field(
        k == 0 ? "support_x" : "support_y", [=](const Fields& fields) -> const auto& { return fields.support[k]; },
        "M/(L T^2)", "force per area of fixed grains and walls on the heap"));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    columns.push_back(field(
        k == 0 ? "velocity_x" : "velocity_y", [=](const Fields& fields) -> const auto& { return fields.velocity[k]; },
        "L/T", "momentum over mass; NaN far from the heap"));
  }
  columns.push_back(field("temperature", &Fields::temperature, "L^2/T^2",
                          "granular temperature: variance of a velocity component about the local linear flow; NaN "
                          "where fewer than about four grains are near"));
  columns.push_back(field("contacts", &Fields::contacts, "1/L^2", "contacts above the force threshold per area"));
  constexpr const char* fabric[] = {"fabric_xx", "fabric_xy", "fabric_yy"};
  for (std::size_t k = 0; k < 3; ++k) {
    columns.push_back(field(
        fabric[k], [=](const Fields& fields) -> const auto& { return fields.fabric[k]; }, "",
        "mean of n n over these contacts, n the normal: xx + yy = 1; NaN far from them"));
  }
  columns.push_back(field("coordination", &Fields::coordination, "",
                          "mean number of these contacts per grain, those with the base and walls included"));
  return columns;
}

}  // namespace

/// Coarse-grained fields.
void add_fields(Registry& to) {
  to.measures.push_back(measure("field_weight_error", "",
                                "integral of the coarse-grained density over the mass of the heap, less 1",
                                [](const Measured& run) { return run.results.field_weight_error; }));
  to.groups.push_back(analysis_group<Fields>(
      {"fields",
       "rows",
       {
           attribute("width", &Fields::width, "L", "standard deviation of the Gaussian: `analysis.field_width`"),
           attribute("cell", &Fields::cell, "L", "side of the square cells that values are averages over"),
       },
       columns_of_fields()},
      [](const Measured& run) { return run.results.fields.density.empty() ? nullptr : &run.results.fields; }));
}

}  // namespace repose
