// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace repose {

namespace {

/// Reads a data file of LAMMPS: a line of comment, a head ("100 atoms", "0 10 xlo xhi"), then sections under their
/// names.
class DataFile {
 public:
  DataFile(TextLines& lines, FileProblems& problems, const ReaderOptions& options)
      : lines_(lines), problems_(problems), options_(options) {}

  SeenFile read() {
    next();
    find_units();
    std::string section;
    std::string style;
    while (next()) {
      if (cells_.empty()) continue;
      if (!number_of(cells_.front())) {
        section = joined();
        style = comment_;
        if (section == "Atoms") {
          read_atoms(style);
          continue;
        }
        if (section == "Velocities") {
          read_velocities();
          continue;
        }
        continue;
      }
      if (section.empty()) read_head();
      if (section == "Atom Type Labels" && cells_.size() == 2) labels_[std::string(cells_[1])] = std::string(cells_[0]);
    }
    if (!grains_) problems_.stop_without_line("is a LAMMPS data file without a section Atoms");
    file_.format = "LAMMPS data file, atom_style sphere";
    if (box_given_) file_.box = box_;
    grains_->take(file_);
    return std::move(file_);
  }

 private:
  /// The next line, without its comment, in cells.
  bool next() {
    if (!lines_.next(text_)) return false;
    const auto sign = text_.find('#');
    comment_ = sign == std::string::npos ? "" : std::string(trimmed(std::string_view(text_).substr(sign + 1)));
    split(std::string_view(text_).substr(0, sign), blanks, cells_);
    return true;
  }

  std::string joined() const {
    std::string words;
    for (const auto& cell : cells_) words += (words.empty() ? "" : " ") + std::string(cell);
    return words;
  }

  /// write_data notes them in the first line: "..., units = si".
  void find_units() {
    constexpr std::string_view mark = "units = ";
    const auto at = text_.find(mark);
    if (at == std::string::npos) return;
    auto word = std::string_view(text_).substr(at + mark.size());
    word = word.substr(0, word.find_first_of(" ,\t"));
    file_.units = lammps_units(word);
  }

  void read_head() {
    const auto& cells = cells_;
    if (cells.size() == 2 && cells[1] == "atoms") count_ = integer_of(cells[0]);
    if (cells.size() != 4) return;
    const auto axes = axes_of(options_.plane);
    for (std::size_t k = 0; k < options_.axes(); ++k) {
      const auto& axis = axes[k];
      if (cells[2] != axis + "lo" || cells[3] != axis + "hi") continue;
      const auto low = number_of(cells[0]);
      const auto high = number_of(cells[1]);
      if (!low || !high) problems_.stop(lines_.number(), "must be the bounds of the box");
      box_.low[static_cast<int>(k)] = *low;
      box_.high[static_cast<int>(k)] = *high;
      box_given_ = true;
    }
  }

  /// Reads `count` lines below the name of a section and the empty line that follows it.
  template <class Use>
  void read_section(std::int64_t count, const Use& use) {
    std::int64_t read = 0;
    while (read < count) {
      if (!next()) {
        problems_.stop(lines_.number(), fmt::format("the file ends after {} of {} grains", read, count));
      }
      if (cells_.empty()) continue;
      use();
      ++read;
    }
  }

  /// id type diameter density x y z, perhaps with the images of the box behind.
  void read_atoms(const std::string& style) {
    const auto line = lines_.number();
    if (!count_ || *count_ < 0) problems_.stop(line, "the number of atoms must come before");
    if (!style.empty() && style != "sphere" && style != "granular") {
      problems_.stop(
          line, fmt::format("is of atom_style {}, which has no diameters; must be of atom_style sphere", shown(style)));
    }
    if (style.empty()) {
      file_.warnings.push_back(
          "the section Atoms does not tell its atom_style: read as sphere (id type diameter density "
          "x y z)");
    }
    read_section(*count_, [&] {
      if (!grains_) begin_grains();
      if (const auto label = labels_.find(std::string(cells_.size() > 1 ? cells_[1] : "")); label != labels_.end()) {
        cells_[1] = label->second;
      }
      grains_->read(lines_.number(), cells_);
    });
    if (!grains_) begin_grains();
  }

  void begin_grains() {
    std::vector<GrainLines::Column> columns{{GrainColumn::id, "id"},
                                            {GrainColumn::type, "type"},
                                            {GrainColumn::diameter, "diameter"},
                                            {GrainColumn::density, "density"},
                                            {GrainColumn::x, "x"},
                                            {GrainColumn::y, "y"},
                                            {GrainColumn::z, "z"}};
    constexpr std::size_t with_images = 10;
    if (cells_.size() == with_images) {
      for (const char* name : {"ix", "iy", "iz"}) columns.push_back({GrainColumn::none, name});
    }
    grains_.emplace(problems_, columns, options_);
  }

  /// id vx vy vz wx wy wz.
  void read_velocities() {
    if (!grains_ || !count_) problems_.stop(lines_.number(), "Velocities must follow Atoms");
    const auto axis = [&](std::size_t k) { return static_cast<std::size_t>(axes_of(options_.plane)[k][0] - 'x'); };
    read_section(*count_, [&] {
      constexpr std::size_t columns = 7;
      const auto id = cells_.empty() ? std::nullopt : integer_of(cells_[0]);
      auto* row = id ? grains_->find(*id) : nullptr;
      if (cells_.size() != columns || row == nullptr) {
        return problems_.add(lines_.number(), "must be the id of an atom, its velocity and its angular velocity");
      }
      std::array<double, columns - 1> values{};
      for (std::size_t k = 0; k < values.size(); ++k) {
        const auto value = number_of(cells_[k + 1]);
        if (!value)
          return problems_.add(lines_.number(), fmt::format("{}: must be a finite number", shown(cells_[k + 1])));
        values[k] = *value;
      }
      for (std::size_t k = 0; k < options_.axes(); ++k) row->velocity[static_cast<int>(k)] = values[axis(k)];
      if (options_.in_space) return void(row->spin = {{values[3], values[4], values[5]}});
      const double spin = values[3 + axis(2)];
      row->spin[2] = options_.plane == Plane::xz ? -spin : spin;
    });
  }

  TextLines& lines_;
  FileProblems& problems_;
  SeenFile file_;
  ReaderOptions options_;
  std::string text_;
  std::string comment_;
  std::vector<std::string_view> cells_;
  std::optional<std::int64_t> count_;
  SeenBox box_;
  bool box_given_ = false;
  std::map<std::string, std::string> labels_;  // of types: their numbers
  std::optional<GrainLines> grains_;
};

}  // namespace

SeenFile read_lammps_data(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  return DataFile(lines, problems, options).read();
}

}  // namespace repose
