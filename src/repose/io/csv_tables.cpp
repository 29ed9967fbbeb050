// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/csv_tables.hpp"

#include "repose/io/whole_file.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace repose {

namespace {

using Values = Hdf5Reader::Values;

/// A column of a table: some values of a dataset, `stride` apart and each for `repeat` rows, over again at the end.
struct CsvColumn {
  std::string name;
  const Values* values = nullptr;
  std::size_t first = 0;
  std::size_t stride = 1;
  std::size_t repeat = 1;
  std::size_t period = 1;  ///< rows until it begins again
};

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? std::string("\"\"") : std::string(1, c);
  return all + '"';
}

/// A name of a column; a wall may be called anything.
std::string as_cell(const std::string& name) {
  return name.find_first_of(",;\"\t \n") == std::string::npos ? name : quoted(on_one_line(name));
}

void print_cell(WholeFile& file, const CsvColumn& column, std::size_t row) {
  const auto place = column.first + column.stride * (row % column.period / column.repeat);
  std::visit(
      [&](const auto& values) {
        if constexpr (std::is_same_v<std::decay_t<decltype(values[0])>, std::string>) {
          file.print("{}", quoted(values[place]));
        } else {
          file.print("{}", values[place]);
        }
      },
      *column.values);
}

/// What the columns of a dataset of several are called behind its name: walls by theirs, those of a vector x, y and z,
/// two ids first and second, others by number, as the slices of a column.
std::vector<std::string> column_names(const Hdf5Reader& file, const std::string& group, const Values& values,
                                      std::size_t width) {
  if (group == "series" && file.has("walls/name")) {
    if (auto walls = file.texts("walls/name"); walls.size() == width) return walls;
  }
  if (width == 2 && std::holds_alternative<std::vector<std::int64_t>>(values)) return {"first", "second"};
  if (width == 2) return {"x", "y"};
  if (width == 3 && group != "column") return {"x", "y", "z"};
  std::vector<std::string> names;
  for (std::size_t k = 0; k < width; ++k) names.push_back(fmt::format("{}", k));
  return names;
}

void print_notes(WholeFile& file, const Hdf5Reader& source, const CsvTable& table) {
  file.print("# {} of {}\n", table.group, std::filesystem::path(source.path()).filename().string());
  for (const auto& [name, value] : source.attributes(table.group)) {
    file.print("# {} = {}\n", name, on_one_line(value));
  }
  auto described = table.datasets;
  if (table.grid) described.insert(described.begin(), table.axes.begin(), table.axes.end());
  for (const auto& name : described) {
    const auto path = table.group + "/" + name;
    const auto unit = source.text_or(path, "unit", "");
    const auto meaning = source.text_or(path, "meaning", "");
    file.print("# {}:{}{}\n", name, unit.empty() ? "" : " [" + unit + "]", meaning.empty() ? "" : " " + meaning);
  }
}

/// What the rest is a function of goes first.
void put_arguments_first(std::vector<std::string>& datasets) {
  auto next = datasets.begin();
  for (const auto* name : {"id", "distance", "wave_number", "direction_deg", "time", "start", "end", "x", "y", "f"}) {
    const auto found = std::find(next, datasets.end(), name);
    if (found != datasets.end()) std::rotate(next++, found, found + 1);
  }
}

std::optional<CsvTable> grid_of(const Hdf5Reader& file, const std::string& group,
                                const std::vector<std::string>& names) {
  const std::array<std::array<std::string, 2>, 2> known{{{"x", "y"}, {"r", "z"}}};
  for (const auto& axes : known) {
    const auto first = file.shape(group + "/" + axes[0]);
    const auto second = file.shape(group + "/" + axes[1]);
    if (first.size() != 1 || second.size() != 1) continue;
    CsvTable table{group, group, {}, true, axes};
    for (const auto& name : names) {
      if (file.shape(group + "/" + name) == std::vector<std::size_t>{second[0], first[0]})
        table.datasets.push_back(name);
    }
    if (!table.datasets.empty()) return table;
  }
  return std::nullopt;
}

}  // namespace

std::vector<CsvTable> csv_tables(const Hdf5Reader& file) {
  std::vector<CsvTable> tables;
  for (const auto& group : file.groups()) {
    const auto names = file.names_in(group);
    const auto grid = grid_of(file, group, names);
    if (grid) tables.push_back(*grid);
    const auto in_grid = [&](const std::string& name) {
      const auto& taken = grid->datasets;
      return name == grid->axes[0] || name == grid->axes[1] ||
             std::find(taken.begin(), taken.end(), name) != taken.end();
    };
    std::map<std::size_t, CsvTable> by_length;
    for (const auto& name : names) {
      const auto shape = file.shape(group + "/" + name);
      if (shape.empty() || shape.size() > 2 || (grid && in_grid(name))) continue;
      auto& table = by_length[shape[0]];
      table.group = group;
      table.datasets.push_back(name);
    }
    std::vector<CsvTable> found;
    for (auto& [length, table] : by_length) found.push_back(std::move(table));
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.datasets.size() != b.datasets.size() ? a.datasets.size() > b.datasets.size() : a.datasets < b.datasets;
    });
    for (auto& table : found) {
      const bool main = !grid && &table == &found.front();
      table.name = main ? group : group + "_" + table.datasets.front();
      std::replace(table.name.begin(), table.name.end(), '/', '_');
      put_arguments_first(table.datasets);
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

void write_csv(const std::string& path, const Hdf5Reader& file, const CsvTable& table) {
  std::map<std::string, Values> values;  // by dataset; its places stay where they are
  std::vector<CsvColumn> columns;
  std::size_t rows = 0;
  if (table.grid) {
    const auto& [first, second] = table.axes;
    const auto places = file.shape(table.group + "/" + first)[0];
    rows = places * file.shape(table.group + "/" + second)[0];
    columns.push_back({first, &(values[first] = file.values(table.group + "/" + first)), 0, 1, 1, places});
    columns.push_back({second, &(values[second] = file.values(table.group + "/" + second)), 0, 1, places, rows});
    for (const auto& name : table.datasets) {
      columns.push_back({name, &(values[name] = file.values(table.group + "/" + name)), 0, 1, 1, rows});
    }
  } else {
    rows = file.shape(table.group + "/" + table.datasets.front())[0];
    for (const auto& name : table.datasets) {
      const auto& of_dataset = values[name] = file.values(table.group + "/" + name);
      const auto shape = file.shape(table.group + "/" + name);
      if (shape.size() == 1) {
        columns.push_back({name, &of_dataset, 0, 1, 1, rows});
        continue;
      }
      const auto parts = column_names(file, table.group, of_dataset, shape[1]);
      for (std::size_t c = 0; c < shape[1]; ++c) {
        columns.push_back({name + "_" + parts[c], &of_dataset, c, shape[1], 1, rows});
      }
    }
  }
  WholeFile out(path);
  print_notes(out, file, table);
  for (const auto& column : columns) out.print("{}{}", &column == &columns.front() ? "" : ",", as_cell(column.name));
  out.print("\n");
  for (std::size_t row = 0; row < rows; ++row) {
    for (const auto& column : columns) {
      if (&column != &columns.front()) out.print(",");
      print_cell(out, column, row);
    }
    out.print("\n");
  }
  out.commit();
}

}  // namespace repose
