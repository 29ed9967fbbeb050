// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace repose {

/// The problems of one file: one line "file:line: problem" for each of the first 20, then the number of the rest.
class FileProblems {
 public:
  explicit FileProblems(std::string path) : path_(std::move(path)) {}

  void add(std::size_t line, const std::string& what);
  /// Throws InputError with all problems so far.
  [[noreturn]] void stop() const;
  [[noreturn]] void stop(std::size_t line, const std::string& what) {
    add(line, what);
    stop();
  }
  /// Throws InputError with one problem of the file as a whole.
  [[noreturn]] void stop_without_line(const std::string& what) const;
  /// Throws InputError if there are any.
  void check() const {
    if (count_ > 0) stop();
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

}  // namespace repose
