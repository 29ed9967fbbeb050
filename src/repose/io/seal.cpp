// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/seal.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/named_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <vector>

namespace repose {

namespace {

constexpr std::string_view first_line = "repose sealed file\n";

/// The seal for the content of a file; "" if it cannot be read.
std::string seal_for(std::istream& file) {
  file.seekg(seal_size);
  Hash hash;
  std::size_t length = seal_size;
  std::vector<char> buffer(1U << 20);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto size = static_cast<std::size_t>(file.gcount());
    hash.add(buffer.data(), size);
    length += size;
  }
  if (file.bad()) return "";
  file.clear();
  std::string text(seal_size, '\0');
  fmt::format_to_n(text.data(), seal_size, "{}length {}\nxxh3-128 {}\n", first_line, length, hash.text());
  return text;
}

}  // namespace

void seal(const std::string& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const auto text = seal_for(file);
  file.seekp(0);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (text.empty() || !file) throw RunError(fmt::format("{}: cannot write: no seal", path));
}

bool is_sealed(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string found(first_line.size(), '\0');
  file.read(found.data(), static_cast<std::streamsize>(found.size()));
  return file && found == first_line;
}

std::string broken_seal(const std::string& path) {
  if (const auto why = why_not_readable(path); !why.empty()) return why;
  std::ifstream file(path, std::ios::binary);
  if (!file) return "cannot be read";
  std::string found(seal_size, '\0');
  file.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (static_cast<std::size_t>(file.gcount()) < seal_size) return "damaged: too short";
  if (!found.starts_with(first_line)) return "damaged, or not written by this version of Repose";
  const auto wanted = seal_for(file);
  if (wanted == found) return "";
  const auto length = [](const std::string& text) { return text.substr(0, text.find("xxh3")); };
  return length(wanted) == length(found) ? "damaged: its content is not what was written"
                                         : "damaged: its length is not what was written";
}

}  // namespace repose
