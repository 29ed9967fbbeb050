// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <utility>

namespace repose {

namespace {

constexpr std::size_t flat_head = 6;   // number of grains, time, x_min, y_min, x_max, y_max
constexpr std::size_t solid_head = 8;  // the same with z

std::vector<GrainLines::Column> columns_of(std::size_t head) {
  if (head == flat_head) {
    return {{GrainColumn::x, "x"},          {GrainColumn::y, "y"},           {GrainColumn::vx, "vx"},
            {GrainColumn::vy, "vy"},        {GrainColumn::radius, "radius"}, {GrainColumn::none, "angle"},
            {GrainColumn::spin_z, "omega"}, {GrainColumn::none, "info"}};
  }
  return {{GrainColumn::x, "x"},
          {GrainColumn::y, "y"},
          {GrainColumn::z, "z"},
          {GrainColumn::vx, "vx"},
          {GrainColumn::vy, "vy"},
          {GrainColumn::vz, "vz"},
          {GrainColumn::radius, "radius"},
          {GrainColumn::none, "angle_x"},
          {GrainColumn::none, "angle_y"},
          {GrainColumn::none, "angle_z"},
          {GrainColumn::spin_x, "omega_x"},
          {GrainColumn::spin_y, "omega_y"},
          {GrainColumn::spin_z, "omega_z"},
          {GrainColumn::none, "info"}};
}

}  // namespace

/// Each snapshot begins with a line of the number of grains, the time and the bounds of the box. The last one counts,
/// or that of a number, from 0.
SeenFile read_mercury_data(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  std::string text;
  std::vector<std::string_view> cells;
  std::optional<std::size_t> wanted;  // line of its head
  std::int64_t number = 0;
  std::int64_t frames = 0;
  while (lines.next(text)) {
    split(text, blanks, cells);
    if (cells.empty()) continue;
    const auto count = integer_of(cells.front());
    if ((cells.size() != flat_head && cells.size() != solid_head) || !count || *count < 0) {
      problems.stop(lines.number(),
                    "must be the head of a snapshot of MercuryDPM: number of grains, time, bounds of the box");
    }
    if (options.step == last_snapshot || options.step == frames) {
      wanted = lines.number();
      number = frames;
    }
    ++frames;
    for (std::int64_t k = 0; k < *count; ++k) {
      if (!lines.next(text))
        problems.stop(lines.number(), fmt::format("the file ends after {} of {} grains", k, *count));
    }
  }
  if (!wanted) {
    problems.stop(lines.number(), fmt::format("no snapshot {}; the last is number {}", options.step, frames - 1));
  }
  lines.rewind();
  while (lines.number() < *wanted) lines.next(text);
  split(text, blanks, cells);
  const auto head = cells.size();
  if (head == flat_head && options.plane != Plane::xy) {
    problems.stop(*wanted, "is in two dimensions: start.plane must be xy");
  }
  if (head == flat_head && options.in_space) problems.stop(*wanted, "is in two dimensions; spheres need three");
  SeenBox box;
  for (std::size_t k = 0; k < options.axes(); ++k) {
    const auto axis = static_cast<std::size_t>(axes_of(options.plane)[k][0] - 'x');
    const auto low = number_of(cells[2 + axis]);
    const auto high = number_of(cells[2 + axis + (head - 2) / 2]);
    if (!low || !high) problems.stop(*wanted, "must have the bounds of the box");
    box.low[static_cast<int>(k)] = *low;
    box.high[static_cast<int>(k)] = *high;
  }
  SeenFile file;
  file.format = fmt::format(".data file of MercuryDPM in {} dimensions", head == flat_head ? 2 : 3);
  file.box = box;
  file.snapshot = number;
  file.snapshots = static_cast<std::size_t>(frames);
  const auto count = *integer_of(cells.front());
  GrainLines grains(problems, columns_of(head), options);
  read_rows(lines, count, problems, grains);
  grains.take(file);
  return file;
}

}  // namespace repose
