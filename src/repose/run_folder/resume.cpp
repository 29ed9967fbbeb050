// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/resume.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/results/summary.hpp"
#include "repose/run_folder/further_analysis.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/toml_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace repose {

namespace {

/// The status of run.h5. A file that cannot be read tells nothing; a checkpoint can do without it.
Status status_in(const std::string& folder) {
  try {
    return read_run_facts(folder).status;
  } catch (const InputError&) {
    return Status::running;
  }
}

/// The last file of a finished run is its summary. Where a kill came between run.h5 and that, what is missing is made.
bool complete_analysis(const std::string& folder, const FolderLock& lock) {
  const auto path = folder + "/summary.json";
  if (path_exists(path) && summary_status(text_of_file(path)) == status_text(Status::finished)) return false;
  with_dimension(run_dimension(folder), [&](auto dimension) {
    const auto record = read_record<dimension>(folder);
    write_results(folder, lock, record, analyse(record, {}));
  });
  return true;
}

}  // namespace

InterruptedRun find_interrupted(const std::string& folder) {
  InterruptedRun run;
  run.lock = std::make_unique<FolderLock>(folder);
  complete_start(folder);
  for (const auto* name : {"scene.toml", "run.h5"}) {
    if (!path_exists(std::filesystem::path(folder) / name)) {
      throw InputError(fmt::format("{}: holds no run: no {}", folder, name));
    }
  }
  const auto status = status_in(folder);
  if (status == Status::failed) {
    throw InputError(fmt::format("{}: the run failed; there is nothing to resume", folder));
  }
  if (status == Status::finished) {
    run.finished = true;
    run.completed = complete_analysis(folder, *run.lock);
    remove_checkpoints(folder);
    return run;
  }
  run.checkpoint = Checkpoint::latest(folder, run.damaged);
  if (!run.checkpoint && !run.damaged.empty()) throw InputError(run.damaged);
  const auto path = folder + "/scene.toml";
  if (text_of_file(path) != (run.checkpoint ? run.checkpoint->scene() : read_run_scene(folder))) {
    throw InputError(
        fmt::format("{}: is not the scene of this run, which resumes only as it began (/scene of run.h5 and "
                    "of the checkpoints has it)",
                    path));
  }
  run.scene = read_scene(path);
  return run;
}

template <int D>
std::unique_ptr<RunFolder<D>> resumed_folder(const std::string& folder, InterruptedRun& run,
                                             Simulation<D>& simulation) {
  if (run.checkpoint) return std::make_unique<RunFolder<D>>(folder, *run.checkpoint, simulation, std::move(run.lock));
  return std::make_unique<RunFolder<D>>(folder, simulation, std::move(run.lock));
}

template std::unique_ptr<RunFolder<2>> resumed_folder(const std::string&, InterruptedRun&, Simulation<2>&);
template std::unique_ptr<RunFolder<3>> resumed_folder(const std::string&, InterruptedRun&, Simulation<3>&);

}  // namespace repose
