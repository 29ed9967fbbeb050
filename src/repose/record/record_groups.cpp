// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record_groups.hpp"

#include "repose/core/version.hpp"

namespace repose {

namespace {

template <int D>
Attributes<Record<D>> attributes_of_run() {
  using Run = Record<D>;
  const auto fact = [](const std::string& name, auto member, const std::string& unit, const std::string& meaning) {
    return attribute<Run>(
        name, [=](auto& record) -> auto& { return record.facts.*member; }, unit, meaning);
  };
  // Files of older programs have no hash of their scene.
  auto scene_hash = fact("scene_hash", &RunFacts::scene_hash, "",
                         "of the text of `/scene`, the same in every file of a run: a file of another run is refused");
  scene_hash.read = [](const Hdf5Reader& file, const std::string& object, Run& record) {
    record.facts.scene_hash = file.text_or(object, "scene_hash", "");
  };
  return {
      attribute<Run>(
          "format", [](const Run&) { return std::string(run_format); }, "", "\"repose-run\""),
      attribute<Run>(
          "format_version", [](const Run&) { return run_format_version; }, "", "of this layout"),
      attribute<Run>(
          "repose_version", [](const Run&) { return std::string(version); }, "", ""),
      attribute<Run>(
          "title", [](const Run& r) { return r.scene.title; }, "", "of the scene"),
      attribute<Run>(
          "method", [](const Run& r) { return std::string(r.scene.method->name()); }, "", "`method.kind` of the scene"),
      attribute<Run>(
          "units", [](const Run& r) { return r.scene.units; }, "", "of the scene"),
      attribute<Run>(
          "dimension", [](const Run&) { return D; }, "", "D"),
      attribute<Run>(
          "seed", [](const Run& r) { return r.scene.seed; }, "", "of everything random"),
      fact("time", &RunFacts::time, "T", "of the state"),
      fact("time_step", &RunFacts::time_step, "T", ""),
      fact("steps", &RunFacts::steps, "", "taken so far"),
      attribute<Run>(
          "status", [](const Run& r) { return status_text(r.facts.status); }, "",
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
      attribute<Run>(
          "gravity",
          [](const Run& r) {
            const auto gravity = r.scene.template gravity_vector<D>();
            std::vector<double> numbers;
            for (int axis = 0; axis < D; ++axis) numbers.push_back(gravity[axis]);
            return numbers;
          },
          "L/T^2", "vector"),
      attribute<Run>(
          "grain_diameter", [](const Run& r) { return r.scene.grains.diameter; }, "L", "of a grain of nominal size"),
      attribute<Run>(
          "grain_weight", [](const Run& r) { return r.scene.grain_weight(); }, "M L/T^2",
          "of a grain of nominal size, or of the mean grain at the start where none is of that size: the unit of all "
          "forces \"in grain weights\""),
      attribute<Run>(
          "periodic", [](const Run& r) { return r.box.periodic; }, "", "1: x wraps; else 0"),
      attribute<Run>(
          "x_min", [](const Run& r) { return r.box.x_min; }, "L", "left side of the box"),
      attribute<Run>(
          "x_max", [](const Run& r) { return r.box.x_max; }, "L", "right side of the box"),
  };
}

}  // namespace

template <>
const Attributes<Record<2>>& run_attributes() {
  static const auto list = attributes_of_run<2>();
  return list;
}

/// The attributes in two dimensions, and the box along y.
template <>
const Attributes<Record<3>>& run_attributes() {
  using Run = Record<3>;
  static const auto list = [] {
    auto all = attributes_of_run<3>();
    all.push_back(attribute<Run>(
        "periodic_y", [](const Run& r) { return r.box.periodic_y; }, "", "1: y wraps; else 0"));
    all.push_back(attribute<Run>(
        "y_min", [](const Run& r) { return r.box.y_min; }, "L", "front of the box"));
    all.push_back(attribute<Run>(
        "y_max", [](const Run& r) { return r.box.y_max; }, "L", "back of the box"));
    return all;
  }();
  return list;
}

namespace {

template <int D>
Group<std::vector<RecordedWall<D>>> group_of_walls() {
  using Row = RecordedWall<D>;
  const auto of_wall = [](const std::string& name, auto member, const std::string& unit, const std::string& meaning) {
    return column<Row>(
        name, [=](auto& row) -> auto& { return row.wall.*member; }, unit, meaning);
  };
  const auto of_crossed = [](const std::string& name, auto member, const std::string& unit,
                             const std::string& meaning) {
    return column<Row>(
        name, [=](auto& row) -> auto& { return row.crossed.*member; }, unit, meaning);
  };
  return {"walls",
          "W",
          {},
          {
              column("name", &Row::name, "", "\"base\", or that of the scene"),
              column("point", &Row::start, "L", "a point of the wall at the start, the middle of a finite one"),
              of_wall("normal", &Wall<D>::normal, "", "unit normal at the time of the state, towards the grains"),
              column<Row>(
                  "direction", [](auto& row) -> auto& { return row.wall.motion.direction; }, "",
                  "unit vector along which the wall moves; 0: it does not"),
              column<Row>(
                  "centre", [](auto& row) -> auto& { return row.wall.motion.centre; }, "L",
                  "the point about which it rotates"),
              column("rotates", &Row::rotates, "", "1: the wall rotates about `centre`"),
              of_wall("half_length", &Wall<D>::half_length, "L", "half the length; infinite for a plane"),
              of_wall("opens_at", &Wall<D>::opens_at, "T", "from then on grains pass through it; infinite: never"),
              of_wall("position", &Wall<D>::point, "L", "where `point` is at the time of the state"),
              column("open", &Row::open, "", "1: the wall has opened"),
              of_crossed("crossed", &Crossings::count, "", "grains that have gone through a wall of finite length"),
              of_crossed("first_crossed", &Crossings::first, "", "id of the first of them; -1: none"),
              of_crossed("crossed_at", &Crossings::time, "T", "by which that was noticed"),
          }};
}

}  // namespace

template <>
const Group<std::vector<RecordedWall<2>>>& wall_group() {
  static const auto group = group_of_walls<2>();
  return group;
}

/// The columns of two dimensions, and the shape.
template <>
const Group<std::vector<RecordedWall<3>>>& wall_group() {
  using Row = RecordedWall<3>;
  static const auto group = [] {
    auto made = group_of_walls<3>();
    made.columns.push_back(column<Row>(
        "shape",
        [](const Row& row) { return std::string(row.wall.finite() ? shape_name(row.wall.shape.kind) : "plane"); }, "",
        "\"plane\", \"disc\", \"rectangle\", \"triangle\" or \"frustum\", whose axis is the normal"));
    made.columns.push_back(column<Row>(
        "side", [](auto& row) -> auto& { return row.wall.shape.side; }, "",
        "unit vector along the wall at the time of the state; its third axis is normal x side"));
    made.columns.push_back(column<Row>(
        "axis", [](auto& row) -> auto& { return row.wall.motion.axis; }, "",
        "unit vector about which it rotates, through `centre`"));
    made.columns.push_back(column<Row>(
        "corners",
        [](const Row& row) {
          std::array<double, 6> numbers{};
          for (std::size_t k = 0; k < 3; ++k) {
            numbers[2 * k] = row.wall.shape.corners[k][0];
            numbers[2 * k + 1] = row.wall.shape.corners[k][1];
          }
          return numbers;
        },
        "L",
        "from `position` along side and the third axis: three of a triangle, of a rectangle one; of a frustum the ends "
        "of "
        "the line that turns, as distance from the axis and place along it"));
    return made;
  }();
  return group;
}

template <>
const Group<BaseProfile>& base_group<2>() {
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

template <>
const Group<BaseProfile>& base_group<3>() {
  static const auto group = [] {
    auto made = base_group<2>();
    made.columns.push_back(array("y", &BaseProfile::y, "L", "centre"));
    made.columns.push_back(
        array("shear_y", &BaseProfile::shear_y, "grain weights", "force of the heap along y; `shear` is that along x"));
    return made;
  }();
  return group;
}

}  // namespace repose
