// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace repose {

/// Whether a file or folder of this name exists.
bool path_exists(const std::filesystem::path& path);

/// The nearest existing folder at or above a path.
std::filesystem::path existing_ancestor(std::filesystem::path path);

/// The reasons why no output can be written into a folder of this name, one line each; empty if it can. The folder need
/// not exist yet.
std::vector<std::string> folder_problems(const std::string& path);

/// Locks a folder during its lifetime, for one writer or for several that share it and settle between them who writes
/// what. The system releases the lock if the program is killed.
class FolderLock {
 public:
  enum class For { one, several };

  /// Throws InputError if the folder does not exist, or if another program keeps this one out for longer than
  /// `patience` [s].
  explicit FolderLock(const std::string& path, double patience = 0.0, For writers = For::one);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Throws RunError if the folder has been moved or deleted since it was locked: what is written by its name would lie
  /// in another one.
  void check_place() const;

 private:
  std::string path_;
  int descriptor_;
};

}  // namespace repose
