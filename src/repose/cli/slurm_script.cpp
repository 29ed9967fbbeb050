// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/slurm_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <tuple>
#include <vector>

namespace repose {

namespace {

constexpr int seconds_for_checkpoints = 120;
constexpr double least_minutes = 5.0;  // of a task; shorter ones would hardly do more than write checkpoints

bool is_plain(const std::string& text, std::string_view others) {
  const auto fits = [&](char c) { return ('a' <= (c | 32) && (c | 32) <= 'z') || ('0' <= c && c <= '9'); };
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [&](char c) { return fits(c) || others.find(c) != others.npos; });
}

/// A time of Slurm in minutes; -1 if it is none. M, M:S, H:M:S, D-H, D-H:M and D-H:M:S are.
double minutes_in(const std::string& time) {
  constexpr std::size_t most_digits = 6;
  std::vector<double> fields;
  std::string digits;
  std::string marks;
  for (const char c : time + "\n") {
    if ('0' <= c && c <= '9') {
      digits += c;
      continue;
    }
    if (digits.empty() || digits.size() > most_digits) return -1.0;
    fields.push_back(std::atof(digits.c_str()));
    digits.clear();
    marks += c;
  }
  fields.resize(4);
  const auto [a, b, c, d] = std::tuple(fields[0], fields[1], fields[2], fields[3]);
  if (marks == "\n") return a;
  if (marks == ":\n") return a + b / 60.0;
  if (marks == "::\n") return 60.0 * a + b + c / 60.0;
  if (marks == "-\n" || marks == "-:\n" || marks == "-::\n") return 1440.0 * a + 60.0 * b + c + d / 60.0;
  return -1.0;
}

/// A name of the file of a task's output in which Slurm replaces nothing.
std::string without_patterns(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

std::string job_name(const SlurmTasks& tasks) {
  auto name = std::filesystem::path(tasks.folder).filename().string();
  for (auto& c : name) {
    if (!is_plain({c}, "._=+-")) c = '_';
  }
  return name;
}

}  // namespace

std::string problem_with(const SlurmTasks& tasks) {
  if (minutes_in(tasks.time) < least_minutes) {
    return fmt::format("--time {}: must be a time of Slurm, at least {:g} minutes: 90, 12:00:00 or 2-12:00:00",
                       tasks.time, least_minutes);
  }
  if (!tasks.partition.empty() && !is_plain(tasks.partition, "_.+-,")) {
    return fmt::format("--partition {}: must be the name of a partition, or several with commas", tasks.partition);
  }
  for (const auto& path : {tasks.program, tasks.file, tasks.folder}) {
    const auto is_odd = [](char c) { return c == '\\' || static_cast<unsigned char>(c) < ' '; };
    if (std::any_of(path.begin(), path.end(), is_odd)) {
      return fmt::format("{}: a path for Slurm must have no backslash and no line break", path);
    }
  }
  return "";
}

std::string shell_word(const std::string& text) {
  if (is_plain(text, "_./+-=:,@%")) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string slurm_script(const SlurmTasks& tasks) {
  const auto folder = std::filesystem::path(tasks.script()).parent_path().string();
  return fmt::format(
      R"(#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array=1-{tasks}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={cores}
#SBATCH --time={time}
{partition}#SBATCH --signal=B:USR1@{warning}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output={output}
# Tasks that share a sweep, written by `repose sweep --slurm`. USR1 comes {warning} s before the time of a task ends:
# the sweep writes checkpoints and the task is queued again. SIGTERM comes where Slurm preempts or cancels a task: the
# sweep writes checkpoints, and Slurm itself queues preempted tasks again.
asked=
# Slurm sends SIGTERM to the sweep too. Only the first signal of a kind leaves checkpoints, so the other kind is sent on.
trap 'asked=USR1; kill -TERM "$sweep" 2>/dev/null' USR1
trap 'asked=TERM; kill -USR1 "$sweep" 2>/dev/null' TERM
{program} sweep {file} \
  --out {out} \
  --share "$SLURM_ARRAY_TASK_ID/{tasks}" --threads {cores} --lease {lease}{quick} &
sweep=$!
while kill -0 "$sweep" 2>/dev/null; do wait "$sweep"; done # a signal ends a wait before the sweep does
wait "$sweep"
status=$?
if [ "$asked" = USR1 ] && [ "$status" -ge 128 ]; then
  scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" # SLURM_JOB_ID may stand for the whole array
fi
exit "$status"
)",
      fmt::arg("name", job_name(tasks)), fmt::arg("tasks", tasks.tasks), fmt::arg("cores", tasks.cores),
      fmt::arg("time", tasks.time), fmt::arg("warning", seconds_for_checkpoints),
      fmt::arg("partition", tasks.partition.empty() ? "" : fmt::format("#SBATCH --partition={}\n", tasks.partition)),
      fmt::arg("output", shell_word(without_patterns(folder)) + "/task-%a.log"),
      fmt::arg("program", shell_word(tasks.program)), fmt::arg("file", shell_word(tasks.file)),
      fmt::arg("out", shell_word(tasks.folder)), fmt::arg("lease", tasks.lease),
      fmt::arg("quick", tasks.quick ? " --quick" : ""));
}

}  // namespace repose
