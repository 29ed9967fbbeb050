// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace repose {

namespace {

struct Name {
  const char* name;
  GrainColumn column;
};
constexpr Name names[] = {
    {"id", GrainColumn::id},
    {"type", GrainColumn::type},
    {"vx", GrainColumn::vx},
    {"vy", GrainColumn::vy},
    {"vz", GrainColumn::vz},
    {"omegax", GrainColumn::spin_x},
    {"omegay", GrainColumn::spin_y},
    {"omegaz", GrainColumn::spin_z},
    {"radius", GrainColumn::radius},
    {"mass", GrainColumn::mass},
    {"diameter", GrainColumn::diameter},
    {"fixed", GrainColumn::fixed},
    {"base", GrainColumn::base},
};

/// What follows the axis in the names of positions, the most exact first. Scaled positions are fractions of the box.
struct Ending {
  const char* name;
  bool scaled;
};
constexpr Ending endings[] = {{"", false}, {"u", false}, {"s", true}, {"su", true}};

/// Reads a dump item by item.
class Dump {
 public:
  Dump(TextLines& lines, FileProblems& problems, const ReaderOptions& options)
      : lines_(lines), problems_(problems), options_(options) {}

  SeenFile read() {
    while (next()) read_item(false);
    if (!started_) problems_.stop(1, "no snapshot: no ITEM: TIMESTEP");
    if (!complete_ && (options_.step == last_snapshot || !start_))
      problems_.stop(line(), "the file ends in the middle of a snapshot");
    if (!start_)
      problems_.stop(line(), fmt::format("no snapshot of step {}; the last is of step {}", options_.step, step_));
    lines_.rewind();
    while (line() < *start_) lines_.next(text_);
    started_ = false;
    while (!grains_ && next()) read_item(true);
    file_.format = liggghts_ ? "LIGGGHTS dump" : "LAMMPS dump";
    file_.snapshot = step_;
    grains_->take(file_);
    return std::move(file_);
  }

 private:
  std::size_t line() const { return lines_.number(); }

  bool next() {
    if (!lines_.next(text_)) return false;
    split(text_, blanks, cells_);
    return true;
  }

  void demand_next(const char* of) {
    if (!next()) problems_.stop(line(), fmt::format("the file ends in the middle of {}", of));
  }

  bool is(std::initializer_list<const char*> words) const {
    return cells_.size() > words.size() && std::equal(words.begin(), words.end(), cells_.begin() + 1);
  }

  void read_item(bool keep) {
    if (cells_.empty()) return;
    if (cells_.front() != "ITEM:") problems_.stop(line(), "must be an ITEM: of a LAMMPS text dump");
    if (is({"TIMESTEP"})) {
      if (started_ && !complete_) problems_.stop(line(), "a snapshot begins before the one above has its ITEM: ATOMS");
      const auto before = line() - 1;
      started_ = true;
      complete_ = false;
      count_.reset();
      if (!keep) ++snapshots_;
      demand_next("a snapshot");
      const auto step = cells_.size() == 1 ? integer_of(cells_.front()) : std::nullopt;
      if (!step) problems_.stop(line(), "must be the number of a step");
      step_ = *step;
      if (options_.step == last_snapshot || step_ == options_.step) start_ = before;
    } else if (is({"UNITS"})) {
      demand_next("a snapshot");
      if (!cells_.empty()) file_.units = lammps_units(cells_.front());
    } else if (is({"TIME"}) || is({"LABEL"})) {
      demand_next("a snapshot");
    } else if (is({"NUMBER", "OF", "ATOMS"})) {
      demand_next("a snapshot");
      count_ = cells_.size() == 1 ? integer_of(cells_.front()) : std::nullopt;
      if (!count_ || *count_ < 0) problems_.stop(line(), "must be the number of atoms");
    } else if (is({"BOX", "BOUNDS"})) {
      read_box();
    } else if (is({"ATOMS"})) {
      read_atoms(keep);
    } else if (is({"ENTRIES"}) || is({"NUMBER", "OF", "ENTRIES"})) {
      problems_.stop(line(), "is a dump of contacts (local), not of grains");
    } else {
      problems_.stop(line(), "is an unknown ITEM: of a LAMMPS text dump");
    }
  }

  /// The last three words of the line, if there are any, tell the sides: pp, ff, ...
  void read_box() {
    const std::vector<std::string> words(cells_.begin() + 3, cells_.end());
    tilted_ = std::find(words.begin(), words.end(), "xy") != words.end() ||
              std::find(words.begin(), words.end(), "abc") != words.end();
    std::array<std::string, 3> sides;
    for (std::size_t axis = 0; axis < 3 && words.size() >= 3; ++axis) {
      const auto& word = words[words.size() - 3 + axis];
      sides[axis] = word == "pp" ? "periodic" : word.size() == 2 ? "open" : "";
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      demand_next("ITEM: BOX BOUNDS");
      const auto low = cells_.size() >= 2 ? number_of(cells_[0]) : std::nullopt;
      const auto high = cells_.size() >= 2 ? number_of(cells_[1]) : std::nullopt;
      if (!low || !high) problems_.stop(line(), "must be the bounds of the box");
      box_[axis] = {*low, *high - *low};
    }
    SeenBox box;
    box.tilted = tilted_;
    for (std::size_t k = 0; k < options_.axes(); ++k) {
      const auto axis = static_cast<std::size_t>(axes_of(options_.plane)[k][0] - 'x');
      box.low[static_cast<int>(k)] = box_[axis].origin;
      box.high[static_cast<int>(k)] = box_[axis].origin + box_[axis].length;
      box.sides[k] = sides[axis];
    }
    file_.box = box;
  }

  void read_atoms(bool keep) {
    if (!started_ || !count_) problems_.stop(line(), "ITEM: TIMESTEP and ITEM: NUMBER OF ATOMS must come before");
    if (keep) {
      begin_grains();
      file_.snapshots = snapshots_;
      read_rows(lines_, *count_, problems_, *grains_);
    } else {
      for (std::int64_t k = 0; k < *count_; ++k) {
        if (!lines_.next(text_)) {
          problems_.stop(line(), fmt::format("the file ends after {} of {} grains", k, *count_));
        }
      }
    }
    complete_ = true;
  }

  void begin_grains() {
    const std::vector<std::string> given(cells_.begin() + 2, cells_.end());
    const auto has = [&](const std::string& name) {
      return std::find(given.begin(), given.end(), name) != given.end();
    };
    const auto axes = axes_of(options_.plane);
    const auto* ending = std::find_if(std::begin(endings), std::end(endings), [&](const auto& e) {
      return std::all_of(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(options_.axes()),
                         [&](const auto& axis) { return has(axis + e.name); });
    });
    const auto places = [&](const std::string& end) {
      std::string names;
      for (std::size_t k = 0; k < options_.axes(); ++k) names += (k == 0 ? "" : " ") + axes[k] + end;
      return names;
    };
    if (ending == std::end(endings) || (!has("radius") && !has("diameter"))) {
      problems_.stop(line(),
                     fmt::format("must have the columns {} (or {}, {}, {}) and radius or diameter: dump custom ... id "
                                 "type x y z radius",
                                 places(""), places("u"), places("s"), places("su")));
    }
    if (ending->scaled && tilted_) problems_.stop(line(), "scaled positions in a tilted box: dump x y or xu yu");
    std::vector<GrainLines::Column> columns;
    constexpr std::array<GrainColumn, 3> vector{GrainColumn::x, GrainColumn::y, GrainColumn::z};
    for (const auto& name : given) {
      auto column = GrainColumn::none;  // a column for other programs
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (name == std::string(1, static_cast<char>('x' + axis)) + ending->name) column = vector[axis];
      }
      for (const auto& known : names) {
        if (name == known.name) column = known.column;
      }
      if (column == GrainColumn::diameter && has("radius")) column = GrainColumn::none;
      columns.push_back({column, name});
    }
    liggghts_ = std::count(given.begin(), given.end(), "type") > 1;
    grains_.emplace(problems_, columns, options_, ending->scaled ? in_order() : std::array<Scaling, 3>{});
  }

  /// The box along the axes of the plane, and across it.
  std::array<Scaling, 3> in_order() const {
    std::array<Scaling, 3> scaling;
    for (std::size_t k = 0; k < 3; ++k)
      scaling[k] = box_[static_cast<std::size_t>(axes_of(options_.plane)[k][0] - 'x')];
    return scaling;
  }

  TextLines& lines_;
  FileProblems& problems_;
  SeenFile file_;
  ReaderOptions options_;
  std::string text_;
  std::vector<std::string_view> cells_;  // of the current line
  std::int64_t step_ = 0;                // step of the latest snapshot
  std::optional<std::size_t> start_;     // the line before the wanted snapshot
  bool started_ = false;
  bool complete_ = false;
  bool tilted_ = false;
  bool liggghts_ = false;
  std::size_t snapshots_ = 0;
  std::optional<std::int64_t> count_;
  std::array<Scaling, 3> box_{};
  std::optional<GrainLines> grains_;
};

}  // namespace

FileUnits lammps_units(std::string_view name) {
  FileUnits units{.name = std::string(name)};
  units.reduced = name == "lj";
  if (name == "si") {
    units.length = units.mass = units.time = 1.0;
  } else if (name == "cgs") {
    units.length = 1e-2;
    units.mass = 1e-3;
    units.time = 1.0;
  } else if (name == "micro") {
    units.length = units.time = 1e-6;
    units.mass = 1e-15;
  } else if (name == "nano") {
    units.length = units.time = 1e-9;
    units.mass = 1e-21;
  }
  return units;
}

SeenFile read_lammps_dump(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  return Dump(lines, problems, options).read();
}

}  // namespace repose
