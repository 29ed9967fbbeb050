// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/named_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/whole_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace fs = std::filesystem;

namespace repose {

std::string why_not_readable(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) return error ? error.message() : std::strerror(ENOENT);
  if (fs::is_directory(status)) return "is a folder, no regular file";
  return fs::is_regular_file(status) ? "" : "is no regular file";
}

std::string followed(const std::string& path) {
  constexpr int most_links = 40;  // as the system itself
  fs::path at = path;
  std::error_code error;
  for (int k = 0; k < most_links && fs::is_symlink(at, error); ++k) {
    const auto target = fs::read_symlink(at, error);
    if (error) break;
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  return at.string();
}

void write_named_file(const std::string& path, std::string_view text) {
  std::error_code error;
  const auto file = followed(path);
  // An open file of this process, as /dev/stdout is, must not be replaced under it.
  const bool replaceable =
      !fs::exists(path, error) || (fs::is_regular_file(path, error) && !file.starts_with("/proc/"));
  if (replaceable) {
    WholeFile whole(file);
    whole.write(text);
    return whole.commit();
  }
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "wb"), std::fclose);
  const bool written = stream != nullptr && std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
                       std::fflush(stream.get()) == 0;
  if (!written) throw RunError(fmt::format("{}: cannot write: {}", path, std::strerror(errno != 0 ? errno : EIO)));
}

}  // namespace repose
