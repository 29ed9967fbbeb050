// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/folders.hpp"

#include "repose/core/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

namespace fs = std::filesystem;

namespace repose {

bool path_exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

fs::path existing_ancestor(fs::path path) {
  path = fs::absolute(path);
  while (!path_exists(path) && path.has_relative_path()) path = path.parent_path();
  return path;
}

std::vector<std::string> folder_problems(const std::string& path) {
  std::error_code error;
  const bool there = fs::exists(path, error);
  if (error) return {fmt::format("{}: cannot write a run here: {}", path, error.message())};
  if (there) {
    if (!fs::is_directory(path)) return {fmt::format("{}: cannot write a run here: is a file", path)};
    if (::access(path.c_str(), W_OK | X_OK | R_OK) != 0) {
      return {fmt::format("{}: cannot write a run here: {}", path, std::strerror(errno))};
    }
    return {};
  }
  const auto parent = existing_ancestor(path);
  if (!fs::is_directory(parent)) {
    return {fmt::format("{}: cannot write a run here: {} is a file", path, parent.string())};
  }
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    return {fmt::format("{}: cannot write a run here: {}: {}", path, parent.string(), std::strerror(errno))};
  }
  return {};
}

FolderLock::FolderLock(const std::string& path, double patience, For writers)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 && (errno == ENOENT || errno == ENOTDIR)) {
    throw InputError(fmt::format("{}: no such folder", path));
  }
  if (descriptor_ < 0) throw InputError(fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  do {
    const int kind = writers == For::one ? LOCK_EX : LOCK_SH;
    if (::flock(descriptor_, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // not every file system has locks
    if (patience > 0.0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  } while (Clock::now() < end);
  ::close(descriptor_);
  throw InputError(fmt::format("{}: a run is being written here by another program", path));
}

void FolderLock::check_place() const {
  struct stat locked {};
  struct stat named {};
  const bool same = ::fstat(descriptor_, &locked) == 0 && ::stat(path_.c_str(), &named) == 0 &&
                    locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
  if (!same) {
    throw RunError(fmt::format("{}: this folder was moved or deleted while the program wrote into it", path_));
  }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace repose
