// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/surroundings.hpp"

#include "repose/cli/say.hpp"
#include "repose/core/failure.hpp"
#include "repose/io/machine.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <exception>

namespace repose {

namespace {

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest number that is free is this one.
    if (::open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY) != stream) std::_Exit(1);
  }
}

/// Sanitizers reserve more memory than any machine has.
void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(machine_memory()));
  ::setrlimit(RLIMIT_DATA, &limit);
#endif
}

/// Ends the program where an exception has nowhere to go: in a thread of the team.
[[noreturn]] void give_up() {
  try {
    if (const auto failure = std::current_exception()) std::rethrow_exception(failure);
  } catch (const std::exception& failure) {
    complain("{}\n", message_of(failure));
  } catch (...) {
    complain("repose: it ends by an error of its own\n");
  }
  std::_Exit(1);
}

}  // namespace

void settle_in() {
  open_standard_streams();
  ::signal(SIGXFSZ, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
  limit_memory();
  std::set_terminate(give_up);
}

}  // namespace repose
