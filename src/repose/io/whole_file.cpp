// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/whole_file.hpp"

#include "repose/core/errors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace repose {

namespace {

using Clock = std::chrono::steady_clock;
std::atomic<Clock::time_point> flush_from = Clock::time_point::min();

/// Flushes a file or folder to the disk; false on failure.
bool flush_to_disk(const std::string& path) {
  if (Clock::now() < flush_from.load()) return true;
  const int descriptor = ::open(path.c_str(), O_RDONLY);
  if (descriptor < 0) return false;
  const bool flushed = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return flushed;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

}  // namespace

void publish_without_flush_for(double seconds) {
  flush_from = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void publish(const std::string& temporary, const std::string& path) {
  if (!flush_to_disk(temporary) || std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    std::remove(temporary.c_str());
    throw RunError(fmt::format("{}: cannot write: {}", path, std::strerror(error)));
  }
  flush_to_disk(folder_of(path));
}

WholeFile::WholeFile(std::string path) : path_(std::move(path)), temporary_(path_ + ".tmp") {
  errno = 0;
  file_.open(temporary_, std::ios::binary);
  if (!file_) fail();
}

WholeFile::~WholeFile() {
  if (!file_.is_open()) return;
  file_.close();
  std::remove(temporary_.c_str());
}

void WholeFile::fail() {
  const int error = errno != 0 ? errno : EIO;
  if (file_.is_open()) {
    file_.close();
    std::remove(temporary_.c_str());
  }
  throw RunError(fmt::format("{}: cannot write: {}", path_, std::strerror(error)));
}

void WholeFile::write_buffer() {
  errno = 0;
  file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  if (!file_) fail();
  buffer_.clear();
}

void WholeFile::write(std::string_view bytes) {
  write_buffer();
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) fail();
}

void WholeFile::commit() {
  write_buffer();
  file_.close();
  if (!file_) {
    const int error = errno != 0 ? errno : EIO;
    std::remove(temporary_.c_str());
    throw RunError(fmt::format("{}: cannot write: {}", path_, std::strerror(error)));
  }
  publish(temporary_, path_);
}

}  // namespace repose
