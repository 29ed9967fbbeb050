// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/run_folder.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/failure.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/state.hpp"
#include "repose/record/record_file.hpp"
#include "repose/record/track_file.hpp"
#include "repose/results/analysis_file.hpp"
#include "repose/results/summary.hpp"
#include "repose/run_folder/further_analysis.hpp"
#include "repose/run_folder/profile.hpp"
#include "repose/scene/start.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace repose {

namespace {

constexpr const char* own_files[] = {"scene.toml", "run.h5", "analysis.h5", "summary.json"};
constexpr const char* profile_file = "profile.json";
constexpr const char* own_folders[] = {"frames", "track", "checkpoints", "export", "pictures"};

/// Where a new start is written, and its name once it is whole.
constexpr const char* unready = "new";
constexpr const char* ready = "ready";

bool holds_a_run(const fs::path& path) {
  return path_exists(path / ready) || (path_exists(path / "scene.toml") && path_exists(path / "run.h5"));
}

/// Empty but for a start that was cut off before it was whole.
bool holds_nothing(const fs::path& path) {
  return std::all_of(fs::directory_iterator(path), fs::directory_iterator{},
                     [](const auto& entry) { return entry.path().filename() == unready; });
}

/// What the run of a folder starts from, under whatever ending, and the surfaces of its walls.
std::vector<fs::path> start_files(const fs::path& path) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path)) {
    const auto stem = entry.path().stem().string();
    if (entry.is_regular_file() && (stem == "start" || stem.starts_with("surface-"))) files.push_back(entry.path());
  }
  return files;
}

/// Copies the files that walls consist of to where the scene of the run looks for them.
void copy_surfaces(const Scene& scene, const fs::path& to) {
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    const auto& shape = scene.pieces[k].shape;
    const auto from = shape ? shape->found_file() : std::string();
    if (!from.empty()) fs::copy_file(from, to / surface_file(k), fs::copy_options::overwrite_existing);
  }
}

void clear_older_run(const fs::path& path) {
  for (const auto* name : own_folders) fs::remove_all(path / name);
  for (const auto* name : own_files) fs::remove(path / name);
  fs::remove(path / profile_file);
  for (const auto& file : start_files(path)) fs::remove(file);
}

}  // namespace

std::vector<std::string> run_folder_problems(const std::string& path, bool overwrite) {
  auto found = folder_problems(path);
  if (!found.empty() || !path_exists(path) || holds_nothing(path)) return found;
  if (!overwrite) return {fmt::format("{}: folder is not empty; choose another --out, or --overwrite", path)};
  if (!holds_a_run(path)) {
    return {fmt::format("{}: folder is not empty and holds no run, so --overwrite leaves it alone", path)};
  }
  return {};
}

void complete_start(const std::string& path) {
  const auto start = fs::path(path) / ready;
  if (!path_exists(start)) return;
  // An older run goes first, so that as long as nothing of the start has been moved, some of it may still be there.
  if (std::all_of(std::begin(own_files), std::end(own_files), [&](auto* name) { return path_exists(start / name); })) {
    clear_older_run(path);
  }
  for (const auto* name : own_files) {
    if (path_exists(start / name)) fs::rename(start / name, fs::path(path) / name);
  }
  // What the run starts from last: were it there while the others are not, it would go with an older run.
  for (const auto& file : start_files(start)) fs::rename(file, fs::path(path) / file.filename());
  fs::remove_all(start);
}

template <int D>
RunFolder<D>::RunFolder(std::string path, const Simulation<D>& simulation, std::unique_ptr<FolderLock> lock)
    : path_(std::move(path)), lock_(std::move(lock)) {
  const auto ancestor = existing_ancestor(path_);
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  if (!lock_) lock_ = std::make_unique<FolderLock>(path_);
  // The new start is written beside an older run, which goes only when nothing can fail any more.
  const std::string beside = path_ + "/" + unready;
  const std::string whole = path_ + "/" + ready;
  const std::string target = path_;
  try {
    for (const auto& remains : {beside, whole}) fs::remove_all(remains);
    fs::create_directory(beside);
    path_ = beside;
    write_text_file(path_ + "/scene.toml", scene_text(simulation.scene()));
    write_run(simulation, simulation.record());
    const auto& start = simulation.scene().start;
    if (!start.from.empty()) fs::copy_file(start.path, fs::path(beside) / start.from);
    copy_surfaces(simulation.scene(), beside);
    path_ = target;
    fs::rename(beside, whole);
    complete_start(path_);
  } catch (const std::exception& failure) {
    for (const auto& remains : {beside, whole}) fs::remove_all(remains, error);
    for (auto made = fs::absolute(target); made != ancestor; made = made.parent_path()) fs::remove(made, error);
    std::string why = message_of(failure);
    if (why.starts_with(beside)) why.replace(0, beside.size(), target);
    throw InputError(why);
  }
}

template <int D>
RunFolder<D>::RunFolder(std::string path, const Checkpoint& checkpoint, Simulation<D>& simulation,
                        std::unique_ptr<FolderLock> lock)
    : path_(std::move(path)), lock_(std::move(lock)) {
  const auto state = checkpoint.restore(simulation);
  for (std::size_t k = 0; k < state.frames; ++k) frames_.push_back(numbered(k));
  for (std::size_t k = 0; k < state.segments; ++k) segments_.push_back(numbered(k));
  moments_written_ = state.moments;
  next_slot_ = 1 - checkpoint.slot();
}

/// Writes the state at regular times.
template <int D>
class RunFolder<D>::Frames final : public Observer<D> {
 public:
  Frames(RunFolder<D>& folder, const Every& times) : folder_(folder), times_(times) {}

  double due_after(double time) const override { return times_.after(time); }
  void observe(const Simulation<D>& simulation) override {
    if (simulation.status() != Status::running) return;
    const Profile::Stage stage(simulation.profile(), "frames");
    auto record = simulation.record();
    folder_.lock_->check_place();
    folder_.write_track(simulation);
    folder_.write_frame(record);
    folder_.write_run(simulation, std::move(record));
  }

 private:
  RunFolder<D>& folder_;
  Every times_;
};

template <int D>
void RunFolder<D>::run(Simulation<D>& simulation, const std::atomic<bool>& interrupt) {
  simulation.add(std::make_unique<Frames>(*this, Every(simulation.scene().output.frames, simulation.time_steps())));
  simulation.run([&] {
    const bool last = interrupt;
    lock_->check_place();
    keep(simulation, last);
    return !last;
  });
}

/// Writes a checkpoint if one is due by wall time, or now. An older checkpoint stays if that fails.
template <int D>
void RunFolder<D>::keep(Simulation<D>& simulation, bool now) {
  constexpr double least_between = 100.0;  // times what a checkpoint costs, so that it costs less than 1 %
  const double interval = simulation.scene().output.checkpoint;
  const auto seconds_since = [](Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
  };
  const double passed = seconds_since(last_pause_);
  const bool due = interval > 0.0 && passed >= interval && passed >= least_between * cost_;
  if (!due && !now) return;
  const Profile::Stage stage(simulation.profile(), "checkpoints");
  const auto start = Clock::now();
  write_checkpoint(path_, next_slot_, simulation, {frames_.size(), segments_.size(), moments_written_});
  next_slot_ = 1 - next_slot_;
  last_pause_ = Clock::now();
  cost_ = seconds_since(start);
}

template <int D>
void RunFolder<D>::write_track(const Simulation<D>& simulation) {
  if (simulation.track().size() == moments_written_) return;
  std::error_code error;
  fs::create_directories(path_ + "/track", error);
  const auto name = numbered(segments_.size());
  write_track_segment(fmt::format("{}/track/{}.h5", path_, name), hash_of(scene_text(simulation.scene())),
                      simulation.track(), moments_written_);
  moments_written_ = simulation.track().size();
  segments_.push_back(name);
}

template <int D>
void RunFolder<D>::write_frame(const Record<D>& record) {
  std::error_code error;
  fs::create_directories(path_ + "/frames", error);
  const auto name = numbered(frames_.size());
  Hdf5File file(fmt::format("{}/frames/{}.h5", path_, name), record.scene.units);
  file.attribute("/", "time", record.facts.time);
  file.attribute("/", "steps", record.facts.steps);
  file.attribute("/", "state_hash", record.facts.state_hash);
  file.attribute("/", "scene_hash", record.facts.scene_hash);
  write_grains(file, record.grains);
  write_contacts(file, contacts_of(record), record.grains, record.scene.method->traits().has_forces());
  file.commit();
  frames_.push_back(name);
}

template <int D>
void RunFolder<D>::write(const Simulation<D>& simulation, const Written& written) {
  lock_->check_place();
  write_track(simulation);
  write_run(simulation, simulation.record(), written);
  remove_needless_checkpoints(simulation.status());
}

template <int D>
void RunFolder<D>::write_last(Simulation<D>& simulation, const Written& written) {
  lock_->check_place();
  write_track(simulation);
  write_run(simulation, simulation.last_record(), written);
  remove_needless_checkpoints(simulation.status());
}

template <int D>
void RunFolder<D>::remove_needless_checkpoints(Status status) {
  if (status == Status::finished || status == Status::failed) remove_checkpoints(path_);
}

template <int D>
void RunFolder<D>::write_profile(const Simulation<D>& simulation) {
  lock_->check_place();
  write_text_file(path_ + "/" + profile_file, profile_text(simulation));
}

template <int D>
void RunFolder<D>::write_run(const Simulation<D>& simulation, Record<D> record, const Written& written) {
  const Profile::Stage stage(simulation.profile(), "writing");
  lock_->check_place();
  write_record(path_ + "/run.h5", record, frames_, segments_);
  record.supports = std::vector<SupportPair>();  // gives its memory back: the analysis finds contacts by geometry
  const auto results = [&] {
    const Profile::Stage inner(simulation.profile(), "analysis");
    return analyse(record, {});
  }();
  write_results(path_, *lock_, record, results);
  if (written) written(record, results);
}

template <int D>
void write_results(const std::string& folder, const FolderLock& lock, const Record<D>& record,
                   const Results<D>& results) {
  lock.check_place();
  write_analysis(folder + "/analysis.h5", record, results);
  lock.check_place();
  write_text_file(folder + "/summary.json", summary_text(record, results));
}

template class RunFolder<2>;
template class RunFolder<3>;
template void write_results(const std::string&, const FolderLock&, const Record<2>&, const Results<2>&);
template void write_results(const std::string&, const FolderLock&, const Record<3>&, const Results<3>&);

}  // namespace repose
