// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/statistics.hpp"
#include "repose/record/force_unit.hpp"
#include "repose/results/registry.hpp"

#include <algorithm>

namespace repose {

namespace {

std::optional<Object> with_track(const Measured& run) {
  return run.results.motion.rows.empty() ? std::nullopt : std::optional(Object{});
}

/// Mean over the events of a list; the waiting time of the first is not defined and does not count.
template <class Event, class Value>
auto mean_over(std::vector<Event> Motion::*list, Value Event::*member) {
  return [=](const Measured& run) {
    std::vector<double> values;
    for (const auto& event : run.results.motion.*list) values.push_back(static_cast<double>(event.*member));
    return mean_of(values).mean;
  };
}

std::size_t largest_size(const Measured& run) {
  std::size_t largest = 0;
  for (const auto& event : run.results.motion.avalanches) largest = std::max(largest, event.size);
  return largest;
}

double threshold_of_bursts(const Measured& run) { return burst_threshold(run.record.scene, run.results.force_unit); }

template <class Event>
Columns<std::vector<Event>> time_columns() {
  return {
      column("start", &Event::start, "T", "of the event"),
      column("end", &Event::end, "T", "of the event"),
      column("duration", &Event::duration, "T", "end - start"),
      column("waiting", &Event::waiting, "T", "since the end of the event before; NaN for the first"),
  };
}

/// A group made from one list of the motion.
template <class Row>
void add_list(Registry& to, const std::string& name, std::vector<Row> Motion::*list, Attributes<Measured> attributes,
              const Columns<std::vector<Row>>& columns) {
  to.groups.push_back(
      analysis_group({name, "rows", std::move(attributes),
                      columns_of<Measured>(
                          columns, [=](const Measured& run) -> const auto& { return run.results.motion.*list; })},
                     [](const Measured& run) { return !run.results.motion.rows.empty(); }));
}

void add_groups(Registry& to) {
  add_list(
      to, "motion", &Motion::rows, {},
      {
          column("start", &MotionRow::start, "T", "of the interval"),
          column("end", &MotionRow::end, "T", "of the interval"),
          column("grains", &MotionRow::grains, "", "in the heap at both ends: those that count"),
          column("moved", &MotionRow::moved, "", "of those, moved farther than `analysis.moved`"),
          column("moved_left", &MotionRow::moved_left, "", "of these, left of the apex"),
          column("depth", &MotionRow::depth, "L",
                 "of the moving layer: 90th percentile, over the moved grains, of the depth of their lowest point "
                 "below the surface, at right angles to the flank; NaN if none"),
          column("kinetic_energy", &MotionRow::kinetic_energy, "M L^2/T^2", "of the grains that count, at the end"),
          column("angle_left", &MotionRow::angle_left_deg, "deg",
                 "of the surface at the end; NaN where no line could be drawn"),
          column("angle_right", &MotionRow::angle_right_deg, "deg",
                 "of the surface at the end; NaN where no line could be drawn"),
      });
  auto avalanches = time_columns<Avalanche>();
  avalanches.push_back(column("size", &Avalanche::size, "", "distinct grains that moved"));
  avalanches.push_back(
      column("depth", &Avalanche::depth, "L", "of the moving layer, as in /motion, over all moves of the avalanche"));
  avalanches.push_back(column("left", &Avalanche::left, "", "fraction of the moves left of the apex"));
  add_list(to, "avalanches", &Motion::avalanches,
           {
               attribute<Measured>(
                   "interval",
                   [](const Measured& run) {
                     const auto& first = run.results.motion.rows.front();
                     return first.end - first.start;
                   },
                   "T", "between moments of the track"),
               attribute<Measured>(
                   "least", [](const Measured& run) { return run.record.scene.analysis.avalanche; }, "",
                   "grains that move in each interval: `analysis.avalanche`"),
           },
           avalanches);
  auto bursts = time_columns<Burst>();
  bursts.push_back(column("peak", &Burst::peak, "M L^2/T^2", "largest kinetic energy"));
  add_list(to, "bursts", &Motion::bursts,
           {attribute<Measured>("threshold", threshold_of_bursts, "M L^2/T^2",
                                "kinetic energy above which there is a burst")},
           bursts);
}

}  // namespace

/// Avalanches and bursts of kinetic energy, from the track.
void add_motion(Registry& to) {
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("avalanches", "", "intervals of the track in which many grains moved; null without a track", with_track));
  add(measure("avalanches.count", "", "number of avalanches",
              [](const Measured& run) { return run.results.motion.avalanches.size(); }));
  add(measure("avalanches.largest_size", "", "distinct grains that moved in the largest", largest_size));
  add(measure("avalanches.mean_size", "", "distinct grains that moved",
              mean_over(&Motion::avalanches, &Avalanche::size)));
  add(measure("avalanches.mean_duration", "T", "from start to end",
              mean_over(&Motion::avalanches, &Avalanche::duration)));
  add(measure("avalanches.mean_waiting", "T", "from the end of one to the start of the next",
              mean_over(&Motion::avalanches, &Avalanche::waiting)));
  add(measure("avalanches.mean_depth", "L", "of the moving layer", mean_over(&Motion::avalanches, &Avalanche::depth)));
  add(measure("bursts", "", "intervals of high kinetic energy; null without a track", with_track));
  add(measure("bursts.count", "", "number of bursts",
              [](const Measured& run) { return run.results.motion.bursts.size(); }));
  add(measure("bursts.mean_peak", "M L^2/T^2", "largest kinetic energy", mean_over(&Motion::bursts, &Burst::peak)));
  add(measure("bursts.mean_duration", "T", "from start to end", mean_over(&Motion::bursts, &Burst::duration)));
  add(measure("bursts.mean_waiting", "T", "from the end of one to the start of the next",
              mean_over(&Motion::bursts, &Burst::waiting)));
  add_groups(to);
}

}  // namespace repose
