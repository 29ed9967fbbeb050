// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/hdf5_reader.hpp"
#include "repose/simulation/simulation.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace repose {

/// What a run folder held when a checkpoint was made.
struct FolderState {
  std::size_t frames = 0;
  std::size_t segments = 0;  ///< of the track
  std::size_t moments = 0;   ///< of the track, in these segments
};

/// Writes checkpoint number `slot` (0 or 1) of a run folder. Throws RunError.
template <int D>
void write_checkpoint(const std::string& folder, int slot, Simulation<D>& simulation, const FolderState& state);

/// A checkpoint that is whole.
class Checkpoint {
 public:
  /// The latest of a run folder; none if there is none. Those that are damaged are named in `damaged`, one line each.
  static std::unique_ptr<Checkpoint> latest(const std::string& folder, std::vector<std::string>& damaged);

  int slot() const { return slot_; }
  const std::string& scene() const { return scene_; }  ///< its text
  std::size_t frames() const { return state_.frames; }

  /// Gives a fresh simulation of the scene the state back, and says what the folder held. Throws InputError if a part
  /// of the run folder is missing or damaged.
  template <int D>
  FolderState restore(Simulation<D>& simulation) const;

 private:
  Checkpoint(const std::string& folder, int slot);

  std::string folder_;
  int slot_;
  Hdf5Reader file_;
  std::string scene_;
  long step_ = 0;
  FolderState state_;
};

/// Which of the first `count` frames of a run folder are damaged or missing, one line each.
std::vector<std::string> damaged_frames(const std::string& folder, std::size_t count);

/// Deletes the checkpoints of a run folder.
void remove_checkpoints(const std::string& folder);

/// Name of a numbered file of a run folder.
std::string numbered(std::size_t number);

}  // namespace repose
