// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace repose {

/// Flushes a finished temporary file to the disk and renames it to `path`. Throws RunError.
void publish(const std::string& temporary, const std::string& path);

/// For this many seconds from now, this process publishes files without flushing them. Such files survive the end of
/// the process, also by a kill, but perhaps not a crash of the machine.
void publish_without_flush_for(double seconds);

/// Writes a file under a temporary name. `commit` flushes it to the disk and renames it, so that no reader ever sees an
/// incomplete file. Throws RunError with the system's reason if writing fails.
class WholeFile {
 public:
  explicit WholeFile(std::string path);
  /// Removes the temporary file if it was not committed.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view bytes);
  template <class... T>
  void print(fmt::format_string<T...> format, const T&... values) {
    fmt::vformat_to(std::back_inserter(buffer_), format, fmt::make_format_args(values...));
    if (buffer_.size() >= buffer_size) write_buffer();
  }
  void commit();

 private:
  static constexpr std::size_t buffer_size = 1U << 20;
  void write_buffer();
  [[noreturn]] void fail();

  std::string path_;
  std::string temporary_;
  std::string buffer_;  // printed text that is not yet written
  std::ofstream file_;
};

}  // namespace repose
