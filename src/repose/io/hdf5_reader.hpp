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

/// What a reader asks of a file: files that other programs write, too, have no seal.
enum class Sealing { must_be_there, may_be_missing };

/// Reads one HDF5 file of ours whose seal is whole. What links lead to in other files is not looked at: open these.
/// Every call throws InputError, one line with the file and the object, where something is missing, damaged or of
/// another type.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(std::string path, Sealing sealing = Sealing::must_be_there);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  const std::string& path() const { return path_; }
  bool has(const std::string& name) const;
  std::string text(const std::string& object, const std::string& attribute) const;
  double number(const std::string& object, const std::string& attribute) const;
  std::int64_t integer(const std::string& object, const std::string& attribute) const;

  /// All values of a dataset of shape (n) or (n, columns), row by row.
  template <class T>
  std::vector<T> dataset(const std::string& name, std::size_t columns = 1) const;

  /// Text that Hdf5File::texts wrote.
  std::vector<std::string> texts(const std::string& name) const;

  /// Bytes that Hdf5File::bytes wrote, of items of this size, into the room that is made for them; null: no room.
  void bytes(const std::string& name, std::size_t item, const std::function<void*(std::size_t count)>& room) const;

  /// The same of a dataset that has two dimensions even with one column.
  template <class T>
  std::vector<T> table(const std::string& name, std::size_t columns) const;

  /// The shape of a dataset; empty for anything else.
  std::vector<std::size_t> shape(const std::string& name) const;

  /// The values of a dataset of any shape, row by row, as what they are.
  using Values =
      std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::string>>;
  Values values(const std::string& name) const;

  /// The attributes of an object that are one number or text, ascending by name, as text.
  std::vector<std::pair<std::string, std::string>> attributes(const std::string& object) const;

  /// A text attribute, or `otherwise` where there is none.
  std::string text_or(const std::string& object, const std::string& attribute, const std::string& otherwise) const;

  /// Paths of the groups that lie in the file itself, not behind links, each before those in it.
  std::vector<std::string> groups() const;

  /// Names of the objects in a group, ascending.
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
