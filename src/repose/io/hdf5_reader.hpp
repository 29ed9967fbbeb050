// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace repose {

/// Whether a file must be sealed. Files that other programs may write have no seal.
enum class Sealing { mandatory, optional };

/// Reads one HDF5 file after checking its seal. Links to other files are not checked: open those files instead. Every
/// call throws InputError, one line with the file and the object, if something is missing, damaged or of another type.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(std::string path, Sealing sealing = Sealing::mandatory);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  const std::string& path() const { return path_; }
  /// Whether an object lies in the file itself, not behind a link to another one.
  bool has(const std::string& name) const;
  std::string text(const std::string& object, const std::string& attribute) const;
  double number(const std::string& object, const std::string& attribute) const;
  std::int64_t integer(const std::string& object, const std::string& attribute) const;

  /// All values of a dataset of shape (n) or (n, columns), row by row.
  template <class T>
  std::vector<T> dataset(const std::string& name, std::size_t columns = 1) const;

  /// The texts written by Hdf5File::texts.
  std::vector<std::string> texts(const std::string& name) const;

  /// Reads the bytes written by Hdf5File::bytes, as items of `item` bytes, into the memory that room(count) returns;
  /// null refuses the count.
  void bytes(const std::string& name, std::size_t item, const std::function<void*(std::size_t count)>& room) const;

  /// All values of a dataset of shape (n, columns), also for one column, row by row.
  template <class T>
  std::vector<T> table(const std::string& name, std::size_t columns) const;

  /// The shape of a dataset; empty for anything else.
  std::vector<std::size_t> shape(const std::string& name) const;

  /// The values of a dataset of any shape, row by row, in its own type.
  using Values =
      std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::string>>;
  Values values(const std::string& name) const;

  /// The attributes of an object that are a single number or text, as text, in ascending order of their names.
  std::vector<std::pair<std::string, std::string>> attributes(const std::string& object) const;

  /// A text attribute, or `otherwise` if it does not exist.
  std::string text_or(const std::string& object, const std::string& attribute, const std::string& otherwise) const;

  /// The paths of the groups in the file itself, not behind links. A group precedes the groups in it.
  std::vector<std::string> groups() const;

  /// The names of the objects in a group, ascending.
  std::vector<std::string> names_in(const std::string& group) const;

 private:
  void add_groups(const std::string& prefix, std::vector<std::string>& found) const;

  template <class T>
  std::vector<T> read(const std::string& name, std::size_t columns, int rank) const;
  [[noreturn]] void fail(const std::string& object, const std::string& what) const;

  std::string path_;
  std::int64_t file_ = -1;
};

}  // namespace repose
