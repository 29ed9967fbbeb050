// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/run_folder.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "repose/run/analysis_file.hpp"
#include "repose/run/folders.hpp"
#include "repose/run/record_file.hpp"
#include "repose/run/summary.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace repose {

namespace {

constexpr const char* own_files[] = {"scene.toml", "run.h5", "analysis.h5", "summary.json"};
constexpr const char* own_folders[] = {"frames", "track", "checkpoints", "pictures"};

bool holds_a_run(const fs::path& path) { return is_there(path / "scene.toml") && is_there(path / "run.h5"); }

void clear_older_run(const fs::path& path) {
  for (const auto* name : own_folders) fs::remove_all(path / name);
  for (const auto* name : own_files) fs::remove(path / name);
  std::vector<fs::path> starts;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file() && entry.path().stem() == "start") starts.push_back(entry.path());
  }
  for (const auto& start : starts) fs::remove(start);
}

}  // namespace

std::vector<std::string> RunFolder::problems(const std::string& path, bool overwrite) {
  auto found = folder_problems(path);
  if (!found.empty() || !is_there(path) || fs::is_empty(path)) return found;
  if (!overwrite) return {fmt::format("{}: folder is not empty; choose another --out, or --overwrite", path)};
  if (!holds_a_run(path)) {
    return {fmt::format("{}: folder is not empty and holds no run, so --overwrite leaves it alone", path)};
  }
  return {};
}

RunFolder::RunFolder(std::string path, const Simulation& simulation) : path_(std::move(path)) {
  const auto ancestor = existing_ancestor(path_);
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  lock_ = std::make_unique<FolderLock>(path_);
  // The new start is written beside an older run, which goes only when nothing can fail any more.
  const std::string beside = path_ + "/new";
  const std::string target = path_;
  try {
    fs::create_directory(beside);
    path_ = beside;
    write_text_file(path_ + "/scene.toml", scene_text(simulation.scene()));
    write_run(simulation.record());
    const auto& start = simulation.scene().start;
    if (!start.from.empty()) fs::copy_file(start.path, fs::path(beside) / start.from);
    path_ = target;
    clear_older_run(path_);
    if (!start.from.empty()) fs::rename(fs::path(beside) / start.from, fs::path(path_) / start.from);
    for (const auto* name : own_files) fs::rename(fs::path(beside) / name, fs::path(path_) / name);
    fs::remove_all(beside);
  } catch (const std::exception& failure) {
    fs::remove_all(beside, error);
    for (auto made = fs::absolute(target); made != ancestor; made = made.parent_path()) fs::remove(made, error);
    std::string why = failure.what();
    if (why.starts_with(beside)) why.replace(0, beside.size(), target);
    throw InputError(why);
  }
}

RunFolder::RunFolder(std::string path, const Checkpoint& checkpoint, Simulation& simulation)
    : path_(std::move(path)), lock_(std::make_unique<FolderLock>(path_)) {
  const auto state = checkpoint.restore(simulation);
  for (std::size_t k = 0; k < state.frames; ++k) frames_.push_back(numbered(k));
  for (std::size_t k = 0; k < state.segments; ++k) segments_.push_back(numbered(k));
  moments_written_ = state.moments;
  next_slot_ = 1 - checkpoint.slot();
}

void RunFolder::pause(Simulation& simulation, bool last) {
  constexpr double least_between = 100.0;  // times what a checkpoint costs, so that it costs less than 1 %
  const double interval = simulation.scene().output.checkpoint;
  const auto seconds_since = [](Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
  };
  const double passed = seconds_since(last_pause_);
  const bool due = interval > 0.0 && passed >= interval && passed >= least_between * cost_;
  if (!due && !last) return;
  const auto start = Clock::now();
  write_checkpoint(path_, next_slot_, simulation, {frames_.size(), segments_.size(), moments_written_});
  next_slot_ = 1 - next_slot_;
  last_pause_ = Clock::now();
  cost_ = seconds_since(start);
}

void RunFolder::write(const Simulation& simulation, bool frame) {
  std::error_code error;
  if (simulation.track().size() > moments_written_) {
    fs::create_directories(path_ + "/track", error);
    const auto name = numbered(segments_.size());
    write_track_segment(fmt::format("{}/track/{}.h5", path_, name), simulation.track(), moments_written_);
    moments_written_ = simulation.track().size();
    segments_.push_back(name);
  }
  const auto record = simulation.record();
  if (frame) {
    fs::create_directories(path_ + "/frames", error);
    const auto name = numbered(frames_.size());
    Hdf5File file(fmt::format("{}/frames/{}.h5", path_, name));
    file.attribute("/", "time", record.facts.time);
    file.attribute("/", "steps", record.facts.steps);
    write_grains(file, record.grains);
    write_contacts(file, record.contacts);
    file.commit();
    frames_.push_back(name);
  }
  write_run(record);
  if (simulation.status() == Status::finished || simulation.status() == Status::failed) remove_checkpoints(path_);
}

void RunFolder::write_run(const Record& record) {
  write_record(path_ + "/run.h5", record, frames_, segments_);
  write_reading(path_, record, read(record));
}

void write_reading(const std::string& folder, const Record& record, const Reading& reading) {
  write_analysis(folder + "/analysis.h5", record, reading);
  write_text_file(folder + "/summary.json", summary_text(record, reading));
}

}  // namespace repose
