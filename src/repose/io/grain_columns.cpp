// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace repose {

namespace {

constexpr bool own = true;

struct Known {
  std::string_view name;  // as plain_name() makes it
  GrainColumn column;
  bool own_name = false;
};
/// Names of Repose, of its own exports, of ParaView (Points:0), OVITO (Position.X), PFC (pos-x) and of habit.
constexpr Known known_columns[] = {
    {"x", GrainColumn::x, own},
    {"positionx", GrainColumn::x, own},
    {"y", GrainColumn::y, own},
    {"positiony", GrainColumn::y, own},
    {"z", GrainColumn::z, own},
    {"positionz", GrainColumn::z, own},
    {"vx", GrainColumn::vx, own},
    {"velocityx", GrainColumn::vx, own},
    {"vy", GrainColumn::vy, own},
    {"velocityy", GrainColumn::vy, own},
    {"vz", GrainColumn::vz, own},
    {"velocityz", GrainColumn::vz, own},
    {"spin", GrainColumn::spin_z, own},
    {"radius", GrainColumn::radius, own},
    {"diameter", GrainColumn::diameter, own},
    {"mass", GrainColumn::mass, own},
    {"id", GrainColumn::id, own},
    {"material", GrainColumn::material, own},
    {"fixed", GrainColumn::fixed, own},
    {"base", GrainColumn::base, own},
    {"posx", GrainColumn::x},
    {"xpos", GrainColumn::x},
    {"xposition", GrainColumn::x},
    {"position0", GrainColumn::x},
    {"points0", GrainColumn::x},
    {"coordinatesx", GrainColumn::x},
    {"coordx", GrainColumn::x},
    {"xcoord", GrainColumn::x},
    {"xcoordinate", GrainColumn::x},
    {"centerx", GrainColumn::x},
    {"centrex", GrainColumn::x},
    {"xcenter", GrainColumn::x},
    {"xcentre", GrainColumn::x},
    {"xc", GrainColumn::x},
    {"posy", GrainColumn::y},
    {"ypos", GrainColumn::y},
    {"yposition", GrainColumn::y},
    {"position1", GrainColumn::y},
    {"points1", GrainColumn::y},
    {"coordinatesy", GrainColumn::y},
    {"coordy", GrainColumn::y},
    {"ycoord", GrainColumn::y},
    {"ycoordinate", GrainColumn::y},
    {"centery", GrainColumn::y},
    {"centrey", GrainColumn::y},
    {"ycenter", GrainColumn::y},
    {"ycentre", GrainColumn::y},
    {"yc", GrainColumn::y},
    {"posz", GrainColumn::z},
    {"zpos", GrainColumn::z},
    {"zposition", GrainColumn::z},
    {"position2", GrainColumn::z},
    {"points2", GrainColumn::z},
    {"coordinatesz", GrainColumn::z},
    {"coordz", GrainColumn::z},
    {"zcoord", GrainColumn::z},
    {"zcoordinate", GrainColumn::z},
    {"centerz", GrainColumn::z},
    {"centrez", GrainColumn::z},
    {"zcenter", GrainColumn::z},
    {"zcentre", GrainColumn::z},
    {"zc", GrainColumn::z},
    {"velx", GrainColumn::vx},
    {"xvel", GrainColumn::vx},
    {"xvelocity", GrainColumn::vx},
    {"velocity0", GrainColumn::vx},
    {"vel0", GrainColumn::vx},
    {"v0", GrainColumn::vx},
    {"vely", GrainColumn::vy},
    {"yvel", GrainColumn::vy},
    {"yvelocity", GrainColumn::vy},
    {"velocity1", GrainColumn::vy},
    {"vel1", GrainColumn::vy},
    {"v1", GrainColumn::vy},
    {"velz", GrainColumn::vz},
    {"zvel", GrainColumn::vz},
    {"zvelocity", GrainColumn::vz},
    {"velocity2", GrainColumn::vz},
    {"vel2", GrainColumn::vz},
    {"v2", GrainColumn::vz},
    {"omegax", GrainColumn::spin_x},
    {"omega0", GrainColumn::spin_x},
    {"angularvelocityx", GrainColumn::spin_x},
    {"spinx", GrainColumn::spin_x},
    {"spin0", GrainColumn::spin_x},
    {"wx", GrainColumn::spin_x},
    {"omegay", GrainColumn::spin_y},
    {"omega1", GrainColumn::spin_y},
    {"angularvelocityy", GrainColumn::spin_y},
    {"spiny", GrainColumn::spin_y},
    {"spin1", GrainColumn::spin_y},
    {"wy", GrainColumn::spin_y},
    {"omegaz", GrainColumn::spin_z},
    {"omega", GrainColumn::spin_z},
    {"omega2", GrainColumn::spin_z},
    {"angularvelocity", GrainColumn::spin_z},
    {"angularvelocityz", GrainColumn::spin_z},
    {"spinz", GrainColumn::spin_z},
    {"spin2", GrainColumn::spin_z},
    {"wz", GrainColumn::spin_z},
    {"r", GrainColumn::radius},
    {"rad", GrainColumn::radius},
    {"radii", GrainColumn::radius},
    {"particleradius", GrainColumn::radius},
    {"d", GrainColumn::diameter},
    {"dia", GrainColumn::diameter},
    {"diam", GrainColumn::diameter},
    {"particlediameter", GrainColumn::diameter},
    {"m", GrainColumn::mass},
    {"masses", GrainColumn::mass},
    {"particlemass", GrainColumn::mass},
    {"particleid", GrainColumn::id},
    {"particleidentifier", GrainColumn::id},
    {"grainid", GrainColumn::id},
    {"ballid", GrainColumn::id},
    {"matid", GrainColumn::material},
    {"type", GrainColumn::label},
    {"particletype", GrainColumn::label},
    {"species", GrainColumn::label},
    {"isfixed", GrainColumn::fixed},
};

constexpr std::int64_t most_materials = std::numeric_limits<std::uint16_t>::max();

bool is_type(GrainColumn column) {
  return column == GrainColumn::material || column == GrainColumn::type || column == GrainColumn::label;
}

}  // namespace

NamedColumn column_of(std::string_view name) {
  const auto find = [](const std::string& plain) {
    const auto* found = std::find_if(std::begin(known_columns), std::end(known_columns),
                                     [&](const auto& k) { return k.name == plain; });
    return found == std::end(known_columns) ? NamedColumn{} : NamedColumn{found->column, found->own_name};
  };
  auto found = find(plain_name(name));
  // "x_mm": the unit is a part of the name.
  const auto cut = name.rfind('_');
  if (found.column == GrainColumn::none && cut != std::string_view::npos && is_unit(name.substr(cut + 1))) {
    found = find(plain_name(name.substr(0, cut)));
  }
  return found;
}

GrainColumn in_plane(GrainColumn column, Plane plane) {
  constexpr std::array<std::array<GrainColumn, 3>, 3> vectors{
      {{GrainColumn::x, GrainColumn::y, GrainColumn::z},
       {GrainColumn::vx, GrainColumn::vy, GrainColumn::vz},
       {GrainColumn::spin_x, GrainColumn::spin_y, GrainColumn::spin_z}}};
  constexpr std::array<std::array<std::size_t, 3>, 3> axes{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};  // of xy, xz, yz
  const auto& order = axes[static_cast<std::size_t>(plane)];
  for (const auto& vector : vectors) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (vector[order[k]] == column) return vector[k];
    }
  }
  return column;
}

std::array<std::string, 3> axes_of(Plane plane) {
  switch (plane) {
    case Plane::xz:
      return {"x", "z", "y"};
    case Plane::yz:
      return {"y", "z", "x"};
    default:
      return {"x", "y", "z"};
  }
}

GrainLines::GrainLines(FileProblems& problems, std::vector<Column> columns, const ReaderOptions& options,
                       std::array<Scaling, 3> scaling)
    : problems_(problems), columns_(std::move(columns)), downward_spin_(options.plane == Plane::xz), scaling_(scaling) {
  for (auto& column : columns_) {
    column.column = in_plane(column.column, options.plane);
    const bool across = column.column == GrainColumn::vz || column.column == GrainColumn::spin_x ||
                        column.column == GrainColumn::spin_y;
    if (across && !options.in_space) column.column = GrainColumn::none;
    auto& list = column.column == GrainColumn::none ? left_out_ : used_;
    if (std::find(list.begin(), list.end(), column.name) == list.end()) list.push_back(column.name);
  }
}

void GrainLines::read(std::size_t line, const std::vector<std::string_view>& cells) {
  if (cells.size() != columns_.size()) {
    return problems_.add(line, fmt::format("has {} values; must have {}", cells.size(), columns_.size()));
  }
  SeenRow row;
  row.line = line;
  density_ = 0.0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!set(row, k, line, cells[k])) return;
  }
  if (row.base && !row.fixed) return problems_.add(line, "base = 1: a base grain must be fixed");
  if (density_ > 0.0)
    row.mass = density_ * (4.0 / 3.0 * 3.14159265358979323846) * (row.radius * row.radius * row.radius);
  rows_.push_back(row);
}

bool GrainLines::refuse(std::size_t column, std::size_t line, std::string_view cell, const std::string& allowed) {
  problems_.add(line, fmt::format("{} = {}: must be {}", columns_[column].name, shown(cell), allowed));
  return false;
}

/// A word is the name of a type, if the first one was a word too.
bool GrainLines::set_type(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell) {
  const auto what = columns_[column].column;
  const auto number = integer_of(cell);
  if (!named_types_) named_types_ = !number && !number_of(cell) && !cell.empty();
  if (*named_types_) {
    if (cell.empty()) return refuse(column, line, cell, "a word");
    auto found = std::find(types_.begin(), types_.end(), cell);
    if (found == types_.end()) {
      constexpr std::size_t most_names = 64;
      if (types_.size() == most_names) return refuse(column, line, cell, fmt::format("one of {} names", most_names));
      found = types_.insert(types_.end(), std::string(cell));
    }
    row.material = static_cast<std::uint16_t>(found - types_.begin());
    row.type = row.material + 1;
    return true;
  }
  const std::int64_t first = what == GrainColumn::type ? 1 : 0;
  if (!number || *number < first || *number - first > most_materials) {
    return refuse(column, line, cell, fmt::format("a whole number from {} to {}", first, first + most_materials));
  }
  labels_ |= what == GrainColumn::label;
  row.type = *number;
  row.material = static_cast<std::uint16_t>(*number - first);
  return true;
}

bool GrainLines::set_number(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell) {
  const auto what = columns_[column].column;
  const auto number = number_of(cell);
  if (!number) return refuse(column, line, cell, "a finite number");
  const double value = columns_[column].factor == 1.0 ? *number : *number * columns_[column].factor;
  const auto place = [&](std::size_t axis) { return scaling_[axis].origin + scaling_[axis].length * value; };
  switch (what) {
    case GrainColumn::x:
      row.position[0] = place(0);
      break;
    case GrainColumn::y:
      row.position[1] = place(1);
      break;
    case GrainColumn::z:
      row.position[2] = place(2);
      break;
    case GrainColumn::vx:
      row.velocity[0] = value;
      break;
    case GrainColumn::vy:
      row.velocity[1] = value;
      break;
    case GrainColumn::vz:
      row.velocity[2] = value;
      break;
    case GrainColumn::spin_x:
      row.spin[0] = value;
      break;
    case GrainColumn::spin_y:
      row.spin[1] = value;
      break;
    case GrainColumn::spin_z:
      row.spin[2] = downward_spin_ ? -value : value;
      break;
    case GrainColumn::radius:
    case GrainColumn::diameter:
      if (!(value > 0.0)) return refuse(column, line, cell, "> 0 [L]");
      row.radius = what == GrainColumn::radius ? value : 0.5 * value;
      break;
    case GrainColumn::mass:
      if (!(value > 0.0)) return refuse(column, line, cell, "> 0 [M]");
      row.mass = value;
      break;
    case GrainColumn::density:
      if (!(value > 0.0)) return refuse(column, line, cell, "> 0 [M/L^3]");
      density_ = value;
      break;
    default:
      break;
  }
  return true;
}

bool GrainLines::set(SeenRow& row, std::size_t column, std::size_t line, std::string_view cell) {
  const auto what = columns_[column].column;
  if (what == GrainColumn::none) return true;
  if (is_type(what)) return set_type(row, column, line, cell);
  if (what == GrainColumn::id) {
    row.id = integer_of(cell);
    return row.id ? true : refuse(column, line, cell, "a whole number");
  }
  if (what == GrainColumn::fixed || what == GrainColumn::base) {
    const auto truth = truth_of(cell);
    if (!truth) return refuse(column, line, cell, "0 or 1, true or false");
    (what == GrainColumn::fixed ? row.fixed : row.base) = *truth;
    return true;
  }
  return set_number(row, column, line, cell);
}

void GrainLines::sort_by_id() {
  if (std::exchange(sorted_, true) || rows_.empty() || !rows_.front().id) return;
  std::stable_sort(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  for (std::size_t k = 1; k < rows_.size(); ++k) {
    if (rows_[k].id != rows_[k - 1].id) continue;
    problems_.add(rows_[k].line, fmt::format("id = {}: is already in line {}", *rows_[k].id, rows_[k - 1].line));
  }
}

/// Labels count from 1, unless one is 0.
void GrainLines::count_labels() {
  if (!labels_) return;
  const bool from_zero = std::any_of(rows_.begin(), rows_.end(), [](const auto& row) { return row.type == 0; });
  for (auto& row : rows_) row.material = static_cast<std::uint16_t>(row.type - (from_zero ? 0 : 1));
}

SeenRow* GrainLines::find(std::int64_t id) {
  sort_by_id();
  const auto found = std::lower_bound(rows_.begin(), rows_.end(), id,
                                      [](const auto& row, std::int64_t wanted) { return row.id < wanted; });
  return found != rows_.end() && found->id == id ? &*found : nullptr;
}

void GrainLines::take(SeenFile& into) {
  sort_by_id();
  problems_.check();
  if (rows_.empty()) problems_.stop_without_line("no grains");
  count_labels();
  into.grains = std::move(rows_);
  into.types = std::move(types_);
  into.used = std::move(used_);
  into.left_out = std::move(left_out_);
}

void read_rows(TextLines& lines, std::int64_t count, FileProblems& problems, GrainLines& into) {
  std::string text;
  std::vector<std::string_view> cells;
  for (std::int64_t k = 0; k < count; ++k) {
    if (!lines.next(text)) {
      problems.stop(lines.number(), fmt::format("the file ends after {} of {} grains", k, count));
    }
    split(text, blanks, cells);
    into.read(lines.number(), cells);
  }
}

}  // namespace repose
