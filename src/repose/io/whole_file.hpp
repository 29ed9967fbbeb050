// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace repose {

/// Flushes a finished temporary file to the disk and puts it in the place of `path`. Throws RunError.
void publish(const std::string& temporary, const std::string& path);

/// For so many seconds from now this process publishes files without flushing them: they outlive its end, of any kind,
/// but perhaps not that of the machine.
void publish_without_flush_for(double seconds);

/// Writes a file piece by piece under a temporary name until `commit` flushes it to the disk and renames it, so that
/// nobody ever meets half of it. Throws RunError with the system's reason if that fails.
class WholeFile {
 public:
  explicit WholeFile(std::string path);
  /// Without a commit nothing is left behind.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view bytes);
  template <class... T>
  void print(fmt::format_string<T...> format, const T&... values) {
    fmt::vformat_to(std::back_inserter(ahead_), format, fmt::make_format_args(values...));
    if (ahead_.size() >= piece) pass_on();
  }
  void commit();

 private:
  static constexpr std::size_t piece = 1U << 20;
  void pass_on();
  [[noreturn]] void fail();

  std::string path_;
  std::string temporary_;
  std::string ahead_;  // printed, not yet passed on
  std::ofstream file_;
};

}  // namespace repose
