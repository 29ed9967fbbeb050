// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace repose {

// All that the program prints goes through these. None of them throws: a stream that is closed or full must not change
// what the program does.

/// Prints text to standard output. What cannot be written is lost; `status_after_output` reports it.
void say_text(std::string_view text);

/// Prints text to standard error. What cannot be written is lost.
void complain_text(std::string_view text);

template <class... T>
void say(fmt::format_string<T...> format, const T&... values) {
  say_text(fmt::vformat(format, fmt::make_format_args(values...)));
}

template <class... T>
void complain(fmt::format_string<T...> format, const T&... values) {
  complain_text(fmt::vformat(format, fmt::make_format_args(values...)));
}

/// The exit status of a program that would end with `status`: 1 instead of 0, with a message, if standard output has
/// not taken all of it. A reader that has left (`repose check heap.toml | head -1`) is no failure.
int status_after_output(int status);

}  // namespace repose
