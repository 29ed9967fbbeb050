// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/barrier.hpp"

#include <functional>
#include <thread>
#include <vector>

namespace repose {

/// A fixed team of threads that run the same function in parallel. The calling thread is member 0.
class Team {
 public:
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return size_; }

  /// Runs task(member) on every member and returns when all have finished. Tasks must not throw.
  void run(const std::function<void(int)>& task);

  /// Call this inside a task: it returns when every member has called it.
  void wait();

 private:
  void serve(int member);

  int size_;
  Barrier start_;
  Barrier finish_;
  Barrier inside_;
  const std::function<void(int)>* task_ = nullptr;  // null tells the threads to end
  std::vector<std::thread> threads_;
};

/// A contiguous range of items.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The range of `count` items that belongs to one member of a team.
inline Range range_of(std::size_t count, int member, int members) {
  const auto m = static_cast<std::size_t>(member);
  const auto n = static_cast<std::size_t>(members);
  return {count * m / n, count * (m + 1) / n};
}

}  // namespace repose
