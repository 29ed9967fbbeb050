// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record_groups.hpp"

#include "repose/core/version.hpp"

namespace repose {

const Attributes<Record>& run_attributes() {
  const auto fact = [](const std::string& name, auto member, const std::string& unit, const std::string& meaning) {
    return attribute<Record>(
        name, [=](auto& record) -> auto& { return record.facts.*member; }, unit, meaning);
  };
  // Files of older programs have no hash of their scene.
  auto scene_hash = fact("scene_hash", &RunFacts::scene_hash, "",
                         "of the text of `/scene`, the same in every file of a run: a file of another run is refused");
  scene_hash.read = [](const Hdf5Reader& file, const std::string& object, Record& record) {
    record.facts.scene_hash = file.text_or(object, "scene_hash", "");
  };
  static const Attributes<Record> list{
      attribute<Record>(
          "format", [](const Record&) { return std::string(run_format); }, "", "\"repose-run\""),
      attribute<Record>(
          "format_version", [](const Record&) { return run_format_version; }, "", "of this layout"),
      attribute<Record>(
          "repose_version", [](const Record&) { return std::string(version); }, "", ""),
      attribute<Record>(
          "title", [](const Record& r) { return r.scene.title; }, "", "of the scene"),
      attribute<Record>(
          "method", [](const Record& r) { return std::string(r.scene.method->name()); }, "",
          "`method.kind` of the scene"),
      attribute<Record>(
          "units", [](const Record& r) { return r.scene.units; }, "", "of the scene"),
      attribute<Record>(
          "dimension", [](const Record&) { return 2; }, "", "D"),
      attribute<Record>(
          "seed", [](const Record& r) { return r.scene.seed; }, "", "of everything random"),
      fact("time", &RunFacts::time, "T", "of the state"),
      fact("time_step", &RunFacts::time_step, "T", ""),
      fact("steps", &RunFacts::steps, "", "taken so far"),
      attribute<Record>(
          "status", [](const Record& r) { return status_text(r.facts.status); }, "",
          "\"running\", \"finished\", \"interrupted\" or \"failed\""),
      fact("message", &RunFacts::message, "", "why the run stopped"),
      fact("threads", &RunFacts::threads, "", "of the program"),
      fact("wall_seconds", &RunFacts::wall_seconds, "s", "wall time of the run"),
      fact("grain_steps", &RunFacts::grain_steps, "", "moving grains times steps"),
      fact("released", &RunFacts::released, "", "grains that the source has released"),
      fact("lost", &RunFacts::lost, "", "grains that have left"),
      fact("support_force", &RunFacts::support_force, "M L/T^2",
           "downward, on fixed grains (mean over the window) and walls (at that time)"),
      fact("state_hash", &RunFacts::state_hash, "", "of the exact state ([summary.md](summary.md))"),
      scene_hash,
      attribute<Record>(
          "gravity",
          [](const Record& r) {
            return std::vector<double>{0.0, -r.scene.gravity};
          },
          "L/T^2", "vector"),
      attribute<Record>(
          "grain_diameter", [](const Record& r) { return r.scene.grains.diameter; }, "L", "of a grain of nominal size"),
      attribute<Record>(
          "grain_weight", [](const Record& r) { return r.scene.grain_weight(); }, "M L/T^2",
          "of a grain of nominal size, or of the mean grain at the start where none is of that size: the unit of all "
          "forces \"in grain weights\""),
      attribute<Record>(
          "periodic", [](const Record& r) { return r.box.periodic; }, "", "1: x wraps; else 0"),
      attribute<Record>(
          "x_min", [](const Record& r) { return r.box.x_min; }, "L", "left side of the box"),
      attribute<Record>(
          "x_max", [](const Record& r) { return r.box.x_max; }, "L", "right side of the box"),
  };
  return list;
}

const Group<std::vector<RecordedWall>>& wall_group() {
  const auto of_wall = [](const std::string& name, auto member, const std::string& unit, const std::string& meaning) {
    return column<RecordedWall>(
        name, [=](auto& row) -> auto& { return row.wall.*member; }, unit, meaning);
  };
  const auto of_crossed = [](const std::string& name, auto member, const std::string& unit,
                             const std::string& meaning) {
    return column<RecordedWall>(
        name, [=](auto& row) -> auto& { return row.crossed.*member; }, unit, meaning);
  };
  static const Group<std::vector<RecordedWall>> group{
      "walls",
      "W",
      {},
      {
          column("name", &RecordedWall::name, "", "\"base\", or that of the scene"),
          column("point", &RecordedWall::start, "L", "a point of the wall at the start, the middle of a finite one"),
          of_wall("normal", &Wall<2>::normal, "", "unit normal at the time of the state, towards the grains"),
          column<RecordedWall>(
              "direction", [](auto& row) -> auto& { return row.wall.motion.direction; }, "",
              "unit vector along which the wall moves; 0: it does not"),
          column<RecordedWall>(
              "centre", [](auto& row) -> auto& { return row.wall.motion.centre; }, "L",
              "the point about which it rotates"),
          column("rotates", &RecordedWall::rotates, "", "1: the wall rotates about `centre`"),
          of_wall("half_length", &Wall<2>::half_length, "L", "half the length; infinite for a plane"),
          of_wall("opens_at", &Wall<2>::opens_at, "T", "from then on grains pass through it; infinite: never"),
          of_wall("position", &Wall<2>::point, "L", "where `point` is at the time of the state"),
          column("open", &RecordedWall::open, "", "1: the wall has opened"),
          of_crossed("crossed", &Crossings::count, "", "grains that have gone through a wall of finite length"),
          of_crossed("first_crossed", &Crossings::first, "", "id of the first of them; -1: none"),
          of_crossed("crossed_at", &Crossings::time, "T", "by which that was noticed"),
      }};
  return group;
}

const Group<BaseProfile>& base_group() {
  static const Group<BaseProfile> group{
      "base",
      "B",
      {
          attribute("window_start", &BaseProfile::window_start, "T", "forces are means from then"),
          attribute("window_end", &BaseProfile::window_end, "T", "until then"),
      },
      {
          array("id", &BaseProfile::id, "", "grain id"),
          array("x", &BaseProfile::x, "L", "centre"),
          array("normal", &BaseProfile::normal, "grain weights",
                "force of the heap, positive downward; in M L/T^2 without gravity"),
          array("shear", &BaseProfile::shear, "grain weights",
                "force of the heap, positive to the right; in M L/T^2 without gravity"),
      }};
  return group;
}

}  // namespace repose
