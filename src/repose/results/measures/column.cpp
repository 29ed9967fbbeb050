// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/column_layers.hpp"
#include "repose/results/registry.hpp"

namespace repose {

const Columns<std::vector<ColumnLayer>>& column_layers() {
  static const Columns<std::vector<ColumnLayer>> layers{
      column("depth", &ColumnLayer::depth, "L", "of the middle below the surface"),
      column("bottom", &ColumnLayer::bottom, "L", "lower level above the floor"),
      column("top", &ColumnLayer::top, "L", "upper level"),
      column("mass", &ColumnLayer::mass, "M", "of the grains with centres in the slice"),
      column("solid_fraction", &ColumnLayer::solid_fraction, "", "disc area over area; that of all slices is the same"),
      column("pressure", &ColumnLayer::pressure, "M/T^2", "on the two walls"),
      column("shear", &ColumnLayer::shear, "M/T^2", "of the two walls, upwards on the grains"),
      column("stress", &ColumnLayer::stress, "M/T^2", "vertical: mean of the loads of its two levels, over the width"),
      column("load", &ColumnLayer::load, "M L/T^2", "upward force through the lower level"),
  };
  return layers;
}

namespace {

void add_column_groups(Registry& to) {
  const Group<ColumnState> column_of_run{
      "column",
      "S",
      {attribute("width", &ColumnState::width, "L", "`column.width`"),
       attribute("height", &ColumnState::height, "L", "`column.height`"),
       attribute("mass", &ColumnState::mass, "M", "`column.mass`"),
       attribute("friction", &ColumnState::friction, "", "`column.friction`"),
       attribute<ColumnState>(
           "stress_ratio",
           [](const ColumnState& state) { return state.stress_ratio ? state.stress_ratio->mean : ColumnState::none; },
           "", "`column.stress_ratio.mean`"),
       attribute("screening_length", &ColumnState::screening_length, "L", "`column.screening_length`")},
      columns_of<ColumnState>(column_layers(), &ColumnState::layers)};
  to.groups.push_back(analysis_group(column_of_run, [](const Measured& run) {
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
  to.groups.push_back(analysis_group(motion, [](const Measured& run) {
    const auto& found = run.results.column;
    return found && !found->motion.empty() ? &found->motion : nullptr;
  }));
}

}  // namespace

/// The column between two upright walls.
void add_column(Registry& to) {
  const auto found = [](const Measured& run) { return run.results.column.has_value(); };
  const auto of = [](auto member) {
    return [=](const Measured& run) { return std::invoke(member, *run.results.column); };
  };
  const auto fitted = [](double ColumnFit::*member) {
    return [=](const Measured& run) { return run.results.column->fit.*member; };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(only_where(found, measure("column", "",
                                "the grains between two upright walls, mean over output.window; left out without them",
                                [](const Measured&) { return Object{}; })));
  add(measure("column.width", "L", "between the walls", of(&ColumnState::width)));
  add(measure("column.height", "L", "of the surface above the floor", of(&ColumnState::height)));
  add(measure("column.mass", "M", "of its grains", of(&ColumnState::mass)));
  add(measure("column.solid_fraction", "", "of all slices but the lowest and the highest tenth",
              of(&ColumnState::solid_fraction)));
  add(measure("column.apparent_mass", "M", "load of the floor over gravity", of(&ColumnState::apparent_mass)));
  add(measure("column.load_ratio", "", "load of the floor over the weight", of(&ColumnState::load_ratio)));
  add(measure("column.wall_load", "M L/T^2", "upward force of the two walls on the grains",
              of(&ColumnState::wall_load)));
  add(measure("column.balance", "", "load of floor and walls over the weight, less 1", of(&ColumnState::balance)));
  add(measure("column.stress_ratio", "", "K, wall pressure over vertical stress, of all slices but the outer tenths",
              of(&ColumnState::stress_ratio)));
  add(measure("column.friction", "", "upward force of the walls over the normal force on them",
              of(&ColumnState::friction)));
  add(measure("column.k_mu", "", "K times friction: width/(2 screening_length)", [](const Measured& run) {
    return run.results.column->width / (2.0 * run.results.column->screening_length);
  }));
  add(measure("column.screening_length", "L", "width/(2 K friction); below 0 where the walls push down",
              of(&ColumnState::screening_length)));
  add(measure("column.janssen_ratio", "", "`load_ratio` by Janssen's law with that length",
              of(&ColumnState::janssen_ratio)));
  add(measure("column.janssen_error", "", "load_ratio less janssen_ratio",
              [](const Measured& run) { return run.results.column->load_ratio - run.results.column->janssen_ratio; }));
  add(measure("column.fit", "", "Janssen's law fitted to the loads of all levels",
              [](const Measured&) { return Object{}; }));
  add(measure("column.fit.lambda", "L", "the length, of one", fitted(&ColumnFit::lambda)));
  add(measure("column.fit.lambda_error", "L", "from the scatter of the residuals", fitted(&ColumnFit::lambda_error)));
  add(measure("column.fit.lambda_1", "L", "of two lengths: sets the size of the load", fitted(&ColumnFit::lambda_1)));
  add(measure("column.fit.lambda_1_error", "L", "from the scatter of the residuals",
              fitted(&ColumnFit::lambda_1_error)));
  add(measure("column.fit.lambda_2", "L", "over which the load changes", fitted(&ColumnFit::lambda_2)));
  add(measure("column.fit.lambda_2_error", "L", "from the scatter of the residuals",
              fitted(&ColumnFit::lambda_2_error)));
  add(measure("column.fit.ratio", "", "lambda_1/lambda_2",
              [](const Measured& run) { return run.results.column->fit.lambda_1 / run.results.column->fit.lambda_2; }));
  add(measure("column.fit.residual", "M", "root of the mean square of the residuals, of one length",
              fitted(&ColumnFit::residual)));
  add(measure("column.fit.residual_two", "M", "of two lengths", fitted(&ColumnFit::residual_two)));
  add(measure("column.shortening", "L", "of the column since a moving floor set out", of(&ColumnState::shortening)));
  add(measure("column.later_shortening", "L", "of that, what came after every slice had followed the floor",
              of(&ColumnState::later_shortening)));
  add(measure("column.top_follows", "L",
              "displacement of the floor when every slice has moved at least half as far as it",
              of(&ColumnState::top_follows)));
  add_column_groups(to);
}

}  // namespace repose
