// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// Writes one HDF5 file: under a temporary name until `commit` flushes it to the disk and renames it, so that nobody
/// ever meets half a file, and sealed (io/seal.hpp), so that damage shows. Every call throws RunError with the system's
/// reason if it fails.
class Hdf5File {
 public:
  /// With `units`, "reduced" or "SI", each group says them, and datasets have their units in m, kg and s for "SI".
  explicit Hdf5File(std::string path, std::string units = "");
  /// Without a commit nothing is left behind.
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Makes a group unless it exists; the one around it must exist.
  void group(const std::string& name);
  void attribute(const std::string& object, const std::string& name, const std::string& value);
  void attribute(const std::string& object, const std::string& name, std::int64_t value);
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, const std::vector<double>& values);

  /// Datasets of shape (n) or (n, columns), with their unit and meaning as attributes.
  template <class T>
  void dataset(const std::string& name, const std::vector<T>& values, std::size_t columns, std::string_view unit,
               std::string_view meaning);

  /// The next dataset gets so many rows from several calls of `dataset` or `table`, each of which adds rows.
  void expect_blocks(std::size_t rows) { expected_ = rows; }

  /// A dataset of shape (n, columns), even of one column.
  void table(const std::string& name, const std::vector<double>& values, std::size_t columns, std::string_view unit,
             std::string_view meaning);

  /// A dataset of shape (n) of text.
  void texts(const std::string& name, const std::vector<std::string>& values, std::string_view meaning);

  /// Bytes as they are in memory, of `count` items; groups on the way are made.
  void bytes(const std::string& name, std::size_t item, std::size_t count, const void* data);

  /// A link to an object of another file, by a path relative to this file.
  void external_link(const std::string& name, const std::string& file, const std::string& object);

  void commit();

 private:
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, std::size_t columns, int rank,
             std::string_view unit, std::string_view meaning);
  void create(const std::string& name, std::int64_t type, std::size_t rows, std::size_t columns, int rank);
  [[noreturn]] void fail() const;

  std::string path_;
  std::string units_;
  std::string temporary_;
  std::int64_t file_ = -1;
  std::optional<std::size_t> expected_;  // rows of the dataset that is written in blocks
  std::size_t written_ = 0;              // of these rows
};

/// Makes `text` the content of a file, all or nothing, flushed to the disk.
void write_text_file(const std::string& path, const std::string& text);

}  // namespace repose
