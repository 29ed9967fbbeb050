// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace repose {

namespace {

constexpr std::size_t most_problems = 20;
constexpr std::int64_t most_materials = std::numeric_limits<std::uint16_t>::max();

/// A cell as shown in a message: cut, because a file of another kind may contain cells of any length.
std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  return cell.size() <= longest ? std::string(cell) : std::string(cell.substr(0, longest)) + "...";
}

template <class T>
std::optional<T> whole_cell(std::string_view cell) {
  if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

}  // namespace

void FileProblems::add(std::size_t line, const std::string& what) {
  if (++count_ <= most_problems) lines_.push_back(fmt::format("{}:{}: {}", path_, line, what));
}

void FileProblems::stop() const {
  auto lines = lines_;
  if (count_ > lines.size()) lines.push_back(fmt::format("{}: and {} more problems", path_, count_ - lines.size()));
  throw InputError(lines);
}

std::optional<double> number_of(std::string_view cell) {
  const auto value = whole_cell<double>(cell);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> integer_of(std::string_view cell) { return whole_cell<std::int64_t>(cell); }

GrainLines::GrainLines(FileProblems& problems, std::vector<GrainColumn> columns, std::vector<std::string> names,
                       std::array<Scaling, 2> scaling)
    : problems_(problems), columns_(std::move(columns)), names_(std::move(names)), scaling_(scaling) {}

void GrainLines::read(std::size_t line, const std::vector<std::string_view>& cells) {
  if (cells.size() != columns_.size()) {
    return problems_.add(line, fmt::format("has {} values; must have {}", cells.size(), columns_.size()));
  }
  GrainRow row;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!set(row, k, line, cells[k])) return;
  }
  if (row.base && !row.fixed) return problems_.add(line, "base = 1: a base grain must be fixed");
  rows_.push_back(row);
  if (row.id) lines_.push_back(line);
}

bool GrainLines::set(GrainRow& row, std::size_t column, std::size_t line, std::string_view cell) {
  const auto refuse = [&](const std::string& allowed) {
    problems_.add(line, fmt::format("{} = {}: must be {}", names_[column], shown(cell), allowed));
    return false;
  };
  const auto what = columns_[column];
  switch (what) {
    case GrainColumn::none:
      return true;
    case GrainColumn::id:
      row.id = integer_of(cell);
      return row.id ? true : refuse("a whole number");
    case GrainColumn::material:
    case GrainColumn::type: {
      const std::int64_t first = what == GrainColumn::type ? 1 : 0;
      const auto number = integer_of(cell);
      if (!number || *number < first || *number - first > most_materials) {
        return refuse(fmt::format("a whole number from {} to {}", first, first + most_materials));
      }
      row.material = static_cast<std::uint16_t>(*number - first);
      return true;
    }
    default:
      break;
  }
  const auto number = number_of(cell);
  if (!number) return refuse("a finite number");
  const double value = *number;
  switch (what) {
    case GrainColumn::x:
      row.position[0] = scaling_[0].origin + scaling_[0].length * value;
      break;
    case GrainColumn::y:
      row.position[1] = scaling_[1].origin + scaling_[1].length * value;
      break;
    case GrainColumn::z:
      if (!z_) z_ = value;
      if (value != *z_)
        return refuse(fmt::format("the same for all grains ({} before): they are discs in a plane", *z_));
      break;
    case GrainColumn::vx:
      row.velocity[0] = value;
      break;
    case GrainColumn::vy:
      row.velocity[1] = value;
      break;
    case GrainColumn::spin:
      row.spin = value;
      break;
    case GrainColumn::radius:
    case GrainColumn::diameter:
      if (!(value > 0.0)) return refuse("> 0 [L]");
      row.radius = what == GrainColumn::radius ? value : 0.5 * value;
      break;
    case GrainColumn::mass:
      if (!(value > 0.0)) return refuse("> 0 [M]");
      row.mass = value;
      break;
    case GrainColumn::fixed:
    case GrainColumn::base:
      if (value != 0.0 && value != 1.0) return refuse("0 or 1");
      (what == GrainColumn::fixed ? row.fixed : row.base) = value == 1.0;
      break;
    default:
      break;
  }
  return true;
}

void GrainLines::check_ids() {
  if (lines_.empty()) return;
  std::vector<std::size_t> order(rows_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rows_[a].id < rows_[b].id; });
  std::vector<GrainRow> sorted;
  sorted.reserve(rows_.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& row = rows_[order[k]];
    if (k > 0 && row.id == sorted.back().id) {
      problems_.add(lines_[order[k]], fmt::format("id = {}: is already in line {}", *row.id, lines_[order[k - 1]]));
    }
    sorted.push_back(row);
  }
  rows_.swap(sorted);
}

std::vector<GrainRow> GrainLines::take() {
  check_ids();
  problems_.check();
  if (rows_.empty()) throw InputError(fmt::format("{}: no grains", problems_.path()));
  return std::move(rows_);
}

}  // namespace repose
