// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/barrier.hpp"

#include <thread>

namespace repose {

namespace {

/// Tens of microseconds, by the processor. Where threads share processors, a thread that spins keeps others from
/// arriving.
constexpr int usual_spins = 1500;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Barrier::Barrier(int threads)
    : threads_(threads), spins_(threads <= static_cast<int>(std::thread::hardware_concurrency()) ? usual_spins : 0) {}

void Barrier::arrive_and_wait() {
  const auto round = round_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
    arrived_.store(0, std::memory_order_relaxed);
    round_.store(round + 1, std::memory_order_release);
    round_.notify_all();
    return;
  }
  for (int k = 0; k < spins_; ++k) {
    if (round_.load(std::memory_order_acquire) != round) return;
    pause();
  }
  round_.wait(round, std::memory_order_acquire);
}

}  // namespace repose
