// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/dimension.hpp"
#include "repose/results/column_layers.hpp"
#include "repose/results/registry.hpp"

namespace repose {

namespace {

/// What differs between a column of discs and one of spheres.
struct ColumnWords {
  std::string grains;       ///< which they are
  std::string walls;        ///< at the sides
  std::string solid;        ///< over what, in a solid fraction
  std::string equal;        ///< what all slices have the same of
  std::string section;      ///< the cross-section
  std::string width;        ///< what its size is called
  std::string width_means;  ///< and what that is
  std::string stress_unit;
};

template <int D>
const ColumnWords& column_words() {
  static const ColumnWords of_discs{.grains = "the grains between two upright walls",
                                    .walls = "the two walls",
                                    .solid = "disc area over area",
                                    .equal = "that of all slices is the same",
                                    .section = "the width",
                                    .width = "width",
                                    .width_means = "between the walls",
                                    .stress_unit = "M/T^2"};
  static const ColumnWords of_spheres{.grains = "the grains in an upright cylinder",
                                      .walls = "the cylinder",
                                      .solid = "volume of the spheres over volume",
                                      .equal = "the volume of the spheres is the same in all slices",
                                      .section = "the cross-section",
                                      .width = "radius",
                                      .width_means = "of the cylinder",
                                      .stress_unit = "M/(L T^2)"};
  return D == 2 ? of_discs : of_spheres;
}

template <int D>
Columns<std::vector<ColumnLayer>> layers_in() {
  const auto& say = column_words<D>();
  return {
      column("depth", &ColumnLayer::depth, "L", "of the middle below the surface"),
      column("bottom", &ColumnLayer::bottom, "L", "lower level above the floor"),
      column("top", &ColumnLayer::top, "L", "upper level"),
      column("mass", &ColumnLayer::mass, "M", "of the grains with centres in the slice"),
      column("solid_fraction", &ColumnLayer::solid_fraction, "", say.solid + "; " + say.equal),
      column("pressure", &ColumnLayer::pressure, say.stress_unit, "on " + say.walls),
      column("shear", &ColumnLayer::shear, say.stress_unit, "of " + say.walls + ", upwards on the grains"),
      column("stress", &ColumnLayer::stress, say.stress_unit,
             "vertical: mean of the loads of its two levels, over " + say.section),
      column("load", &ColumnLayer::load, "M L/T^2", "upward force through the lower level"),
  };
}

Attributes<ColumnState> place_of(Dimension<2>) {
  return {attribute("width", &ColumnState::width, "L", "`column.width`")};
}
Attributes<ColumnState> place_of(Dimension<3>) {
  return {
      attribute("radius", &ColumnState::radius, "L", "`column.radius`"),
      attribute<ColumnState>(
          "axis_x", [](const ColumnState& state) { return state.axis[0]; }, "L", "of the cylinder at the end"),
      attribute<ColumnState>(
          "axis_y", [](const ColumnState& state) { return state.axis[1]; }, "L", "of the cylinder at the end"),
      attribute("floor", &ColumnState::floor, "L", "z of the floor at the end"),
      attribute("floor_wall", &ColumnState::floor_wall, "", "number of the wall that is the floor; -1: base grains"),
  };
}

template <int D>
void add_column_groups(RegistryIn<D>& to) {
  Group<ColumnState> group{
      "column",
      "S",
      place_of(Dimension<D>{}),
      columns_of<ColumnState>(column_layers<D>(), &ColumnState::layers),
  };
  for (auto& more : Attributes<ColumnState>{
           attribute("height", &ColumnState::height, "L", "`column.height`"),
           attribute("mass", &ColumnState::mass, "M", "`column.mass`"),
           attribute("friction", &ColumnState::friction, "", "`column.friction`"),
           attribute<ColumnState>(
               "stress_ratio",
               [](const ColumnState& state) {
                 return state.stress_ratio ? state.stress_ratio->mean : ColumnState::none;
               },
               "", "`column.stress_ratio.mean`"),
           attribute("screening_length", &ColumnState::screening_length, "L", "`column.screening_length`")}) {
    group.attributes.push_back(std::move(more));
  }
  to.groups.push_back(analysis_group<ColumnState, D>(group, [](const MeasuredIn<D>& run) {
    const auto& found = run.results.column;
    return found && !found->layers.empty() ? &*found : nullptr;
  }));
  using Motions = std::vector<ColumnMotion>;
  const Group<Motions> motion{
      "column_motion",
      "rows",
      {},
      {column("time", &ColumnMotion::time, "T", "of the row of the time series"),
       column("floor", &ColumnMotion::floor, "L", "displacement of the floor, upwards"),
       column("top", &ColumnMotion::top, "L", "displacement of the surface, upwards"),
       column("shortening", &ColumnMotion::shortening, "L", "of the column since the floor set out"),
       column("front", &ColumnMotion::front, "L",
              "height, above the floor as it set out, up to which all slices have moved at least half as far as it")}};
  to.groups.push_back(analysis_group<Motions, D>(motion, [](const MeasuredIn<D>& run) {
    const auto& found = run.results.column;
    return found && !found->motion.empty() ? &found->motion : nullptr;
  }));
}

double width_of(const ColumnState& column, Dimension<2>) { return column.width; }
/// The radius has the place of the width in Janssen's law: both are twice the cross-section over its perimeter.
double width_of(const ColumnState& column, Dimension<3>) { return column.radius; }

/// The column between two upright walls, or in an upright cylinder.
template <int D>
void add_column_in(RegistryIn<D>& to) {
  using Run = MeasuredIn<D>;
  const auto& say = column_words<D>();
  const auto width = [](const Run& run) { return width_of(*run.results.column, Dimension<D>{}); };
  const auto of = [](auto member) { return [=](const Run& run) { return std::invoke(member, *run.results.column); }; };
  const auto fitted = [](double ColumnFit::*member) {
    return [=](const Run& run) { return run.results.column->fit.*member; };
  };
  const auto add = [&](MeasureIn<D> measure) { to.measures.push_back(std::move(measure)); };
  add(only_where<D>([](const Run& run) { return run.results.column.has_value(); },
                    measure<D>("column", "", say.grains + ", mean over output.window; left out without them",
                               [](const Run&) { return Object{}; })));
  add(measure<D>("column." + say.width, "L", say.width_means, width));
  add(measure<D>("column.height", "L", "of the surface above the floor", of(&ColumnState::height)));
  add(measure<D>("column.mass", "M", "of its grains", of(&ColumnState::mass)));
  add(measure<D>("column.solid_fraction", "", "of all slices but the lowest and the highest tenth",
                 of(&ColumnState::solid_fraction)));
  add(measure<D>("column.apparent_mass", "M", "load of the floor over gravity", of(&ColumnState::apparent_mass)));
  add(measure<D>("column.load_ratio", "", "load of the floor over the weight", of(&ColumnState::load_ratio)));
  add(measure<D>("column.wall_load", "M L/T^2", "upward force of " + say.walls + " on the grains",
                 of(&ColumnState::wall_load)));
  add(measure<D>("column.balance", "", "load of floor and walls over the weight, less 1", of(&ColumnState::balance)));
  add(measure<D>("column.stress_ratio", "", "K, wall pressure over vertical stress, of all slices but the outer tenths",
                 of(&ColumnState::stress_ratio)));
  add(measure<D>("column.friction", "", "upward force of the walls over the normal force on them",
                 of(&ColumnState::friction)));
  add(measure<D>("column.k_mu", "", "K times friction: " + say.width + "/(2 screening_length)",
                 [=](const Run& run) { return width(run) / (2.0 * run.results.column->screening_length); }));
  add(measure<D>("column.screening_length", "L", say.width + "/(2 K friction); below 0 where the walls push down",
                 of(&ColumnState::screening_length)));
  add(measure<D>("column.janssen_ratio", "", "`load_ratio` by Janssen's law with that length",
                 of(&ColumnState::janssen_ratio)));
  add(measure<D>("column.janssen_error", "", "load_ratio less janssen_ratio",
                 [](const Run& run) { return run.results.column->load_ratio - run.results.column->janssen_ratio; }));
  add(measure<D>("column.fit", "", "Janssen's law fitted to the loads of all levels",
                 [](const Run&) { return Object{}; }));
  add(measure<D>("column.fit.lambda", "L", "the length, of one", fitted(&ColumnFit::lambda)));
  add(measure<D>("column.fit.lambda_error", "L", "from the scatter of the residuals",
                 fitted(&ColumnFit::lambda_error)));
  add(measure<D>("column.fit.lambda_1", "L", "of two lengths: sets the size of the load",
                 fitted(&ColumnFit::lambda_1)));
  add(measure<D>("column.fit.lambda_1_error", "L", "from the scatter of the residuals",
                 fitted(&ColumnFit::lambda_1_error)));
  add(measure<D>("column.fit.lambda_2", "L", "over which the load changes", fitted(&ColumnFit::lambda_2)));
  add(measure<D>("column.fit.lambda_2_error", "L", "from the scatter of the residuals",
                 fitted(&ColumnFit::lambda_2_error)));
  add(measure<D>("column.fit.ratio", "", "lambda_1/lambda_2",
                 [](const Run& run) { return run.results.column->fit.lambda_1 / run.results.column->fit.lambda_2; }));
  add(measure<D>("column.fit.residual", "M", "root of the mean square of the residuals, of one length",
                 fitted(&ColumnFit::residual)));
  add(measure<D>("column.fit.residual_two", "M", "of two lengths", fitted(&ColumnFit::residual_two)));
  add(measure<D>("column.shortening", "L", "of the column since a moving floor set out", of(&ColumnState::shortening)));
  add(measure<D>("column.later_shortening", "L", "of that, what came after every slice had followed the floor",
                 of(&ColumnState::later_shortening)));
  add(measure<D>("column.top_follows", "L",
                 "displacement of the floor when every slice has moved at least half as far as it",
                 of(&ColumnState::top_follows)));
  add_column_groups(to);
}

}  // namespace

template <>
const Columns<std::vector<ColumnLayer>>& column_layers<2>() {
  static const auto layers = layers_in<2>();
  return layers;
}
template <>
const Columns<std::vector<ColumnLayer>>& column_layers<3>() {
  static const auto layers = layers_in<3>();
  return layers;
}

void add_column(Registry& to) { add_column_in(to); }
void add_column(RegistryIn<3>& to) { add_column_in(to); }

}  // namespace repose
