// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <istream>

namespace repose {

namespace {

struct Name {
  const char* name;
  GrainColumn column;
};
constexpr Name names[] = {
    {"id", GrainColumn::id},         {"type", GrainColumn::type},
    {"z", GrainColumn::z},           {"vx", GrainColumn::vx},
    {"vy", GrainColumn::vy},         {"omegaz", GrainColumn::spin},
    {"radius", GrainColumn::radius}, {"diameter", GrainColumn::diameter},
    {"mass", GrainColumn::mass},     {"fixed", GrainColumn::fixed},
    {"base", GrainColumn::base},
};

/// The columns of a position, the most exact first. Scaled positions are fractions of the box.
struct Position {
  const char* x;
  const char* y;
  bool scaled;
};
constexpr Position positions[] = {{"x", "y", false}, {"xu", "yu", false}, {"xs", "ys", true}, {"xsu", "ysu", true}};

void split(std::string_view line, std::vector<std::string_view>& cells) {
  constexpr const char* blanks = " \t\r";
  cells.clear();
  for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(blanks, begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
}

/// Reads a dump item by item.
class Dump {
 public:
  Dump(std::istream& file, FileProblems& problems, std::int64_t wanted)
      : file_(file), problems_(problems), wanted_(wanted) {}

  std::vector<GrainRow> read() {
    while (next()) read_item(false);
    if (!started_) problems_.stop(1, "no snapshot: no ITEM: TIMESTEP");
    if (!complete_ && (wanted_ == last_snapshot || !start_))
      problems_.stop(line_, "the file ends in the middle of a snapshot");
    if (!start_) problems_.stop(line_, fmt::format("no snapshot of step {}; the last is of step {}", wanted_, step_));
    file_.clear();
    file_.seekg(start_->position);
    line_ = start_->line;
    started_ = false;
    while (!grains_ && next()) read_item(true);
    return grains_->take();
  }

 private:
  bool next() {
    before_ = file_.tellg();
    if (!std::getline(file_, text_)) return false;
    ++line_;
    split(text_, cells_);
    return true;
  }

  void demand_next(const char* of) {
    if (!next()) problems_.stop(line_, fmt::format("the file ends in the middle of {}", of));
  }

  bool is(std::initializer_list<const char*> words) const {
    return cells_.size() > words.size() && std::equal(words.begin(), words.end(), cells_.begin() + 1);
  }

  void read_item(bool keep) {
    if (cells_.empty()) return;
    if (cells_.front() != "ITEM:") problems_.stop(line_, "must be an ITEM: of a LAMMPS text dump");
    if (is({"TIMESTEP"})) {
      if (started_ && !complete_) problems_.stop(line_, "a snapshot begins before the one above has its ITEM: ATOMS");
      const Start here{before_, line_ - 1};
      started_ = true;
      complete_ = false;
      count_.reset();
      demand_next("a snapshot");
      const auto step = cells_.size() == 1 ? integer_of(cells_.front()) : std::nullopt;
      if (!step) problems_.stop(line_, "must be the number of a step");
      step_ = *step;
      if (wanted_ == last_snapshot || step_ == wanted_) start_ = here;
    } else if (is({"TIME"}) || is({"UNITS"})) {
      demand_next("a snapshot");
    } else if (is({"NUMBER", "OF", "ATOMS"})) {
      demand_next("a snapshot");
      count_ = cells_.size() == 1 ? integer_of(cells_.front()) : std::nullopt;
      if (!count_ || *count_ < 0) problems_.stop(line_, "must be the number of atoms");
    } else if (is({"BOX", "BOUNDS"})) {
      read_box();
    } else if (is({"ATOMS"})) {
      read_atoms(keep);
    } else if (is({"ENTRIES"}) || is({"NUMBER", "OF", "ENTRIES"})) {
      problems_.stop(line_, "is a dump of contacts (local), not of grains");
    } else {
      problems_.stop(line_, "is an unknown ITEM: of a LAMMPS text dump");
    }
  }

  void read_box() {
    tilted_ = std::find(cells_.begin(), cells_.end(), "xy") != cells_.end() ||
              std::find(cells_.begin(), cells_.end(), "abc") != cells_.end();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      demand_next("ITEM: BOX BOUNDS");
      const auto low = cells_.size() >= 2 ? number_of(cells_[0]) : std::nullopt;
      const auto high = cells_.size() >= 2 ? number_of(cells_[1]) : std::nullopt;
      if (!low || !high) problems_.stop(line_, "must be the bounds of the box");
      if (axis < 2) box_[axis] = {*low, *high - *low};
    }
  }

  void read_atoms(bool keep) {
    if (!started_ || !count_) problems_.stop(line_, "ITEM: TIMESTEP and ITEM: NUMBER OF ATOMS must come before");
    if (keep) begin_grains();
    for (std::int64_t k = 0; k < *count_; ++k) {
      if (!next()) problems_.stop(line_, fmt::format("the file ends after {} of {} grains", k, *count_));
      if (keep) grains_->read(line_, cells_);
    }
    complete_ = true;
  }

  void begin_grains() {
    const std::vector<std::string> given(cells_.begin() + 2, cells_.end());
    const auto has = [&](const char* name) { return std::find(given.begin(), given.end(), name) != given.end(); };
    const auto* position =
        std::find_if(std::begin(positions), std::end(positions), [&](const auto& p) { return has(p.x) && has(p.y); });
    if (position == std::end(positions) || (!has("radius") && !has("diameter"))) {
      problems_.stop(line_, "must have the columns x y (or xu yu, xs ys, xsu ysu) and radius or diameter");
    }
    if (position->scaled && tilted_) problems_.stop(line_, "scaled positions in a tilted box: dump x y or xu yu");
    std::vector<GrainColumn> columns;
    for (const auto& name : given) {
      auto column = GrainColumn::none;  // a column for other programs
      if (name == position->x) column = GrainColumn::x;
      if (name == position->y) column = GrainColumn::y;
      for (const auto& known : names) {
        if (name == known.name) column = known.column;
      }
      if (column == GrainColumn::diameter && has("radius")) column = GrainColumn::none;
      columns.push_back(column);
    }
    grains_.emplace(problems_, columns, given, position->scaled ? box_ : std::array<Scaling, 2>{});
  }

  struct Start {
    std::istream::pos_type position;
    std::size_t line;
  };

  std::istream& file_;
  FileProblems& problems_;
  std::istream::pos_type before_;  // start of the current line
  std::string text_;
  std::vector<std::string_view> cells_;  // of the current line
  std::size_t line_ = 0;
  std::int64_t wanted_;
  std::int64_t step_ = 0;       // step of the latest snapshot
  std::optional<Start> start_;  // start of the wanted snapshot
  bool started_ = false;
  bool complete_ = false;
  std::optional<std::int64_t> count_;
  bool tilted_ = false;
  std::array<Scaling, 2> box_{};
  std::optional<GrainLines> grains_;
};

}  // namespace

std::vector<GrainRow> read_lammps_dump(std::istream& file, FileProblems& problems, std::int64_t step) {
  return Dump(file, problems, step).read();
}

}  // namespace repose
