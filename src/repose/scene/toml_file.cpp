// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#define TOML_IMPLEMENTATION
#include "repose/scene/toml_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/named_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

namespace repose {

namespace {

/// Number of the first line that looks like a header without a proper key; 0 if there is none.
int line_of_bad_header(const std::string& text) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line[begin] != '[') continue;
    const auto key = line.find_first_not_of("[ \t", begin);
    const bool proper = key != std::string::npos && (std::isalnum(static_cast<unsigned char>(line[key])) != 0 ||
                                                     std::string("_-\"'").find(line[key]) != std::string::npos);
    if (!proper) return number;
  }
  return 0;
}

/// What toml++ does not look at before it leaps, outside strings and comments: the number of the first line with a
/// character beyond ASCII, where TOML has none, or of the first with a key of very many steps; 0 if there is none.
struct BadLines {
  int foreign_character = 0;
  int long_key = 0;
};

BadLines bad_lines(const std::string& text) {
  BadLines bad;
  int number = 1;
  std::size_t dots = 0;  // in a row, with nothing between them that could end a key
  std::string closing;   // of the string or comment that we are in; empty outside
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '\n') ++number;
    if (closing.empty()) {
      if (static_cast<unsigned char>(c) >= 0x80 && bad.foreign_character == 0) bad.foreign_character = number;
      if (c == '.' && ++dots == most_key_steps && bad.long_key == 0) bad.long_key = number;
      if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') dots = 0;
      if (c == '#') closing = "\n";
      if (c == '"' || c == '\'') {
        const bool long_one = text.compare(k, 3, std::string(3, c)) == 0;
        closing = std::string(long_one ? 3 : 1, c);
        if (long_one) k += 2;
      }
    } else if (c == '\\' && closing.front() == '"') {
      if (k + 1 < text.size() && text[k + 1] != '\n') ++k;
    } else if (text.compare(k, closing.size(), closing) == 0) {
      k += closing.size() - 1;
      // Up to two more quotation marks in front of the closing three belong to the string.
      for (int more = 0; closing.size() == 3 && more < 2 && text.compare(k + 1, 1, closing, 0, 1) == 0; ++more) ++k;
      closing.clear();
    } else if (c == '\n' && closing.size() == 1) {
      closing.clear();  // a short string that was not closed
    }
  }
  return bad;
}

}  // namespace

std::string text_of_file(const std::string& path) {
  if (const auto why = why_not_readable(path); !why.empty()) {
    throw InputError(fmt::format("{}: cannot read: {}", path, why));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (file.bad() || text.bad() || !file.is_open()) {
    throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(errno != 0 ? errno : EIO)));
  }
  auto content = text.str();
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff")) {
    throw InputError(fmt::format("{}: cannot read: is UTF-16; save it as UTF-8", path));
  }
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (content.starts_with(byte_order_mark)) content.erase(0, byte_order_mark.size());
  return content;
}

toml::table parsed_toml(const std::string& text, const std::string& name) {
  const auto bad = bad_lines(text);
  if (bad.foreign_character > 0) {
    throw InputError(
        fmt::format("{}:{}: letters beyond ASCII may stand in text and comments only", name, bad.foreign_character));
  }
  if (bad.long_key > 0) {
    throw InputError(fmt::format("{}:{}: a key of more than {} steps", name, bad.long_key, most_key_steps));
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  } catch (const TomlAssumptionError&) {
    throw InputError(fmt::format("{}:{}: a key must begin with a letter, a digit, _, - or a quotation mark", name,
                                 line_of_bad_header(text)));
  }
}

}  // namespace repose
