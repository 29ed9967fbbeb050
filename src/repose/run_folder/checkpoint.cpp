// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/checkpoint.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/hdf5_archive.hpp"
#include "repose/io/seal.hpp"
#include "repose/record/record_file.hpp"
#include "repose/record/track_file.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace repose {

namespace {

std::string path_of(const std::string& folder, int slot) { return fmt::format("{}/checkpoints/{}.h5", folder, slot); }

/// Moments of a track as arrays.
template <int D>
void exchange_track(Archive& archive, Track<D>& track) {
  std::vector<double> times;
  std::vector<std::size_t> counts;
  std::vector<TrackedGrain<D>> grains;
  for (const auto& moment : track) {
    times.push_back(moment.time);
    counts.push_back(moment.grains.size());
    grains.insert(grains.end(), moment.grains.begin(), moment.grains.end());
  }
  archive.array("track/times", times);
  archive.array("track/counts", counts);
  archive.array("track/grains", grains);
  if (!archive.restoring()) return;
  track.clear();
  std::size_t all = 0;
  for (const auto count : counts) all += std::min(count, grains.size() + 1);
  archive.check("track", counts.size() == times.size() && all == grains.size());
  auto next = grains.begin();
  for (std::size_t m = 0; m < times.size(); ++m) {
    const auto end = next + static_cast<std::ptrdiff_t>(counts[m]);
    track.push_back({times[m], {next, end}});
    next = end;
  }
}

}  // namespace

std::vector<std::string> damaged_frames(const std::string& folder, std::size_t count) {
  std::vector<std::string> damaged;
  for (std::size_t k = 0; k < count; ++k) {
    const auto path = fmt::format("{}/frames/{}.h5", folder, numbered(k));
    if (const auto broken = broken_seal(path); !broken.empty()) damaged.push_back(fmt::format("{}: {}", path, broken));
  }
  return damaged;
}

std::string numbered(std::size_t number) { return fmt::format("{:06}", number); }

template <int D>
void write_checkpoint(const std::string& folder, int slot, Simulation<D>& simulation, const FolderState& state) {
  std::error_code error;
  fs::create_directories(folder + "/checkpoints", error);
  Hdf5File file(path_of(folder, slot));
  file.attribute("/", "format", std::string("repose-checkpoint"));
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "steps", static_cast<std::int64_t>(simulation.steps()));
  file.attribute("/", "time", simulation.time());
  file.attribute("/", "frames", static_cast<std::int64_t>(state.frames));
  file.attribute("/", "segments", static_cast<std::int64_t>(state.segments));
  file.texts("scene", {scene_text(simulation.scene())}, "the scene of the run, complete");
  ArchiveWriter archive(file, "state");
  simulation.exchange(archive);
  const auto& track = simulation.track();
  Track<D> pending(track.begin() + static_cast<std::ptrdiff_t>(state.moments), track.end());
  exchange_track(archive, pending);
  file.commit();
}

Checkpoint::Checkpoint(const std::string& folder, int slot)
    : folder_(folder), slot_(slot), file_(path_of(folder, slot)) {
  if (file_.text("/", "format") != "repose-checkpoint" || file_.text("/", "repose_version") != version) {
    throw InputError(fmt::format("{}: not a checkpoint of this version of Repose", file_.path()));
  }
  const auto scene = file_.texts("scene");
  if (scene.empty()) throw InputError(fmt::format("{}: holds no scene", file_.path()));
  scene_ = scene.front();
  step_ = file_.integer("/", "steps");
  state_.frames = static_cast<std::size_t>(file_.integer("/", "frames"));
  state_.segments = static_cast<std::size_t>(file_.integer("/", "segments"));
}

std::unique_ptr<Checkpoint> Checkpoint::latest(const std::string& folder, std::vector<std::string>& damaged) {
  std::unique_ptr<Checkpoint> found;
  for (const int slot : {0, 1}) {
    if (!path_exists(path_of(folder, slot))) continue;
    try {
      std::unique_ptr<Checkpoint> one(new Checkpoint(folder, slot));
      if (!found || one->step_ > found->step_) found = std::move(one);
    } catch (const InputError& problem) {
      damaged.push_back(problem.problems().front());
    }
  }
  return found;
}

template <int D>
FolderState Checkpoint::restore(Simulation<D>& simulation) const {
  Track<D> track;
  FolderState state = state_;
  for (std::size_t k = 0; k < state_.segments; ++k) {
    read_track_segment(fmt::format("{}/track/{}.h5", folder_, numbered(k)), hash_of(scene_), track);
  }
  state.moments = track.size();
  ArchiveReader archive(file_, "state");
  simulation.exchange(archive);
  Track<D> pending;
  exchange_track(archive, pending);
  track.insert(track.end(), pending.begin(), pending.end());
  simulation.restored(std::move(track));
  return state;
}

void remove_checkpoints(const std::string& folder) {
  std::error_code error;
  fs::remove_all(folder + "/checkpoints", error);
}

template void write_checkpoint(const std::string&, int, Simulation<2>&, const FolderState&);
template void write_checkpoint(const std::string&, int, Simulation<3>&, const FolderState&);
template FolderState Checkpoint::restore(Simulation<2>&) const;
template FolderState Checkpoint::restore(Simulation<3>&) const;

}  // namespace repose
