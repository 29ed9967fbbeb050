// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grains_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace repose {

namespace {

/// Whether the start of a file is binary: HDF5 files, LAMMPS binary dumps and compressed files have control bytes near
/// their start, text has none.
bool binary(std::string_view head) {
  return std::any_of(head.begin(), head.end(), [](char c) { return c == '\0' || c == '\x1f' || c == '\x1a'; });
}

}  // namespace

std::vector<GrainRow> read_grains_file(const std::string& path, std::int64_t step) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  if (file.bad() || (!file && !file.eof())) throw InputError(fmt::format("{}: cannot be read", path));
  if (binary(head)) {
    throw InputError(fmt::format("{}: is binary; must be a table of text or a LAMMPS text dump", path));
  }
  file.clear();
  file.seekg(0);
  FileProblems problems(path);
  const auto begin = head.find_first_not_of(" \t\r\n");
  const bool dump = begin != std::string::npos && head.compare(begin, 5, "ITEM:") == 0;
  if (dump) return read_lammps_dump(file, problems, step);
  if (step != last_snapshot) throw InputError(fmt::format("{}: is a table: it has no snapshot of step {}", path, step));
  return read_grains_table(file, problems);
}

}  // namespace repose
