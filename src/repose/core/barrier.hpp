// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace repose {

/// A point where a fixed number of threads wait for each other, again and again. A thread spins for some microseconds
/// before it sleeps: to wake a thread takes longer than most steps of a small system.
class Barrier {
 public:
  explicit Barrier(int threads);
  void arrive_and_wait();

 private:
  int threads_;
  int spins_;
  // On cache lines of their own, since one is written by every thread and the other is read in a loop.
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<std::uint32_t> round_{0};
};

}  // namespace repose
