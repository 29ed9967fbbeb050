// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace repose {

bool is_there(const std::filesystem::path& path);

/// The closest existing folder at or above a path.
std::filesystem::path existing_ancestor(std::filesystem::path path);

/// Why no output can be written into a folder of this name, which need not exist yet; one line each.
std::vector<std::string> folder_problems(const std::string& path);

/// Holds a folder for one writer as long as it lives; the system lets go of it should the program be killed.
class FolderLock {
 public:
  /// Throws InputError if there is no such folder, or if another program has it and still has it after `patience` [s].
  explicit FolderLock(const std::string& path, double patience = 0.0);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace repose
