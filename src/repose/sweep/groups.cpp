// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/groups.hpp"

namespace repose {

const Group<std::vector<PointRow>>& point_group() {
  static const Group<std::vector<PointRow>> group{"points",
                                                  "P",
                                                  {},
                                                  {
                                                      column("name", &PointRow::name, "", "name of each point"),
                                                      column("members", &PointRow::finished, "", "finished members"),
                                                      column("failed", &PointRow::failed, "", "failed members"),
                                                  }};
  return group;
}

const Group<std::vector<MemberRow>>& member_group() {
  static const Group<std::vector<MemberRow>> group{
      "members",
      "K",
      {},
      {
          column("point", &MemberRow::point, "", "row of /points"),
          column("seed", &MemberRow::seed, "", "seed"),
          column("status", &MemberRow::status, "", "as in its summary; empty: not run yet"),
      }};
  return group;
}

Group<std::vector<EnsembleEstimate>> estimate_group(const std::string& name, const std::string& unit) {
  return {name,
          "P",
          {},
          {
              column("mean", &EnsembleEstimate::mean, unit, "over the finished members of each point"),
              column("error", &EnsembleEstimate::error, unit, "standard error"),
              column("deviation", &EnsembleEstimate::deviation, unit, "standard deviation between members"),
              column("count", &EnsembleEstimate::count, "", "members where it is defined"),
              column("missing", &EnsembleEstimate::missing, "", "finished members where it is not"),
              column("low", &EnsembleEstimate::low, unit, "lower end of the 95 % interval of the mean"),
              column("high", &EnsembleEstimate::high, unit, "upper end"),
              column("bias", &EnsembleEstimate::bias, unit,
                     "estimated by the bootstrap, not subtracted, of measures of the mean profile; otherwise NaN"),
          }};
}

Group<EnsembleProfile> profile_group(const std::string& name) {
  const auto mean = [](const std::string& dataset, std::vector<double> BaseProfile::*member, const std::string& unit,
                       const std::string& meaning) {
    return array<EnsembleProfile>(
        dataset, [=](const EnsembleProfile& profile) -> const auto& { return profile.mean.*member; }, unit, meaning);
  };
  const auto number = [](const std::string& attribute_name, EnsembleEstimate EnsembleProfile::*which,
                         double EnsembleEstimate::*member, const std::string& meaning) {
    return attribute<EnsembleProfile>(
        attribute_name, [=](const EnsembleProfile& profile) { return (profile.*which).*member; }, "", meaning);
  };
  return {
      name,
      "B",
      {
          attribute("members", &EnsembleProfile::members, "", "that the mean profile has"),
          number("dip_index", &EnsembleProfile::dip_index, &EnsembleEstimate::mean, "of the mean profile"),
          number("dip_index_error", &EnsembleProfile::dip_index, &EnsembleEstimate::error,
                 "standard error by the bootstrap over members"),
          number("dip_index_low", &EnsembleProfile::dip_index, &EnsembleEstimate::low,
                 "lower end of its 95 % interval"),
          number("dip_index_high", &EnsembleProfile::dip_index, &EnsembleEstimate::high, "upper end"),
          number("dip_index_bias", &EnsembleProfile::dip_index, &EnsembleEstimate::bias,
                 "estimated by the bootstrap, not subtracted"),
          number("max_over_centre", &EnsembleProfile::max_over_centre, &EnsembleEstimate::mean, "of the mean profile"),
          number("max_over_centre_error", &EnsembleProfile::max_over_centre, &EnsembleEstimate::error,
                 "standard error by the bootstrap over members"),
          number("max_over_centre_low", &EnsembleProfile::max_over_centre, &EnsembleEstimate::low,
                 "lower end of its 95 % interval"),
          number("max_over_centre_high", &EnsembleProfile::max_over_centre, &EnsembleEstimate::high, "upper end"),
          number("max_over_centre_bias", &EnsembleProfile::max_over_centre, &EnsembleEstimate::bias,
                 "estimated by the bootstrap, not subtracted"),
          attribute("centre", &EnsembleProfile::centre, "L", "of the loaded interval of the mean profile"),
          attribute("half_width", &EnsembleProfile::half_width, "L", "of the same interval"),
      },
      {
          mean("x", &BaseProfile::x, "L", "centre"),
          mean("normal", &BaseProfile::normal, "grain weights", "mean over members, positive downward"),
          array("normal_error", &EnsembleProfile::normal_error, "grain weights", "standard error between members"),
          mean("shear", &BaseProfile::shear, "grain weights", "mean over members, positive to the right"),
          array("shear_error", &EnsembleProfile::shear_error, "grain weights", "standard error between members"),
      }};
}

Group<EnsembleColumn> column_group(const std::string& name, std::int64_t dimension) {
  const bool flat = dimension == 2;
  const std::string stress = flat ? "M/T^2" : "M/(L T^2)";
  const std::string walls = flat ? "the two walls" : "the cylinder";
  using Rows = std::vector<EnsembleLayer>;
  Columns<Rows> columns;
  const auto add = [&](const std::string& dataset, Estimate EnsembleLayer::*number, const std::string& unit,
                       const std::string& meaning) {
    columns.push_back(column<EnsembleLayer>(
        dataset, [=](const EnsembleLayer& layer) { return (layer.*number).mean; }, unit, meaning));
    columns.push_back(column<EnsembleLayer>(
        dataset + "_error", [=](const EnsembleLayer& layer) { return (layer.*number).error; }, unit,
        "standard error between members"));
  };
  add("depth", &EnsembleLayer::depth, "L", "of the middle of the slice below the surface");
  add("solid_fraction", &EnsembleLayer::solid_fraction, "",
      flat ? "disc area over area" : "volume of the spheres over volume");
  add("pressure", &EnsembleLayer::pressure, stress, "on " + walls);
  add("shear", &EnsembleLayer::shear, stress, "of " + walls + ", upwards on the grains");
  add("stress", &EnsembleLayer::stress, stress, "vertical");
  add("load", &EnsembleLayer::load, "M L/T^2", "upward force through the lower level");
  return {name,
          "S",
          {attribute("members", &EnsembleColumn::members, "", "that the means are over"),
           attribute("mass", &EnsembleColumn::mass, "M", "mean of a column")},
          columns_of<EnsembleColumn>(columns, &EnsembleColumn::layers)};
}

Group<BinnedProfile> binned_group(const std::string& name) {
  return {name,
          "bins",
          {attribute("bin_width", &BinnedProfile::bin_width, "L", "`analysis.base_bin`")},
          {
              array("x", &BinnedProfile::x, "L", "centre"),
              array("normal", &BinnedProfile::normal, "grain weights", "mean over members, positive downward"),
              array("normal_error", &BinnedProfile::normal_error, "grain weights", "standard error between members"),
              array("shear", &BinnedProfile::shear, "grain weights", "mean over members, positive to the right"),
              array("shear_error", &BinnedProfile::shear_error, "grain weights", "standard error between members"),
          }};
}

std::vector<ReferenceTable> sweep_reference() {
  const auto profile = profile_group("profiles");
  const auto of_column = column_group("columns", 2);
  const auto in_cylinder = column_group("columns", 3);
  return {
      claims_reference(),
      reference_of("points", "/points/", point_group().rows, point_group().columns),
      reference_of("measures", "/measures/NAME/", "P", estimate_group("", "that of the measure").columns),
      reference_of("members", "/members/", member_group().rows, member_group().columns),
      reference_of("profiles", profile.attributes),
      reference_of("profiles", "/profiles/NNNN/", profile.rows, profile.columns),
      reference_of("columns", of_column.attributes),
      reference_of("columns", "/columns/NNNN/", of_column.rows, of_column.columns),
      reference_of("columns of spheres", "/columns/NNNN/", in_cylinder.rows, in_cylinder.columns),
  };
}

}  // namespace repose
