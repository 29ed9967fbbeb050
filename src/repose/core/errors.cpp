// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"

#include <cstdio>
#include <cstdlib>

namespace repose {

namespace {

/// Makes control characters visible, which a file may bring into a message, so that a problem stays on one line.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
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

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const auto& line : lines) all += (all.empty() ? "" : "\n") + line;
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
