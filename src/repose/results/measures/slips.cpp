// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// Stick and slip of a driven wall: only where the analysis was asked for it.
void add_slips(Registry& to) {
  const auto asked = [](const Measured& run) { return run.results.slips.has_value(); };
  const auto of = [](auto member) {
    return [=](const Measured& run) { return std::invoke(member, *run.results.slips); };
  };
  const auto of_drops = [](auto member) {
    return [=](const Measured& run) { return std::invoke(member, run.results.slips->drops); };
  };
  const auto mean = [](auto member) {
    return [=](const Measured& run) {
      std::vector<double> values;  // NaN of the first slip, before which there is none
      for (const auto& slip : run.results.slips->events) values.push_back(slip.*member);
      return mean_of(values).mean;
    };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(only_where(asked, measure("slips", "", "stick and slip of a driven wall (`--slips`)",
                                [](const Measured&) { return Object{}; })));
  add(measure("slips.problem", "", "why there are none to look for; empty where there are", of(&Slips::problem)));
  add(measure("slips.wall", "", "the wall: the first driven by a spring, else the first of given speed",
              of(&Slips::wall)));
  add(measure("slips.from", "T", "slips before then are left out: the first fifth of its time", of(&Slips::from)));
  add(measure("slips.mean_force", "M L/T^2", "mean force that drives it, from then on", of(&Slips::mean_force)));
  add(measure("slips.hysteresis", "M L/T^2", "smaller changes of that force are no slips: a thousandth of the mean",
              of(&Slips::hysteresis)));
  add(measure("slips.count", "", "falls of that force, each from a maximum to the next minimum",
              [](const Measured& run) { return static_cast<std::int64_t>(run.results.slips->events.size()); }));
  add(measure("slips.sliding", "", "fraction of the time spent in slips", of(&Slips::sliding)));
  add(measure("slips.stuck", "", "fraction of the time in which the wall is slower than a tenth of what drives it",
              of(&Slips::stuck)));
  add(measure("slips.deviation", "", "standard deviation of the force over its mean", of(&Slips::deviation)));
  add(measure("slips.drive_speed", "L/T", "of the far end of the spring, or of the wall", of(&Slips::drive_speed)));
  add(measure("slips.steady_speed", "L/T", "v_t = (m/k)^(1/2) g, m the mass of the piston and all grains",
              of(&Slips::steady_speed)));
  add(measure("slips.relative_speed", "", "drive_speed/steady_speed",
              [](const Measured& run) { return run.results.slips->drive_speed / run.results.slips->steady_speed; }));
  add(measure("slips.mean_drop", "M L/T^2", "mean fall of the force", mean(&Slip::drop)));
  add(measure("slips.mean_peak", "M L/T^2", "mean force at which slips begin", mean(&Slip::force)));
  add(measure("slips.mean_waiting", "T", "mean time from the end of a slip to the beginning of the next",
              mean(&Slip::waiting)));
  add(measure("slips.mean_slide", "L", "mean displacement of the wall in a slip", mean(&Slip::slide)));
  add(measure("slips.mean_creep", "L", "mean displacement of the wall from a slip to the next", mean(&Slip::creep)));
  const auto fraction = [](double Slip::*member) {
    return [=](const Measured& run) {
      std::vector<double> positive;
      for (const auto& slip : run.results.slips->events) {
        if (slip.*member == slip.*member) positive.push_back(slip.*member > 0.0 ? 1.0 : 0.0);
      }
      return mean_of(positive).mean;
    };
  };
  add(measure("slips.mean_dilation", "", "mean relative growth of the volume of the column in a slip",
              mean(&Slip::dilation)));
  add(measure("slips.dilating", "", "fraction of the slips in which it grows", fraction(&Slip::dilation)));
  add(measure("slips.mean_compaction", "", "mean relative shrinkage of its volume from a slip to the next",
              mean(&Slip::compaction)));
  add(measure("slips.compacting", "", "fraction of these times in which it shrinks", fraction(&Slip::compaction)));
  add(measure("slips.drops", "", "power law of the drops, by maximum likelihood",
              [](const Measured&) { return Object{}; }));
  add(measure("slips.drops.events", "", "drops above 0", of_drops(&TailFit::events)));
  add(measure("slips.drops.tail", "", "of them drops of at least x_min", of_drops(&TailFit::tail)));
  add(measure("slips.drops.x_min", "M L/T^2", "where the law begins", of_drops(&TailFit::x_min)));
  add(measure("slips.drops.exponent", "", "a in p(x) ~ x^-a from x_min on", of_drops(&TailFit::exponent)));
  add(measure("slips.drops.error", "", "standard error of the exponent, (a - 1)/sqrt(tail)",
              of_drops(&TailFit::error)));
  add(measure("slips.drops.decades", "", "log10 of the largest drop over x_min", of_drops(&TailFit::decades)));
  add(measure("slips.drops.distance", "", "of Kolmogorov and Smirnov, between drops and law",
              of_drops(&TailFit::distance)));
  add(measure("slips.drops.p_value", "", "fraction of synthetic samples of the law that lie farther from their own fit",
              of_drops(&TailFit::p_value)));
  const auto rival = [](auto law, auto member) {
    return [=](const Measured& run) { return (run.results.slips->drops.*law).*member; };
  };
  add(measure("slips.drops.exponential_ratio", "", "log of the likelihood of the power law over that of an exponential",
              rival(&TailFit::exponential, &RivalLaw::log_ratio)));
  add(measure("slips.drops.exponential_p", "", "that chance makes a ratio as far from 0, two-sided (Vuong)",
              rival(&TailFit::exponential, &RivalLaw::p_value)));
  add(measure("slips.drops.log_normal_ratio", "", "the same of a log-normal law cut at x_min; at most 0",
              rival(&TailFit::log_normal, &RivalLaw::log_ratio)));
  add(measure("slips.drops.log_normal_p", "", "that chance makes a ratio as far below 0",
              rival(&TailFit::log_normal, &RivalLaw::p_value)));
  add(measure("slips.drops.verdict", "",
              "\"power law\" where all tests, 10 000 drops in the tail and two decades carry it; else why not",
              of_drops(&TailFit::verdict)));
  using Drive = std::vector<DriveRow>;
  const Group<Drive> drive{
      "drive",
      "rows",
      {},
      {column("time", &DriveRow::time, "T", "of the row of the time series"),
       column("force", &DriveRow::force, "M L/T^2",
              "that drives the wall: of its spring, or against the grains as a mean since the row before"),
       column("displacement", &DriveRow::displacement, "L", "of the wall along its direction"),
       column("solid_fraction", &DriveRow::solid_fraction, "",
              "of the column between two upright walls; NaN without")}};
  to.groups.push_back(analysis_group(drive, [](const Measured& run) {
    const auto& found = run.results.slips;
    return found && !found->drive.empty() ? &found->drive : nullptr;
  }));
  using Rows = std::vector<Slip>;
  const Columns<Rows> columns{
      column("begin", &Slip::begin, "T", "of the slip, where the force is largest"),
      column("end", &Slip::end, "T", "where it is smallest"),
      column("force", &Slip::force, "M L/T^2", "at the beginning"),
      column("drop", &Slip::drop, "M L/T^2", "by which the force falls"),
      column("slide", &Slip::slide, "L", "displacement of the wall in the slip"),
      column("waiting", &Slip::waiting, "T", "since the end of the slip before; NaN for the first"),
      column("creep", &Slip::creep, "L", "displacement of the wall since then; NaN for the first"),
      column("dilation", &Slip::dilation, "",
             "relative growth of the volume of the column in the slip, by its solid fraction; NaN without a column"),
      column("compaction", &Slip::compaction, "", "relative shrinkage of it since the slip before; NaN for the first"),
  };
  const Group<Slips> group{
      "slips",
      "slips",
      {attribute("from", &Slips::from, "T", "`slips.from`"),
       attribute("mean_force", &Slips::mean_force, "M L/T^2", "`slips.mean_force`"),
       attribute("wall", &Slips::wall, "", "`slips.wall`"),
       attribute<Slips>(
           "x_min", [](const Slips& found) { return found.drops.x_min; }, "M L/T^2", "`slips.drops.x_min`"),
       attribute<Slips>(
           "exponent", [](const Slips& found) { return found.drops.exponent; }, "", "`slips.drops.exponent`"),
       attribute<Slips>(
           "verdict", [](const Slips& found) { return found.drops.verdict; }, "", "`slips.drops.verdict`")},
      columns_of<Slips>(columns, &Slips::events)};
  to.groups.push_back(analysis_group(group, [](const Measured& run) {
    const auto& found = run.results.slips;
    return found && !found->events.empty() ? &*found : nullptr;
  }));
}

}  // namespace repose
