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
constexpr const char* own_folders[] = {"frames", "track", "pictures"};

bool holds_a_run(const fs::path& path) { return is_there(path / "scene.toml") && is_there(path / "run.h5"); }

void clear_older_run(const fs::path& path) {
  for (const auto* name : own_folders) fs::remove_all(path / name);
  for (const auto* name : own_files) fs::remove(path / name);
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
  // The new start is written beside an older run, which goes only when nothing can fail any more.
  const std::string beside = path_ + "/new";
  const std::string target = path_;
  try {
    fs::create_directory(beside);
    path_ = beside;
    write_text_file(path_ + "/scene.toml", scene_text(simulation.scene()));
    write_run(simulation.record());
    path_ = target;
    clear_older_run(path_);
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

void RunFolder::write(const Simulation& simulation, bool frame) {
  std::error_code error;
  if (simulation.track().size() > moments_written_) {
    fs::create_directories(path_ + "/track", error);
    const auto name = fmt::format("{:06}", segments_.size());
    write_track_segment(fmt::format("{}/track/{}.h5", path_, name), simulation.track(), moments_written_);
    moments_written_ = simulation.track().size();
    segments_.push_back(name);
  }
  const auto record = simulation.record();
  if (frame) {
    fs::create_directories(path_ + "/frames", error);
    const auto name = fmt::format("{:06}", frames_.size());
    Hdf5File file(fmt::format("{}/frames/{}.h5", path_, name));
    file.attribute("/", "time", record.facts.time);
    file.attribute("/", "steps", record.facts.steps);
    write_grains(file, record.grains);
    write_contacts(file, record.contacts);
    file.commit();
    frames_.push_back(name);
  }
  write_run(record);
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
