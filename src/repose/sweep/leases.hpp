// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace repose {

/// Who runs which member, where several programs share a sweep, on one machine or on many with one file system. A lease
/// is a file that names its holder, who touches it while it works. A lease that nobody has touched for a time, by the
/// clock of the one who waits, is that of a dead program and is taken over; one of a program of this machine that has
/// ended, at once.
class Leases {
 public:
  /// The leases in a folder, which is made; `patience` [s] > 0. Throws InputError.
  Leases(std::string folder, double patience);
  ~Leases();  // gives all back
  Leases(const Leases&) = delete;
  Leases& operator=(const Leases&) = delete;

  /// Takes the lease of this name; false while another holds it. Throws RunError where the folder cannot be written.
  bool take(const std::string& name);
  void give_back(const std::string& name);
  /// Touches those held, if it is time to; to be called several times within the patience.
  void touch();

 private:
  using Clock = std::chrono::steady_clock;
  struct Seen {
    std::filesystem::file_time_type touched;
    Clock::time_point since;
  };

  std::filesystem::path file_of(const std::string& name) const;
  bool create(const std::filesystem::path& file) const;
  bool is_dead(const std::filesystem::path& file, const std::string& name);
  void take_away(const std::filesystem::path& file, const std::string& name);

  std::filesystem::path folder_;
  double patience_;
  std::string holder_;  // host and process
  std::set<std::string> held_;
  std::map<std::string, Seen> others_;
  Clock::time_point touched_ = Clock::now();
};

}  // namespace repose
