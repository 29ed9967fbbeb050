// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/members.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/failure.hpp"
#include "repose/io/seal.hpp"
#include "repose/io/whole_file.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/write.hpp"
#include "repose/simulation/expectation.hpp"
#include "repose/simulation/simulation.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

namespace repose {

using Stage = MemberProgress::Stage;
using Clock = std::chrono::steady_clock;

struct Sweep::Shared {
  std::atomic<double> fraction;
  char message[1000];
};

namespace {

// Exit status of the process of a member.
constexpr int went_wrong = 1;
constexpr int was_stopped = 2;  // a checkpoint is kept
constexpr int is_in_use = 3;    // by another program

std::atomic<bool> stop_wanted{false};  // in the process of a member

void want_stop(int) { stop_wanted = true; }

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Copies as much of a text as fits.
void keep(char* place, std::size_t room, const std::string& text) {
  std::strncpy(place, text.c_str(), room - 1);
  place[room - 1] = '\0';
}

/// The folder and the simulation of a member: resumed from the last checkpoint of an interrupted run, or else new.
template <int D>
std::unique_ptr<RunFolder<D>> member_run(const std::string& path, const Scene& scene,
                                         std::unique_ptr<Simulation<D>>& simulation) {
  std::filesystem::create_directories(path);
  constexpr double patience = 5.0;  // [s] a member of a killed sweep may still hold the lock
  std::unique_ptr<FolderLock> lock;
  try {
    lock = std::make_unique<FolderLock>(path, patience);
  } catch (const InputError&) {
    ::_exit(is_in_use);
  }
  simulation = std::make_unique<Simulation<D>>(scene, 1);
  std::vector<std::string> damaged;
  if (const auto checkpoint = Checkpoint::latest(path, damaged);
      checkpoint && checkpoint->scene() == scene_text(simulation->scene())) {
    try {
      return std::make_unique<RunFolder<D>>(path, *checkpoint, *simulation, std::move(lock));
    } catch (const InputError&) {  // the track is damaged: start again
      lock = std::make_unique<FolderLock>(path);
      simulation = std::make_unique<Simulation<D>>(scene, 1);
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(path)) std::filesystem::remove_all(entry.path());
  return std::make_unique<RunFolder<D>>(path, *simulation, std::move(lock));
}

}  // namespace

Sweep::Sweep(const SweepFolder& folder, int processes, const std::optional<SweepPart>& part)
    : folder_(folder),
      progress_(folder.members().size()),
      work_(folder.members().size()),
      workers_(static_cast<std::size_t>(processes)) {
  const auto& members = folder.members();
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (k == 0 || members[k].point != members[k - 1].point) {
      const auto& scene = folder.plan().points[members[k].point].scene;
      work_[k] = expected_work(scene, expected_end(scene));
    } else {
      work_[k] = work_[k - 1];
    }
    auto status = folder.status_of(members[k]);
    if (status == "finished" && !broken_seal(folder.member_path(members[k]) + "/run.h5").empty()) status.clear();
    if (status == "finished" || status == "failed") {
      progress_[k] = {status == "finished" ? Stage::finished : Stage::failed, true, 1.0, 0.0, ""};
    } else {
      queue_.push_back(k);
    }
  }
  // All points run with one seed before the next seed begins, so that the table fills evenly.
  const auto seeds = folder.plan().seeds.size();
  queue_.sort([&](auto a, auto b) { return a % seeds < b % seeds; });
  if (part) take_part(*part);
  void* memory =
      ::mmap(nullptr, workers_.size() * sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw RunError(fmt::format("cannot share memory: {}", std::strerror(errno)));
  shared_ = static_cast<Shared*>(memory);
}

Sweep::~Sweep() {
  stop_members();
  ::munmap(shared_, workers_.size() * sizeof(Shared));
}

/// Members write a checkpoint first, unless they take too long.
void Sweep::stop_members() {
  constexpr double patience = 30.0;  // [s]
  for (const auto& worker : workers_) {
    if (worker.process > 0) ::kill(worker.process, SIGTERM);
  }
  const auto asked = Clock::now();
  for (auto& worker : workers_) {
    if (worker.process <= 0) continue;
    while (::waitpid(worker.process, nullptr, WNOHANG) == 0) {
      if (seconds_since(asked) > patience) ::kill(worker.process, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    worker.process = -1;
    if (leases_) leases_->give_back(lease_of(worker.member));
  }
}

void Sweep::take_part(const SweepPart& part) {
  leases_ = std::make_unique<Leases>(folder_.path() + "/leases", part.patience);
  std::list<std::size_t> others;
  int place = 0;
  for (auto member = queue_.begin(); member != queue_.end(); ++place) {
    const auto here = member++;
    if (place % part.parts != part.number - 1) others.splice(others.end(), queue_, here);
  }
  queue_.splice(queue_.end(), others);
}

std::string Sweep::lease_of(std::size_t member) const {
  const auto& [point, seed] = folder_.members()[member];
  return fmt::format("{}.seed-{}", folder_.plan().points[point].name, seed);
}

void Sweep::notice(std::size_t member) {
  auto& progress = progress_[member];
  if (!leases_ || progress.stage != Stage::waiting) return;
  const auto status = folder_.status_of(folder_.members()[member]);
  if (status != "finished" && status != "failed") return;
  progress = {status == "finished" ? Stage::finished : Stage::failed, true, 1.0, 0.0, ""};
}

/// Whether no other program runs a member; it is then this one's.
bool Sweep::may_run(std::size_t member) {
  if (!leases_) return true;
  if (!leases_->take(lease_of(member))) return false;
  notice(member);  // another program may have ended it until now
  if (progress_[member].stage == Stage::waiting) return true;
  leases_->give_back(lease_of(member));
  return false;
}

std::size_t Sweep::count(Stage stage) const {
  return static_cast<std::size_t>(
      std::count_if(progress_.begin(), progress_.end(), [&](const auto& member) { return member.stage == stage; }));
}

double Sweep::fraction() const {
  double all = 0.0;
  double done = 0.0;
  for (std::size_t k = 0; k < progress_.size(); ++k) {
    all += work_[k];
    done += work_[k] * progress_[k].fraction;
  }
  return all > 0.0 ? done / all : 1.0;
}

double Sweep::wall_seconds() const { return seconds_since(began_); }

void Sweep::run_member(std::size_t member, Shared& shared) const {
  int status = went_wrong;
  // After a power failure so early the member is run again; flushing thousands of small files would take longer.
  publish_without_flush_for(5.0);
  try {
    const auto& what = folder_.members()[member];
    const auto path = folder_.member_path(what);
    const auto scene = folder_.scene_of(what);
    with_dimension(scene.dimension, [&](auto dimension) {
      std::unique_ptr<Simulation<dimension>> simulation;
      const auto run = member_run(path, scene, simulation);
      simulation->observe_every(scene.output.series, [&](const auto& s) {
        shared.fraction = std::clamp(s.grain_steps() / std::max(work_[member], 1.0), 0.0, 0.999);
      });
      run->run(*simulation, stop_wanted);
      if (simulation->status() == Status::interrupted) ::_exit(was_stopped);
      run->write(*simulation);
      if (simulation->status() == Status::failed) {
        keep(shared.message, sizeof shared.message, simulation->message());
      } else {
        status = 0;
      }
    });
  } catch (const std::exception& failure) {
    keep(shared.message, sizeof shared.message, message_of(failure));
  }
  ::_exit(status);
}

std::optional<std::size_t> Sweep::before(std::size_t member) const {
  const auto from = folder_.plan().points[folder_.members()[member].point].starts_from;
  const auto seeds = folder_.plan().seeds.size();
  return from ? std::optional(*from * seeds + member % seeds) : std::nullopt;
}

std::optional<std::size_t> Sweep::next(const std::function<void(std::size_t)>& changed) {
  constexpr double between_checks = 0.2;  // [s] at members that wait for others
  if (seconds_since(searched_) < between_checks) return std::nullopt;
  for (auto place = queue_.begin(); place != queue_.end();) {
    const auto member = *place;
    const auto from = before(member);
    notice(member);
    if (from) notice(*from);
    const auto stage = from ? progress_[*from].stage : Stage::finished;
    const bool waits = progress_[member].stage == Stage::waiting;
    if (waits && stage == Stage::failed) {
      progress_[member] = {Stage::failed, false, 1.0, 0.0, "the member that it starts from failed"};
      changed(member);
    } else if (waits && (stage != Stage::finished || !may_run(member))) {
      ++place;
      continue;
    }
    place = queue_.erase(place);
    if (progress_[member].stage == Stage::waiting) return member;
  }
  searched_ = Clock::now();
  return std::nullopt;
}

void Sweep::start(std::size_t slot, std::size_t member) {
  auto& worker = workers_[slot];
  auto& shared = shared_[slot];
  shared.fraction = 0.0;
  shared.message[0] = '\0';
  folder_.check_place();
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw RunError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (process == 0) {
    // A member ends with its sweep, which handles Ctrl-C.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    ::signal(SIGINT, SIG_IGN);
    ::signal(SIGUSR1, SIG_IGN);
    ::signal(SIGTERM, want_stop);
    run_member(member, shared);
  }
  worker = {process, member, Clock::now()};
  progress_[member].stage = Stage::running;
}

void Sweep::end(std::size_t slot, int status) {
  auto& worker = workers_[slot];
  auto& member = progress_[worker.member];
  member.seconds = seconds_since(worker.started);
  member.fraction = 1.0;
  if (leases_) leases_->give_back(lease_of(worker.member));
  const int exit = WIFEXITED(status) ? WEXITSTATUS(status) : went_wrong;
  if (exit == 0) {
    member.stage = Stage::finished;
  } else if (exit == was_stopped || (exit == is_in_use && leases_)) {
    member = {};
    queue_.push_back(worker.member);
  } else {
    member.stage = Stage::failed;
    member.message = shared_[slot].message;
    if (exit == is_in_use) member.message = "another program writes into its folder";
    if (WIFSIGNALED(status)) member.message = fmt::format("killed by signal {}", WTERMSIG(status));
  }
  worker.process = -1;
}

void Sweep::update_progress(std::size_t slot) {
  const auto& worker = workers_[slot];
  auto& member = progress_[worker.member];
  member.fraction = shared_[slot].fraction;
  member.seconds = seconds_since(worker.started);
}

void Sweep::run(const std::function<void(std::size_t)>& changed, const std::function<void()>& tick,
                const std::atomic<bool>& interrupt) {
  constexpr double between_ticks = 0.05;  // [s]
  began_ = Clock::now();
  auto ticked = began_;
  while (!interrupt) {
    bool busy = false;
    for (std::size_t slot = 0; slot < workers_.size(); ++slot) {
      auto& worker = workers_[slot];
      int status = 0;
      if (worker.process > 0 && ::waitpid(worker.process, &status, WNOHANG) == worker.process) {
        const auto member = worker.member;
        end(slot, status);
        if (progress_[member].stage != Stage::waiting) changed(member);
      }
      if (worker.process < 0) {
        if (const auto member = next(changed)) start(slot, *member);
      }
      if (worker.process > 0) {
        update_progress(slot);
        busy = true;
      }
    }
    if (!busy && queue_.empty()) return;
    if (leases_) leases_->touch();
    if (seconds_since(ticked) >= between_ticks) {
      tick();
      ticked = Clock::now();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // a member may last a few milliseconds only
  }
  stop_members();  // nothing writes into the folder after this
}

}  // namespace repose
