// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/profile.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/method.hpp"
#include "repose/record/record.hpp"
#include "repose/scene/scene.hpp"
#include "repose/simulation/apex.hpp"
#include "repose/simulation/base_forces.hpp"
#include "repose/simulation/loads.hpp"
#include "repose/simulation/observer.hpp"
#include "repose/simulation/rest.hpp"
#include "repose/simulation/series.hpp"
#include "repose/simulation/sources/source.hpp"
#include "repose/simulation/track_observer.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// Where an advance of a simulation ended.
struct Advanced {
  double time = 0.0;  ///< [T]
  Status status = Status::running;

  bool stopped() const { return status != Status::running; }
};

/// A scene at work: its method, source, loads, stops and observers. Neither the division of a run into advances nor its
/// observers change a bit of it.
template <int D = 2>
class Simulation {
 public:
  Simulation(Scene scene, int threads);

  /// Called after every batch of steps, about a second of one core at most; false ends the advance there.
  using Pause = std::function<bool()>;

  /// Advances to a time [T], or as near to it as the method can stop, or until a stop of the scene or trouble.
  Advanced advance(double until, const Pause& pause = {});

  /// Advances until a stop of the scene or trouble; a pause that ends it interrupts the run.
  Advanced run(const Pause& pause = {});

  /// Adds an observer; those of one time are called in the order in which they were added.
  void add(std::unique_ptr<Observer<D>> observer);

  /// Calls a function every `interval` of simulated time [T], > 0, in whole steps where the method's are equal. It sees
  /// the state before the source adds to it. What it throws ends the advance; the next one continues the run as if it
  /// had not. Throws InputError.
  void observe_every(double interval, typename RegularObserver<D>::Use use);

  /// All that changes in a run but the track, for a checkpoint; a simulation of the same scene can be given it.
  void exchange(Archive& archive);

  /// Called after `exchange` has given the state back.
  void restored(Track<D> track);

  const Scene& scene() const { return scene_; }
  const Grains<D>& grains() const { return grains_; }
  const Contacts<D>& contacts() const;
  const std::vector<WallState>& walls() const { return method_->walls(); }
  const std::vector<SeriesRow>& series() const { return series_.rows(); }
  const Track<D>& track() const { return track_.track(); }
  /// All that there is to know of the run so far.
  Record<D> record() const;
  /// The same for a run that ends here, without a copy of its grains. Afterwards the simulation cannot continue; only
  /// its scene, status and message may be asked for.
  Record<D> last_record();

  Status status() const { return status_; }
  const std::string& message() const { return message_; }  ///< why it stopped
  /// After trouble: what the method knows of it; else empty.
  std::string trouble_of_method() const { return method_->trouble(grains_); }
  double time() const { return method_->time(); }
  double time_step() const { return steps_.length; }  ///< [T] 0 where steps vary
  long steps() const { return taken_; }               ///< or events
  const TimeSteps& time_steps() const { return steps_; }
  std::size_t moving() const { return moving_; }  ///< grains that can move
  std::int64_t released() const;                  ///< grains, by the source or the method
  std::int64_t lost() const;                      ///< grains that have left
  int threads() const { return team_.size(); }
  double grain_steps() const { return grain_steps_; }  ///< moving grains times steps
  double wall_seconds() const;                         ///< in advances, those before a checkpoint too

  /// Counts the time of all stages of the run from now on. No bit of it depends on that.
  void start_profile();
  Profile* profile() const { return profile_.get(); }  ///< null where none is kept

 private:
  void begin();
  void take_batch(double end);
  double next_due(double end) const;
  bool rests(double before);
  void add_row();
  void observe(double before, bool ends);
  void release_due_grains();
  void begin_due_loads();
  void drop_lost_grains();
  void refresh();
  void stop(Status status, std::string message);
  Record<D> record_of(Grains<D> present) const;
  std::int64_t lost_but(const Grains<D>& present) const;

  Scene scene_;
  Team team_;
  Grains<D> grains_;
  std::unique_ptr<Method<D>> method_;
  TimeSteps steps_;
  std::unique_ptr<Source<D>> source_;
  Apex<D> apex_;
  Loads<D> loads_;
  double end_;               // [T] stop.time, in whole steps; infinity without it
  std::int64_t placed_ = 0;  // moving grains at the start
  std::size_t moving_ = 0;
  long taken_ = 0;  // steps or events
  double grain_steps_ = 0.0;
  mutable std::optional<Contacts<D>> contacts_;  // of the present state, once they have been asked for

  Every row_times_;
  Series<D> series_;
  BaseForces<D> base_forces_;
  Rest rest_;
  TrackObserver<D> track_;
  std::vector<std::unique_ptr<Observer<D>>> observers_;
  std::unique_ptr<Profile> profile_;

  Status status_ = Status::running;
  std::string message_;
  bool begun_ = false;
  using Clock = std::chrono::steady_clock;
  double seconds_ = 0.0;                    // of wall time, in advances that have ended
  std::optional<Clock::time_point> since_;  // start of the present advance
};

}  // namespace repose
