// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record_groups.hpp"

namespace repose {

namespace {

/// A number of each wall in each row of the series.
template <int D, class Entry>
Column<Record<D>> wall_column(const std::string& name, Entry entry, const std::string& unit,
                              const std::string& meaning) {
  const auto columns = [](const Record<D>& record) { return record.wall_series.size() / record.series.size(); };
  Column<Record<D>> made{name, unit, meaning, "W", type_name<double>, {}};
  made.write = [=](Hdf5File& file, const std::string& path, const Record<D>& record) {
    std::vector<double> values;
    for (auto row : record.wall_series) values.push_back(entry(row));
    file.table(path, values, columns(record), unit, meaning);
  };
  made.read = [=](const Hdf5Reader& file, const std::string& path, Record<D>& record) {
    const auto values = file.table<double>(path, record.walls.size());
    record.wall_series.resize(record.series.size() * record.walls.size());
    if (values.size() == record.wall_series.size()) {
      for (std::size_t k = 0; k < values.size(); ++k) entry(record.wall_series[k]) = values[k];
    }
    return values.size() / record.walls.size();
  };
  return made;
}

/// A number of each wall in each row of the series that follows from others and the normal of the wall.
Column<Record<2>> wall_stress_column(const std::string& name, double (*of)(const WallRow<2>&, const Vec<2>& normal),
                                     const std::string& meaning) {
  Column<Record<2>> made{name, "M/T^2", meaning, "W", type_name<double>, {}};
  made.write = [=](Hdf5File& file, const std::string& path, const Record<2>& record) {
    const auto walls = record.wall_series.size() / record.series.size();
    std::vector<double> values;
    for (std::size_t k = 0; k < record.wall_series.size(); ++k) {
      values.push_back(of(record.wall_series[k], record.walls[k % walls].wall.normal));
    }
    file.table(path, values, walls, "M/T^2", meaning);
  };
  return made;
}

/// A number of each slice of a column in each row of the series.
template <int D>
Column<Record<D>> slice_column(const std::string& name, double ColumnSlice::*entry, const std::string& unit,
                               const std::string& meaning) {
  Column<Record<D>> made{name, unit, meaning, "S", type_name<double>, {}};
  made.write = [=](Hdf5File& file, const std::string& path, const Record<D>& record) {
    std::vector<double> values;
    for (const auto& slice : record.column_slices) values.push_back(slice.*entry);
    file.table(path, values, static_cast<std::size_t>(record.scene.output.slices), unit, meaning);
  };
  made.read = [=](const Hdf5Reader& file, const std::string& path, Record<D>& record) {
    const auto slices = static_cast<std::size_t>(record.scene.output.slices);
    const auto values = file.table<double>(path, slices);
    record.column_slices.resize(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) record.column_slices[k].*entry = values[k];
    return values.size() / slices;
  };
  return made;
}

/// What differs between a column of discs and one of spheres.
struct ColumnWords {
  std::string patches;         ///< in which the surface is measured
  std::string solid_fraction;  ///< what is divided by what
  std::string walls, per_area;
  std::string stress_unit;
};

template <int D>
Group<Record<D>> column_group_in(const ColumnWords& words) {
  const Columns<std::vector<ColumnRow>> rows{
      column("height", &ColumnRow::height, "L", "mean height of the surface above the floor, in " + words.patches),
      column("centre", &ColumnRow::centre, "L", "of the centre of mass above the floor"),
      column("solid_fraction", &ColumnRow::solid_fraction, "",
             words.solid_fraction + " of the slices but the lowest and the highest tenth of them"),
  };
  Group<Record<D>> made{"column", "R", {}, columns_of<Record<D>>(rows, &Record<D>::column_series)};
  const auto add = [&](const std::string& name, double ColumnSlice::*entry, const std::string& unit,
                       const std::string& meaning) {
    made.columns.push_back(slice_column<D>(name, entry, unit, meaning));
  };
  add("slice_top", &ColumnSlice::top, "L", "upper level of each above the floor");
  add("slice_mass", &ColumnSlice::mass, "M", "of the grains with centres in it");
  add("slice_pressure", &ColumnSlice::pressure, words.stress_unit,
      "normal force of these grains on " + words.walls + ", per " + words.per_area);
  add("slice_shear", &ColumnSlice::shear, words.stress_unit,
      "upward force of " + words.walls + " on these grains, per " + words.per_area);
  add("slice_load", &ColumnSlice::load, "M L/T^2",
      "upward force through its lower level on the grains with centres above; of the first that of the floor");
  return made;
}

Column<std::vector<SeriesRow>> energy_column(const std::string& name, double Energy::*entry,
                                             const std::string& meaning) {
  return column<SeriesRow>(
      name, [=](auto& row) -> auto& { return row.energy.*entry; }, "M L^2/T^2", meaning);
}

template <class Value>
Column<std::vector<SeriesRow>> solver_column(const std::string& name, Value SolverAccount::*entry,
                                             const std::string& unit, const std::string& meaning) {
  return column<SeriesRow>(
      name, [=](auto& row) -> auto& { return row.solver.*entry; }, unit, meaning + ", since the row before");
}

template <class Value>
Column<std::vector<SeriesRow>> collision_column(const std::string& name, Value CollisionAccount::*entry,
                                                const std::string& unit, const std::string& meaning) {
  return column<SeriesRow>(
      name, [=](auto& row) -> auto& { return row.collisions.*entry; }, unit, meaning + ", since the row before");
}

/// Time again, beside what belongs to it.
Column<std::vector<SeriesRow>> time_column(const std::string& meaning) {
  return column<SeriesRow>(
      "time", [](const SeriesRow& row) { return row.time; }, "T", meaning);
}

}  // namespace

const Group<std::vector<SeriesRow>>& series_group() {
  static const Group<std::vector<SeriesRow>> group{
      "series",
      "R",
      {},
      {
          column("time", &SeriesRow::time, "T", "time"),
          column("grains", &SeriesRow::grains, "", "moving grains present"),
          column("lost", &SeriesRow::lost, "", "grains that have left"),
          column("contacts", &SeriesRow::contacts, "",
                 "contacts that push or pull with more than `analysis.force_threshold`"),
          column("kinetic_energy_per_grain", &SeriesRow::kinetic_energy_per_grain, "M L^2/T^2",
                 "translation and rotation"),
          column(
              "force_residual", &SeriesRow::force_residual, "grain weights",
              "mean magnitude of the net force on a moving grain, over its own weight; without gravity over the mean "
              "normal force"),
          column("max_overlap", &SeriesRow::max_overlap, "", "deepest overlap over the mean diameter of the pair"),
      }};
  return group;
}

namespace {

/// The columns of every dimension: displacement, and the components of the force.
template <int D>
Columns<Record<D>> motions_and_forces() {
  using Row = WallRow<D>;
  Columns<Record<D>> list{wall_column<D>(
      "wall_displacement", [](Row& row) -> double& { return row.displacement; }, "L",
      "of each wall along the direction of its motion; of one that rotates, the angle in radians")};
  constexpr const char* names[] = {"wall_force_x", "wall_force_y", "wall_force_z"};
  for (int axis = 0; axis < D; ++axis) {
    list.push_back(wall_column<D>(
        names[axis], [axis](Row& row) -> double& { return row.force[axis]; }, "M L/T^2",
        "of the grains on each wall, mean since the row before"));
  }
  return list;
}

}  // namespace

template <>
const Columns<Record<2>>& wall_series_columns() {
  using Row = WallRow<2>;
  static const auto list = [] {
    auto all = motions_and_forces<2>();
    all.push_back(
        wall_stress_column("wall_pressure", pressure_of,
                           "that force against the normal, over the length; positive into the wall; NaN without a "
                           "length"));
    all.push_back(wall_stress_column("wall_shear", shear_of,
                                     "that force along the normal turned by +90 degrees, over the length"));
    all.push_back(wall_column<2>(
        "wall_length", [](Row& row) -> double& { return row.length; }, "L",
        "of a finite wall; of a plane the part between other planes, and else as far as moving grains reach"));
    all.push_back(wall_column<2>(
        "wall_moment", [](Row& row) -> double& { return row.moment; }, "M L^2/T^2",
        "of the contacts at that time about the middle of that length, counter-clockwise"));
    return all;
  }();
  return list;
}

template <>
const Columns<Record<3>>& wall_series_columns() {
  static const auto list = motions_and_forces<3>();
  return list;
}

template <>
const Group<Record<2>>& column_group() {
  static const auto group = column_group_in<2>({.patches = "strips of a mean diameter",
                                                .solid_fraction = "disc area over area",
                                                .walls = "the two walls",
                                                .per_area = "length of wall",
                                                .stress_unit = "M/T^2"});
  return group;
}

template <>
const Group<Record<3>>& column_group() {
  static const auto group = column_group_in<3>({.patches = "patches about as wide as a mean sphere",
                                                .solid_fraction = "volume of the spheres over volume",
                                                .walls = "the cylinder",
                                                .per_area = "area of wall",
                                                .stress_unit = "M/(L T^2)"});
  return group;
}

const Group<std::vector<SeriesRow>>& energy_group() {
  static const Group<std::vector<SeriesRow>> group{
      "energy",
      "R",
      {},
      {
          time_column("of the rows; energies are those of half a step before"),
          energy_column("kinetic", &Energy::kinetic, "translation and rotation"),
          energy_column("gravitational", &Energy::gravitational, "0 at height 0"),
          energy_column("elastic", &Energy::elastic, "of all contacts, springs of friction included"),
          energy_column("sources", &Energy::sources, "put in: brought by grains, at the start or later"),
          energy_column("lost", &Energy::lost, "taken along by grains that left"),
          energy_column("walls_work", &Energy::walls_work, "put in: done by moving walls"),
          energy_column("loads_work", &Energy::loads_work, "put in: done by loads"),
          energy_column("damping", &Energy::damping, "dissipated by dashpots between grains"),
          energy_column("friction", &Energy::friction, "dissipated by friction and rolling resistance between grains"),
          energy_column("walls", &Energy::walls, "dissipated at walls"),
          energy_column("drag", &Energy::drag, "dissipated by global damping"),
          column<SeriesRow>(
              "error", [](const SeriesRow& row) { return row.energy.error(); }, "M L^2/T^2",
              "stored, dissipated and lost, less what was put in"),
      }};
  return group;
}

const Group<std::vector<SeriesRow>>& collision_group() {
  static const Group<std::vector<SeriesRow>> group{
      "collisions",
      "R",
      {},
      {
          time_column("of the rows"),
          collision_column("steps", &CollisionAccount::steps, "", "time steps, each part of a divided one counted"),
          collision_column("hard", &CollisionAccount::hard, "", "hard collisions"),
          collision_column("softened", &CollisionAccount::softened, "", "contacts that turned soft"),
          collision_column("hardened", &CollisionAccount::hardened, "", "soft contacts that ended"),
          collision_column("iterations", &CollisionAccount::iterations, "",
                           "steps of Newton's method, or sweeps, in implicit steps"),
          collision_column("halved", &CollisionAccount::halved, "",
                           "implicit steps without a solution, repeated as two halves"),
          collision_column("residual", &CollisionAccount::worst_residual, "grain weights",
                           "worst residual force of a grain"),
      }};
  return group;
}

const Group<std::vector<SeriesRow>>& solver_group() {
  static const Group<std::vector<SeriesRow>> group{
      "solver",
      "R",
      {},
      {
          time_column("of the rows"),
          solver_column("steps", &SolverAccount::steps, "", "time steps"),
          solver_column("sweeps", &SolverAccount::sweeps, "", "forward and backward sweeps"),
          solver_column("contact_iterations", &SolverAccount::contact_iterations, "",
                        "contacts visited by sweeps, each way counted"),
          solver_column("unconverged", &SolverAccount::unconverged, "", "steps that reached method.most_sweeps"),
          solver_column("impacts", &SolverAccount::impacts, "", "impacts of contacts with restitution"),
          solver_column("impacts_reduced", &SolverAccount::reduced, "",
                        "impacts whose restitution gave way, so that the kinetic energy does not rise"),
          solver_column("restitution_lost", &SolverAccount::restitution_lost, "",
                        "sum over impacts of the fraction of restitution that gave way"),
          solver_column("residual", &SolverAccount::worst_residual, "g dt", "worst residual velocity of a contact"),
          column("creep_rate", &SeriesRow::creep_rate, "L/T", "median speed of the grains that touch something"),
      }};
  return group;
}

}  // namespace repose
