// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/say.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace repose {

namespace {

/// The reason of the first failure of standard output; 0 without one.
int output_failure = 0;

void note_failure() {
  if (output_failure == 0) output_failure = errno != 0 ? errno : EIO;
}

}  // namespace

void say_text(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_failure();
}

void complain_text(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

int status_after_output(int status) {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) note_failure();
  if (output_failure == 0 || output_failure == EPIPE) return status;
  complain("repose: standard output: cannot be written: {}\n", std::strerror(output_failure));
  return status == 0 ? 1 : status;
}

}  // namespace repose
