// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/folder.hpp"
#include "repose/sweep/leases.hpp"

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// The progress of one member.
struct MemberProgress {
  enum class Stage { waiting, running, finished, failed };
  Stage stage = Stage::waiting;
  bool earlier = false;   ///< finished or failed before this sweep was continued
  double fraction = 0.0;  ///< of the work, estimated
  double seconds = 0.0;
  std::string message;  ///< why it failed
};

/// The part of one of several programs that share a sweep: it begins with every `parts`-th member, and then helps with
/// those that no other program holds.
struct SweepPart {
  int number = 1;  ///< from 1 to `parts`
  int parts = 1;
  double patience = 60.0;  ///< [s] after which a program that does not stir is taken for dead
};

/// Runs the members of a sweep side by side, each in a process of its own, so that a crash of one leaves the others
/// alone. A member that has finished or failed is never run again, unless its run.h5 is missing or damaged; an
/// interrupted one resumes from its checkpoint, or starts again without one. Several programs may share a sweep; each
/// then returns when all members have ended, its own and those of the others.
class Sweep {
 public:
  Sweep(const SweepFolder& folder, int processes, const std::optional<SweepPart>& part = {});
  ~Sweep();
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;

  /// Runs all members. Calls `changed` with the number of a member when it ends, and `tick` several times a second.
  /// Returns when all members have ended, or soon after `interrupt` becomes true.
  void run(const std::function<void(std::size_t member)>& changed, const std::function<void()>& tick,
           const std::atomic<bool>& interrupt);

  const std::vector<MemberProgress>& progress() const { return progress_; }
  std::size_t count(MemberProgress::Stage stage) const;
  /// Estimated fraction of all the work that is done, in [0, 1].
  double fraction() const;
  double wall_seconds() const;

 private:
  struct Shared;  // progress of a member, in memory shared with its process
  struct Worker {
    pid_t process = -1;
    std::size_t member = 0;
    std::chrono::steady_clock::time_point started;
  };

  void take_part(const SweepPart& part);
  std::string lease_of(std::size_t member) const;
  void notice(std::size_t member);  // that another program has ended it
  bool may_run(std::size_t member);
  void stop_members();
  std::optional<std::size_t> before(std::size_t member) const;  // the member that one starts from
  /// Takes the next member out of the queue that can start. Those whose start failed fail too.
  std::optional<std::size_t> next(const std::function<void(std::size_t member)>& changed);
  void start(std::size_t slot, std::size_t member);
  void update_progress(std::size_t slot);
  void end(std::size_t slot, int status);
  [[noreturn]] void run_member(std::size_t member, Shared& shared) const;

  const SweepFolder& folder_;
  std::vector<MemberProgress> progress_;
  std::vector<double> work_;  // of each member, estimated
  std::list<std::size_t> queue_;
  std::unique_ptr<Leases> leases_;                    // null where one program runs all
  std::chrono::steady_clock::time_point searched_{};  // when all members that are left had to wait for others
  std::vector<Worker> workers_;
  Shared* shared_ = nullptr;  // one per worker
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace repose
