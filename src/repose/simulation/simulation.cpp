// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/simulation.hpp"

#include "repose/analysis/force_network.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/state.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/start.hpp"
#include "repose/scene/write.hpp"
#include "repose/simulation/methods.hpp"
#include "repose/simulation/sources/initial.hpp"
#include "repose/simulation/stops.hpp"
#include "repose/simulation/trouble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Grain-steps of a batch: about a second of one core.
constexpr double longest_batch = 1e7;
constexpr double least_cost = 20.0;  // of a step, in grain-steps

/// Drops grains that have left the box since the last row, and their contacts; returns how many there were.
template <int D>
std::int64_t drop_outside(const Box<D>& box, Grains<D>& grains, Contacts<D>& contacts) {
  std::vector<std::uint32_t> inside;
  std::vector<std::int64_t> left;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (!grain.fixed() && box.outside(grain.position)) {
      left.push_back(grains.id[k]);
    } else {
      inside.push_back(k);
    }
  }
  if (left.empty()) return 0;
  grains.reorder(inside);
  const auto has_left = [&](std::int64_t id) { return std::find(left.begin(), left.end(), id) != left.end(); };
  std::erase_if(contacts.list,
                [&](const auto& contact) { return has_left(contact.first) || has_left(contact.second); });
  return static_cast<std::int64_t>(left.size());
}

}  // namespace

template <int D>
Simulation<D>::Simulation(Scene scene, int threads)
    : scene_(with_own_start(std::move(scene))),
      team_(threads),
      grains_(initial_grains<D>(scene_)),
      method_(make_method<D>(scene_)),
      steps_(method_->time_steps()),
      source_(make_source<D>(scene_, steps_, grains_.id.empty() ? 0 : grains_.id.back() + 1)),
      apex_(scene_),
      loads_(scene_, steps_),
      end_(scene_.stop.time ? steps_.rounded(*scene_.stop.time) : infinity),
      placed_(static_cast<std::int64_t>(moving_count(grains_))),
      moving_(moving_count(grains_)),
      row_times_(scene_.output.series, steps_),
      base_forces_(grains_, scene_.output.window, 1e-9 * steps_.length),
      rest_(scene_, steps_),
      track_(Every(scene_.output.track, steps_)) {
  check_loads_on(grains_, scene_);
  method_->grains_added(grains_);
}

template <int D>
Advanced Simulation<D>::advance(double until, const Pause& pause) {
  if (std::isnan(until)) throw InputError("the time to advance to is not a number");
  struct Timer {
    explicit Timer(Simulation<D>& simulation) : timed(simulation) { timed.since_ = Clock::now(); }
    ~Timer() {
      timed.seconds_ = timed.wall_seconds();
      timed.since_.reset();
    }
    Simulation<D>& timed;
  } const timer(*this);
  const double end = steps_.nearest(until);
  if (!begun_) begin();
  while (status_ == Status::running && time() < end) {
    take_batch(end);
    if (status_ == Status::running && pause && !pause()) break;
  }
  return {time(), status_};
}

template <int D>
Advanced Simulation<D>::run(const Pause& pause) {
  advance(infinity, pause);
  if (status_ == Status::running) stop(Status::interrupted, "interrupted");
  return {time(), status_};
}

template <int D>
void Simulation<D>::begin() {
  begun_ = true;
  if (scene_.source->above_apex()) refresh();  // the first grain asks what stands
  release_due_grains();
  begin_due_loads();
  refresh();
  if (const auto remembered = contacts_at_start<D>(scene_); remembered.size() > 0) {
    method_->set_slip_displacements(grains_, remembered);
  }
  if (max_overlap(contacts()) > largest_overlap) stop(Status::failed, describe_trouble(*this));
}

template <int D>
void Simulation<D>::take_batch(double end) {
  const double before = time();
  const double next = next_due(end);  // now, if an observer has thrown before sources and loads had their turn
  const auto report = method_->advance(grains_, next, team_);
  REPOSE_ASSERT(next <= before || report.steps > 0 || time() > before || report.trouble || method_->complete());
  contacts_.reset();
  taken_ += report.steps;
  grain_steps_ += static_cast<double>(report.steps) * method_->grains_per_step(moving_);
  if (report.trouble) return stop(Status::failed, describe_trouble(*this));
  const bool out_of_time = time() >= end_;
  const bool complete = method_->complete();
  const bool at_rest = rests(before);
  const bool row = row_times_.after(before) <= time();
  const bool last = out_of_time || complete || at_rest;
  const bool extra_row = !row && last && (series().empty() || series().back().time < time());
  if (row || extra_row) {
    add_row();
  } else if (rest_.due_after(before) <= time()) {
    if (const auto found = stop_of_source(*this, *source_)) stop(found->status, found->message);
  }
  if (status_ == Status::running && at_rest) {
    stop(Status::finished,
         fmt::format("at rest: kinetic energy and net force of every grain below stop.at_rest = {} for output.window",
                     *scene_.stop.at_rest));
  }
  observe(before, last || status_ != Status::running);
  if (status_ == Status::running && complete) stop(Status::finished, "all grains are there");
  if (status_ == Status::running && out_of_time) {
    stop(Status::finished, fmt::format("reached stop.time = {}", *scene_.stop.time));
  }
  if (status_ != Status::running) return;
  release_due_grains();
  begin_due_loads();
}

/// The next time at which anything is due, at most `end`, and at most a batch away.
template <int D>
double Simulation<D>::next_due(double end) const {
  const double now = time();
  double next = std::min(
      {end, end_, row_times_.after(now), source_->due(), loads_.due(), track_.due_after(now), rest_.due_after(now)});
  if (steps_.equal()) {
    const double batch = longest_batch / (least_cost + method_->grains_per_step(grains_.size()));
    next = std::min(next, steps_.later(now, steps_.after(std::max(1L, static_cast<long>(batch)))));
  }
  for (const auto& observer : observers_) next = std::min(next, observer->due_after(now));
  return next;
}

/// Whether the last grain has come, no load is to begin, and everything has been at rest for long enough.
template <int D>
bool Simulation<D>::rests(double before) {
  if (rest_.due_after(before) > time() || !source_->done() || loads_.due() < infinity) return false;
  const Profile::Stage stage(profile(), "test of rest");
  drop_lost_grains();
  const auto unrest =
      largest_unrest(grains_, contacts(), loads_.acting(), scene_.template gravity_vector<D>(), scene_.grains.diameter);
  const bool lasts = rest_.lasts(unrest, time());
  // Base forces are averaged over the rest alone.
  if (rest_.has_just_begun(time())) base_forces_.record(grains_, time());
  return lasts;
}

template <int D>
void Simulation<D>::observe(double before, bool ends) {
  const Profile::Stage stage(profile(), "track and progress");
  const auto is_due = [&](const Observer<D>& observer) {
    return observer.due_after(before) <= time() || (ends && observer.due_at_end());
  };
  if (is_due(track_)) track_.observe(*this);
  for (const auto& observer : observers_) {
    if (is_due(*observer)) observer->observe(*this);
  }
}

template <int D>
void Simulation<D>::add(std::unique_ptr<Observer<D>> observer) {
  observers_.push_back(std::move(observer));
}

template <int D>
void Simulation<D>::observe_every(double interval, typename RegularObserver<D>::Use use) {
  if (!(interval > 0.0)) throw InputError(fmt::format("the interval of an observer = {}: must be > 0", interval));
  add(std::make_unique<RegularObserver<D>>(Every(interval, steps_), std::move(use)));
}

/// Adds a row to the series and stops where it calls for that.
template <int D>
void Simulation<D>::add_row() {
  const Profile::Stage stage(profile(), "time series");
  drop_lost_grains();
  base_forces_.record(grains_, time());
  series_.add_row(*this, *method_);
  if (const auto found = stop_after_row(*this, *source_)) stop(found->status, found->message);
}

template <int D>
void Simulation<D>::drop_lost_grains() {
  const auto box = make_box<D>(scene_);
  const auto has_left = [&](const auto& grain) { return !grain.fixed() && box.outside(grain.position); };
  if (std::any_of(grains_.line.begin(), grains_.line.end(), has_left)) refresh();
  moving_ = moving_count(grains_);
}

template <int D>
void Simulation<D>::refresh() {
  method_->refresh(grains_, team_);
  contacts_.reset();
}

template <int D>
void Simulation<D>::release_due_grains() {
  if (source_->due() > time()) return;
  const Profile::Stage stage(profile(), "sources");
  const auto apex = [this] {
    return apex_.height(time(), grains_, [this]() -> const Contacts<D>& { return contacts(); });
  };
  const SourceView view{apex, method_->walls()};
  if (!source_->release(grains_, time(), view)) return;
  method_->grains_added(grains_);
  contacts_.reset();
  moving_ = moving_count(grains_);
}

template <int D>
void Simulation<D>::begin_due_loads() {
  if (loads_.begin_due(time(), grains_)) method_->set_loads(loads_.acting());
}

template <int D>
const Contacts<D>& Simulation<D>::contacts() const {
  if (!contacts_) {
    const Profile::Stage stage(profile(), "contacts of the state");
    contacts_ = method_->contacts(grains_);
  }
  return *contacts_;
}

template <int D>
std::int64_t Simulation<D>::released() const {
  return source_->released() + method_->made();
}

/// Grains that have left when these are present.
template <int D>
std::int64_t Simulation<D>::lost_but(const Grains<D>& present) const {
  return placed_ + released() - static_cast<std::int64_t>(moving_count(present));
}

template <int D>
std::int64_t Simulation<D>::lost() const {
  return lost_but(grains_);
}

template <int D>
double Simulation<D>::wall_seconds() const {
  return seconds_ + (since_ ? std::chrono::duration<double>(Clock::now() - *since_).count() : 0.0);
}

template <int D>
void Simulation<D>::start_profile() {
  profile_ = std::make_unique<Profile>();
  method_->set_profile(profile());
}

template <int D>
void Simulation<D>::stop(Status status, std::string message) {
  status_ = status;
  message_ = std::move(message);
}

template <int D>
void Simulation<D>::exchange(Archive& archive) {
  double seconds = wall_seconds();
  archive.value("run/steps", taken_);
  archive.value("run/grain_steps", grain_steps_);
  archive.value("run/moving", moving_);
  archive.value("run/wall_seconds", seconds);
  loads_.exchange(archive);
  series_.exchange(archive, method_->walls().size(), followed_slices(scene_));
  base_forces_.exchange(archive);
  rest_.exchange(archive);
  source_->exchange(archive);
  apex_.exchange(archive);
  grains_.exchange(archive);
  method_->exchange(archive);
  if (archive.restoring()) seconds_ = seconds;
}

template <int D>
void Simulation<D>::restored(Track<D> track) {
  track_.restore(std::move(track));
  method_->restored(grains_, team_);
  contacts_.reset();
  begun_ = true;
}

template <int D>
Record<D> Simulation<D>::record() const {
  return record_of(grains_);
}

template <int D>
Record<D> Simulation<D>::last_record() {
  if (method_->supports() == nullptr) contacts();
  auto record = record_of(std::move(grains_));
  contacts_.reset();
  method_.reset();
  return record;
}

/// The record of the present state with these grains, which are those of the simulation. They may have been moved out.
template <int D>
Record<D> Simulation<D>::record_of(Grains<D> present) const {
  Record<D> record;
  record.scene = scene_;
  record.box = make_box<D>(scene_);
  record.walls = recorded_walls<D>(scene_, method_->walls(), time());
  const auto crossed = method_->wall_crossings(present);
  for (std::size_t w = 0; w < crossed.size(); ++w) record.walls[w].crossed = crossed[w];
  const double unit = scene_.base_force_unit();
  if (!scene_.base->wall(scene_)) record.base = base_forces_.profile(present, unit);
  auto& facts = record.facts;
  facts.lost = lost_but(present);
  if (const auto* supports = method_->supports()) {
    record.supports = *supports;
  } else {
    record.contacts = contacts();
    facts.lost += drop_outside(record.box, present, record.contacts);
  }
  record.grains = OrderedGrains<D>(std::move(present), record.box);
  facts.status = status_;
  facts.message = message_;
  facts.time = time();
  facts.time_step = steps_.length;
  facts.steps = taken_;
  facts.threads = threads();
  facts.wall_seconds = wall_seconds();
  facts.grain_steps = grain_steps_;
  facts.released = released();
  facts.support_force = base_forces_.force_on_supports(record.contacts);
  facts.state_hash = state_hash(*record.grains, contacts_of(record));
  facts.scene_hash = hash_of(scene_text(scene_));
  record.series = series_.rows();
  record.wall_series = series_.walls();
  record.column_series = series_.columns();
  record.column_slices = series_.slices();
  if (scene_.base->wall(scene_)) {
    record.base = floor_profile(*record.grains, record.contacts, base_wall, facts.time, unit);
  }
  record.track = track_.track();
  return record;
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace repose
