// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"

#include <cstdio>
#include <cstdlib>

namespace repose {

namespace {

/// Makes control characters visible, which a file may bring into a message, so that a problem stays on one line.
std::string on_one_line(const std::string& text) {
  constexpr std::size_t longest = 4000;  // more than any path
  std::string line;
  for (const char c : text) {
    if (line.size() >= longest) return line + " ...";
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code != 0x7f) {
      line += c;
    } else {
      constexpr const char* digits = "0123456789abcdef";
      line += "\\x";
      line += digits[code / 16];
      line += digits[code % 16];
    }
  }
  return line;
}

std::vector<std::string> on_one_line_each(std::vector<std::string> problems) {
  for (auto& problem : problems) problem = on_one_line(problem);
  return problems;
}

/// The first lines, and how many others there are.
std::string joined(const std::vector<std::string>& lines) {
  constexpr std::size_t most_shown = 50;
  std::string all;
  for (std::size_t k = 0; k < lines.size() && k < most_shown; ++k) all += (k == 0 ? "" : "\n") + lines[k];
  if (lines.size() > most_shown) all += "\n... and " + std::to_string(lines.size() - most_shown) + " more problems";
  return all;
}

}  // namespace

InputError::InputError(std::vector<std::string> problems)
    : std::runtime_error(joined(on_one_line_each(problems))), problems_(on_one_line_each(std::move(problems))) {}

void assertion_failed(const char* what, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: assertion failed (a bug of Repose, please report it): %s\n", file, line, what);
  std::abort();
}

}  // namespace repose
