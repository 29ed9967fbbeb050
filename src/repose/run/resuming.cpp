// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/resuming.hpp"

#include "repose/core/errors.hpp"
#include "repose/run/folders.hpp"
#include "repose/run/record_file.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/toml_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace repose {

namespace {

/// The status of run.h5; nothing if the file cannot be read, which a checkpoint can do without.
Status status_in(const std::string& folder, bool needed) {
  try {
    return read_run_facts(folder).status;
  } catch (const InputError&) {
    if (needed) throw;
    return Status::running;
  }
}

}  // namespace

InterruptedRun find_interrupted(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) throw InputError(fmt::format("{}: no such folder", folder));
  for (const auto* name : {"scene.toml", "run.h5"}) {
    if (!is_there(std::filesystem::path(folder) / name)) {
      throw InputError(fmt::format("{}: holds no run: no {}", folder, name));
    }
  }
  InterruptedRun run;
  run.checkpoint = Checkpoint::latest(folder, run.damaged);
  if (!run.checkpoint && !run.damaged.empty()) throw InputError(run.damaged);
  const auto status = status_in(folder, !run.checkpoint);
  if (status == Status::failed)
    throw InputError(fmt::format("{}: the run failed; there is nothing to go on with", folder));
  run.finished = status == Status::finished;
  const auto path = folder + "/scene.toml";
  if (run.checkpoint && text_of_file(path) != run.checkpoint->scene()) {
    throw InputError(
        fmt::format("{}: is not the scene of this run, which only goes on as it began (/scene of run.h5 and "
                    "of the checkpoints has it)",
                    path));
  }
  run.scene = read_scene(path);
  return run;
}

std::unique_ptr<RunFolder> taken_up(const std::string& folder, const InterruptedRun& run, Simulation& simulation) {
  if (run.checkpoint) return std::make_unique<RunFolder>(folder, *run.checkpoint, simulation);
  return std::make_unique<RunFolder>(folder, simulation);
}

}  // namespace repose
