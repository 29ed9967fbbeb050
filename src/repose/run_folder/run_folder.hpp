// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/folders.hpp"
#include "repose/results/results.hpp"
#include "repose/results/sphere_results.hpp"
#include "repose/run_folder/checkpoint.hpp"
#include "repose/simulation/simulation.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace repose {

/// Why a run cannot be written into a folder, one line for each reason; nothing is touched.
std::vector<std::string> run_folder_problems(const std::string& path, bool overwrite);

/// Moves a start that was written whole, but cut off before it was in its place, there; else does nothing. For the
/// holder of the lock.
void complete_start(const std::string& path);

/// The folder that a run writes; see docs/reference/run-folder.md.
template <int D = 2>
class RunFolder {
 public:
  /// Called with what was written.
  using Written = std::function<void(const Record<D>&, const Results<D>&)>;

  /// Makes the folder (or clears an older run out of it) and writes scene.toml and the state at the start. Throws
  /// InputError if that fails, and then leaves no half-written folder.
  /// The lock of a folder that is held already is handed over.
  RunFolder(std::string path, const Simulation<D>& simulation, std::unique_ptr<FolderLock> lock = nullptr);

  /// Resumes an older run where its checkpoint left it: `simulation` is given the state back.
  RunFolder(std::string path, const Checkpoint& checkpoint, Simulation<D>& simulation,
            std::unique_ptr<FolderLock> lock);

  /// Runs a simulation until it stops or `interrupt` becomes true, and writes its frames and checkpoints. Throws
  /// RunError.
  void run(Simulation<D>& simulation, const std::atomic<bool>& interrupt);

  /// Writes the present state and its analysis. Throws RunError; the files of an earlier state stay then.
  void write(const Simulation<D>& simulation, const Written& written = {});

  /// The same for a run that ends here (Simulation::last_record).
  void write_last(Simulation<D>& simulation, const Written& written);

  /// Writes profile.json, for a simulation whose profile has been started. Throws RunError.
  void write_profile(const Simulation<D>& simulation);

  /// Writes a checkpoint if one is due by wall time, or `now`. Throws RunError; an older checkpoint stays then.
  void keep(Simulation<D>& simulation, bool now);

  const std::string& path() const { return path_; }

 private:
  class Frames;

  void write_track(const Simulation<D>& simulation);
  void write_frame(const Record<D>& record);
  void write_run(const Simulation<D>& simulation, Record<D> record, const Written& written = {});
  void remove_needless_checkpoints(Status status);

  using Clock = std::chrono::steady_clock;

  std::string path_;
  std::unique_ptr<FolderLock> lock_;
  std::vector<std::string> frames_;
  std::vector<std::string> segments_;  // of the track
  std::size_t moments_written_ = 0;
  int next_slot_ = 0;  // of the next checkpoint
  Clock::time_point last_pause_ = Clock::now();
  double cost_ = 0.0;  // [s] of the last checkpoint
};

/// Writes what the analysis says, analysis.h5 and then summary.json, into a run folder that is locked. Throws RunError.
template <int D>
void write_results(const std::string& folder, const FolderLock& lock, const Record<D>& record,
                   const Results<D>& results);

}  // namespace repose
