// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/machine.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <thread>

namespace repose {

double machine_memory() {
  const auto pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  double memory = pages > 0.0 ? pages * static_cast<double>(::sysconf(_SC_PAGESIZE))
                              : static_cast<double>(std::numeric_limits<long>::max());
  for (const char* limit : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    double bytes = 0.0;
    if (std::ifstream file(limit); file >> bytes && bytes > 0.0) memory = std::min(memory, bytes);
  }
  return memory;
}

int machine_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

}  // namespace repose
