// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/viewer_process.hpp"

#include "repose/cli/signals.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>

namespace repose {

ViewerProcess::ViewerProcess(const std::string& folder) {
  std::string program = "/proc/self/exe";
  std::string name = "repose";
  std::string verb = "view";
  std::string shown = folder;
  char* words[] = {name.data(), verb.data(), shown.data(), nullptr};
  std::fflush(stdout);
  if (const int error = posix_spawn(&process_, program.c_str(), nullptr, nullptr, words, environ); error != 0) {
    throw RunError(fmt::format("the view cannot be started: {}", std::strerror(error)));
  }
}

ViewerProcess::~ViewerProcess() {
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

void ViewerProcess::wait() {
  constexpr useconds_t glance = 200000;
  while (process_ > 0 && !interrupted) {
    if (::waitpid(process_, nullptr, WNOHANG) == process_) process_ = -1;
    ::usleep(glance);
  }
}

}  // namespace repose
