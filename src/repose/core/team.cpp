// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/team.hpp"

#include "repose/core/errors.hpp"

namespace repose {

Team::Team(int threads) : size_(threads), start_(threads), finish_(threads), inside_(threads) {
  REPOSE_ASSERT(threads >= 1);
  for (int member = 1; member < size_; ++member) threads_.emplace_back([this, member] { serve(member); });
}

Team::~Team() {
  task_ = nullptr;
  start_.arrive_and_wait();
  for (auto& thread : threads_) thread.join();
}

void Team::serve(int member) {
  for (;;) {
    start_.arrive_and_wait();
    if (task_ == nullptr) return;
    (*task_)(member);
    finish_.arrive_and_wait();
  }
}

void Team::run(const std::function<void(int)>& task) {
  if (size_ == 1) {
    task(0);
    return;
  }
  task_ = &task;
  start_.arrive_and_wait();
  task(0);
  finish_.arrive_and_wait();
}

void Team::wait() {
  if (size_ > 1) inside_.arrive_and_wait();
}

}  // namespace repose
