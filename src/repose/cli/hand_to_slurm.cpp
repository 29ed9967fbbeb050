// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/hand_to_slurm.hpp"

#include "repose/cli/say.hpp"
#include "repose/cli/slurm_script.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/sweep/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// The same file or folder for a task that starts elsewhere. Links stay: what a file names is relative to its link.
std::string absolute(const std::string& path) {
  auto full = fs::absolute(path);
  if (std::find(full.begin(), full.end(), "..") == full.end()) full = full.lexically_normal();
  return (full.has_filename() ? full : full.parent_path()).string();
}

/// What a program prints, in one line, and whether it succeeded. Throws InputError if it cannot be started.
std::pair<std::string, bool> answer_of(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw RunError(fmt::format("{}: {}", words[0], std::strerror(errno)));
  posix_spawn_file_actions_t streams;
  ::posix_spawn_file_actions_init(&streams);
  ::posix_spawn_file_actions_adddup2(&streams, ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&streams, ends[1], STDERR_FILENO);
  pid_t process = 0;
  const int problem = ::posix_spawnp(&process, words[0].c_str(), &streams, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&streams);
  ::close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t size = 0; problem == 0 && (size = ::read(ends[0], part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  ::close(ends[0]);
  if (problem != 0) throw InputError(fmt::format("{}: cannot be started: {}", words[0], std::strerror(problem)));
  int status = 0;
  ::waitpid(process, &status, 0);
  text.erase(text.find_last_not_of(" \n") + 1);
  for (std::size_t end = 0; (end = text.find('\n', end)) != text.npos;) text.replace(end, 1, "; ");
  return {text, WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

std::string counted(int count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void write_script(const SlurmTasks& tasks) {
  std::error_code error;
  const auto folder = fs::path(tasks.script()).parent_path();
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", folder.string(), error.message()));
  write_text_file(tasks.script(), slurm_script(tasks));
}

std::string submit(const SlurmTasks& tasks) {
  const auto [text, accepted] = answer_of({"sbatch", tasks.script()});
  if (!accepted) throw RunError(fmt::format("{}: not submitted: {}", tasks.script(), text));
  return text;
}

}  // namespace

int hand_to_slurm(const SlurmSweep& sweep, const SlurmOptions& options) {
  constexpr int usual = 4;  // tasks, and cores of each
  const auto plan = read_sweep(sweep.file, sweep.form);
  auto problems = SweepFolder::problems(sweep.folder, plan, false);
  const auto members = static_cast<int>(plan.points.size() * plan.seeds.size());
  const int cores = sweep.cores > 0 ? sweep.cores : usual;
  std::error_code error;
  const int enough = std::clamp((members + cores - 1) / cores, 1, usual);
  const SlurmTasks tasks{.program = fs::read_symlink("/proc/self/exe", error).string(),
                         .file = absolute(sweep.file),
                         .folder = absolute(sweep.folder),
                         .tasks = options.tasks > 0 ? options.tasks : enough,
                         .cores = cores,
                         .time = options.time.empty() ? "24:00:00" : options.time,
                         .partition = options.partition,
                         .lease = sweep.lease,
                         .quick = sweep.form == SweepForm::quick};
  if (const auto problem = problem_with(tasks); !problem.empty()) problems.push_back(problem);
  if (tasks.tasks > members) {
    problems.push_back(
        fmt::format("--array {}: the sweep has {} members; some tasks would run none", tasks.tasks, members));
  }
  if (!problems.empty()) throw InputError(problems);
  if (options.submit) answer_of({"sbatch", "--version"});  // where there is none, nothing is written
  write_script(tasks);
  const auto next = options.submit ? submit(tasks) + ", " + tasks.script() : "sbatch " + shell_word(tasks.script());
  if (!sweep.quiet) {
    say("{} of {} for {}, {} at a time: {}\n", counted(tasks.tasks, "task"), counted(cores, "core"),
        counted(members, "member"), tasks.time, next);
  }
  return 0;
}

}  // namespace repose
