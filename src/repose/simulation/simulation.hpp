// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/method.hpp"
#include "repose/record/record.hpp"
#include "repose/scene/scene.hpp"
#include "repose/simulation/sources/source.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace repose {

/// A scene at work: its method, source, stops and observers.
class Simulation {
 public:
  Simulation(Scene scene, int threads);

  /// What to do at every observation, and where a frame is due.
  struct Hooks {
    std::function<void(const Simulation&)> observed;
    std::function<void(const Simulation&)> frame;
    std::function<void(Simulation&, bool last)> pause;  ///< the state may be kept now; `last`: the run is interrupted
  };

  /// Runs until a stop of the scene, trouble, or `interrupt` becomes true.
  void run(const Hooks& hooks, const std::atomic<bool>& interrupt);

  /// All that changes while it runs but the track, for a checkpoint; a simulation of the same scene can be given it.
  void exchange(Archive& archive);

  /// To be called after `exchange` has given the state back.
  void restored(Track track);

  const Scene& scene() const { return scene_; }
  const Grains<2>& grains() const { return grains_; }
  Contacts<2> contacts() const { return method_->contacts(grains_); }
  const std::vector<SeriesRow>& series() const { return series_; }
  const Track& track() const { return track_; }
  /// All that there is to know of the run so far.
  Record record() const;

  Status status() const { return status_; }
  const std::string& message() const { return message_; }  ///< why it stopped
  double time() const { return static_cast<double>(step_) * time_step_; }
  double time_step() const { return time_step_; }
  long steps() const { return step_; }
  int threads() const { return team_.size(); }
  double grain_steps() const { return grain_steps_; }  ///< moving grains times steps
  double wall_seconds() const;

 private:
  /// Force on the fixed grains over one stretch between observations.
  struct Stretch {
    double start = 0.0;
    double end = 0.0;
    std::vector<Vec<2>> impulse;  // per fixed grain, by id order
  };

  void begin();
  double apex() const;
  long observations_in(double time) const;
  long next_stop() const;
  void release_due_grains();
  void observe(const Hooks& hooks);
  void record_reactions();
  void record_walls();
  void apply_due_loads();
  std::int64_t nearest_grain(const Vec<2>& place) const;
  void record_track(const Contacts<2>& contacts);
  BaseProfile base_profile() const;
  double force_on_supports(const Contacts<2>& contacts) const;
  std::int64_t released() const;
  std::int64_t grains_lost() const;
  bool at_rest() const;
  void stop(Status status, std::string message);
  std::string describe_trouble(const Contacts<2>& contacts) const;

  Scene scene_;
  Team team_;
  Grains<2> grains_;
  std::unique_ptr<Method<2>> method_;
  double time_step_;
  std::unique_ptr<Source> source_;
  std::vector<Scene::Load> by_start_;  // the loads of the scene in the order in which they begin
  std::size_t loads_begun_ = 0;
  std::vector<Load<2>> loads_;
  std::int64_t placed_ = 0;  // moving grains at the start
  std::vector<std::int64_t> fixed_ids_;
  long observe_every_;
  long frame_every_;  // in observations; 0: never
  long track_every_;  // in observations; 0: never
  long step_ = 0;
  double grain_steps_ = 0.0;
  std::size_t moving_ = 0;
  std::deque<Stretch> window_;
  std::vector<SeriesRow> series_;
  std::vector<WallRow> walls_;  // per row of the series and wall
  Track track_;
  Status status_ = Status::running;
  std::string message_;
  double earlier_seconds_ = 0.0;  // of wall time, before the run was taken up again
  bool restored_ = false;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace repose
