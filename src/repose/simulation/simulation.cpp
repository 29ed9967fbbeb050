// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/simulation.hpp"

#include "repose/analysis/force_network.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/io/state.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/methods.hpp"
#include "repose/simulation/sources/initial.hpp"
#include "repose/simulation/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <unordered_map>

namespace repose {

namespace {

/// Beyond this the centres are closer than a quarter of the mean diameter: no law is meant for that.
constexpr double largest_overlap = 0.75;

/// Grain-steps after which the program looks up: whether it is to stop. About a second of one core.
constexpr double longest_spell = 1e7;
constexpr double least_cost = 20.0;  // of a step, in grain-steps

/// The scene as it is kept with the run: a copy of what it starts from lies beside it.
Scene as_kept(Scene scene) {
  auto& start = scene.start;
  if (!start.from.empty()) start.from = "start" + std::filesystem::path(start.path).extension().string();
  return scene;
}

/// Of the grains that are marked; 0 where there are none.
double median_speed(const Grains<2>& grains, const std::vector<bool>& marked) {
  std::vector<double> speeds;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (marked[k] && !grains.line[k].fixed()) speeds.push_back(magnitude(grains.line[k].velocity));
  }
  if (speeds.empty()) return 0.0;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle;
}

}  // namespace

Simulation::Simulation(Scene scene, int threads)
    : scene_(as_kept(std::move(scene))),
      team_(threads),
      grains_(initial_grains(scene_)),
      method_(make_method(scene_)),
      time_step_(method_->time_step()),
      source_(make_source(scene_, time_step_, grains_.id.empty() ? 0 : grains_.id.back() + 1)),
      placed_(static_cast<std::int64_t>(moving_count(grains_))),
      observe_every_(steps_in(scene_.output.series, time_step_)),
      frame_every_(observations_in(scene_.output.frames)),
      track_every_(observations_in(scene_.output.track)) {
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    if (grains_.line[k].fixed()) fixed_ids_.push_back(grains_.id[k]);
  }
  moving_ = moving_count(grains_);
  by_start_ = scene_.loads;
  std::stable_sort(by_start_.begin(), by_start_.end(), [](const auto& a, const auto& b) { return a.start < b.start; });
  method_->grains_added(grains_);
}

long Simulation::observations_in(double time) const {
  return time > 0.0 ? steps_in(time, static_cast<double>(observe_every_) * time_step_) : 0;
}

double Simulation::wall_seconds() const {
  return earlier_seconds_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

std::int64_t Simulation::released() const { return source_->released() + method_->made(); }

std::int64_t Simulation::grains_lost() const {
  return placed_ + released() - static_cast<std::int64_t>(moving_count(grains_));
}

long Simulation::next_stop() const {
  const double spell = longest_spell / (least_cost + method_->grains_per_step(grains_.size()));
  long next = step_ + std::max(1L, static_cast<long>(spell));
  next = std::min(next, (step_ / observe_every_ + 1) * observe_every_);
  if (!source_->done()) next = std::min(next, source_->next_step());
  if (scene_.stop.time) next = std::min(next, steps_in(*scene_.stop.time, time_step_));
  if (loads_begun_ < by_start_.size()) {
    next = std::min(next, std::max(step_ + 1, steps_in(by_start_[loads_begun_].start, time_step_)));
  }
  return next;
}

void Simulation::release_due_grains() {
  if (source_->done() || source_->next_step() > step_) return;
  if (!source_->release(grains_, step_, [this] { return apex(); })) return;
  method_->grains_added(grains_);
  moving_ = moving_count(grains_);
}

double Simulation::apex() const {
  const auto touching = supported(grains_, contacts());
  double highest = 0.0;
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    const auto& grain = grains_.line[k];
    if (touching[k]) highest = std::max(highest, grain.position[1] + grain.radius);
  }
  return highest;
}

void Simulation::begin() {
  if (scene_.source->above_apex()) method_->refresh(grains_, team_);  // the first grain asks what touches
  release_due_grains();
  apply_due_loads();
  method_->refresh(grains_, team_);
  if (const auto remembered = contacts_at_start(scene_); remembered.size() > 0) {
    method_->set_histories(grains_, remembered);
  }
  if (const auto start = contacts(); max_overlap(start) > largest_overlap) {
    stop(Status::failed, describe_trouble(start));
  }
}

void Simulation::exchange(Archive& archive) {
  double seconds = wall_seconds();
  archive.value("run/step", step_);
  archive.value("run/grain_steps", grain_steps_);
  archive.value("run/moving", moving_);
  archive.value("run/wall_seconds", seconds);
  archive.value("run/loads_begun", loads_begun_);
  archive.array("run/loads", loads_);
  archive.array("run/series", series_);
  archive.array("run/walls", walls_);
  std::vector<double> times;
  std::vector<Vec<2>> impulses;
  for (const auto& stretch : window_) {
    times.insert(times.end(), {stretch.start, stretch.end});
    impulses.insert(impulses.end(), stretch.impulse.begin(), stretch.impulse.end());
  }
  archive.array("run/window_times", times);
  archive.array("run/window_impulses", impulses);
  source_->exchange(archive);
  grains_.exchange(archive);
  method_->exchange(archive);
  if (!archive.restoring()) return;
  archive.check("run/window_impulses", 2 * impulses.size() == times.size() * fixed_ids_.size());
  archive.check("run/walls", walls_.size() == series_.size() * method_->walls().size());
  earlier_seconds_ = seconds;
  window_.clear();
  for (std::size_t k = 0; 2 * k + 1 < times.size(); ++k) {
    const auto begin = impulses.begin() + static_cast<std::ptrdiff_t>(k * fixed_ids_.size());
    window_.push_back(
        {times[2 * k], times[2 * k + 1], {begin, begin + static_cast<std::ptrdiff_t>(fixed_ids_.size())}});
  }
}

void Simulation::restored(Track track) {
  track_ = std::move(track);
  method_->restored(grains_, team_);
  restored_ = true;
}

void Simulation::run(const Hooks& hooks, const std::atomic<bool>& interrupt) {
  started_ = std::chrono::steady_clock::now();
  if (!restored_) begin();
  while (status_ == Status::running) {
    const auto report = method_->advance(grains_, next_stop() - step_, team_);
    step_ += report.steps;
    grain_steps_ += static_cast<double>(report.steps) * method_->grains_per_step(moving_);
    if (report.trouble) {
      stop(Status::failed, describe_trouble(contacts()));
      break;
    }
    const bool out_of_time = scene_.stop.time && step_ >= steps_in(*scene_.stop.time, time_step_);
    const bool complete = method_->complete();
    if (step_ % observe_every_ == 0 || out_of_time || complete) observe(hooks);
    if (status_ == Status::running && complete) stop(Status::finished, "all grains are there");
    if (status_ == Status::running && out_of_time) {
      stop(Status::finished, fmt::format("reached stop.time = {}", *scene_.stop.time));
    }
    if (status_ != Status::running) break;
    release_due_grains();
    apply_due_loads();
    const bool last = interrupt;
    if (hooks.pause) hooks.pause(*this, last);
    if (last) stop(Status::interrupted, "interrupted");
  }
}

void Simulation::observe(const Hooks& hooks) {
  const auto box = make_box(scene_);
  const auto has_left = [&](const auto& grain) { return !grain.fixed() && box.outside(grain.position); };
  if (std::any_of(grains_.line.begin(), grains_.line.end(), has_left)) method_->refresh(grains_, team_);
  moving_ = moving_count(grains_);
  record_reactions();
  // Geometry alone holds deposited discs: there are no forces to look at on the way.
  const auto contacts = scene_.method->traits().has_forces() ? method_->contacts(grains_) : Contacts<2>{};
  SeriesRow row;
  row.time = time();
  row.grains = static_cast<std::int64_t>(moving_);
  const double threshold = scene_.analysis.force_threshold * scene_.grain_weight();
  row.contacts = std::count_if(contacts.list.begin(), contacts.list.end(),
                               [&](const auto& contact) { return contact.normal_force > threshold; });
  row.kinetic_energy_per_grain = moving_ > 0 ? kinetic_energy(grains_) / static_cast<double>(moving_) : 0.0;
  row.force_residual = force_residual(grains_, contacts, Vec<2>{{0.0, -scene_.gravity}});
  row.max_overlap = max_overlap(contacts);
  row.lost = grains_lost();
  record_walls();
  if (scene_.output.energy) row.energy = method_->energy(grains_);
  const auto* solver = scene_.method->solver();
  if (solver != nullptr) {
    row.solver = method_->taken_solver_account();
    row.creep_rate = median_speed(grains_, supported(grains_, contacts));
  }
  series_.push_back(row);
  if (track_every_ > 0 && step_ / observe_every_ % track_every_ == 0) record_track(contacts);

  if (row.max_overlap > largest_overlap) {
    stop(Status::failed, describe_trouble(contacts));
  } else if (row.solver.unconverged > 0 && solver->stops()) {
    stop(Status::failed,
         fmt::format("{} of {} steps to time {:.6g} did not converge: worst residual {:.3g} of gravity "
                     "times time step, method.tolerance = {} (method.unconverged = \"error\")",
                     row.solver.unconverged, row.solver.steps, time(), row.solver.worst_residual, solver->tolerance));
  } else if (at_rest()) {
    stop(Status::finished, fmt::format("at rest: kinetic energy per grain and force residual below stop.at_rest = {}",
                                       *scene_.stop.at_rest));
  } else if (!source_->done() &&
             source_->waiting(step_) > source_->patience() * std::sqrt(scene_.grains.diameter / scene_.gravity)) {
    stop(Status::failed, source_->buried());
  }
  if (hooks.observed) hooks.observed(*this);
  if (hooks.frame && status_ == Status::running && frame_every_ > 0 && step_ / observe_every_ % frame_every_ == 0)
    hooks.frame(*this);
}

void Simulation::record_walls() {
  const auto impulses = method_->taken_wall_impulses();
  const double duration = time() - (series_.empty() ? 0.0 : series_.back().time);
  for (std::size_t w = 0; w < impulses.size(); ++w) {
    walls_.push_back({method_->walls()[w].displacement, impulses[w] * (1.0 / duration)});
  }
}

void Simulation::apply_due_loads() {
  bool changed = false;
  for (; loads_begun_ < scene_.loads.size(); ++loads_begun_) {
    const auto& load = by_start_[loads_begun_];
    if (load.start > time() + 1e-9 * time_step_) break;
    const auto grain = load.grain >= 0 ? load.grain : nearest_grain({{load.position[0], load.position[1]}});
    if (grain >= 0) loads_.push_back({grain, {{load.force[0], load.force[1]}}});
    changed = true;
  }
  if (changed) method_->set_loads(loads_);
}

std::int64_t Simulation::nearest_grain(const Vec<2>& place) const {
  std::int64_t nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  const auto box = make_box(scene_);
  for (const auto k : by_id(grains_)) {
    if (grains_.line[k].fixed()) continue;
    const Vec<2> d = separation(box.wrapped(grains_.line[k].position), box.wrapped(place), box);
    if (dot(d, d) >= least) continue;
    least = dot(d, d);
    nearest = grains_.id[k];
  }
  return nearest;
}

bool Simulation::at_rest() const {
  if (!scene_.stop.at_rest || !source_->done()) return false;
  const double energy_unit = scene_.grain_weight() * scene_.grains.diameter;
  const auto& now = series_.back();
  return now.kinetic_energy_per_grain < *scene_.stop.at_rest * energy_unit && now.force_residual < *scene_.stop.at_rest;
}

void Simulation::record_reactions() {
  Stretch stretch;
  stretch.start = window_.empty() ? 0.0 : window_.back().end;
  stretch.end = time();
  stretch.impulse.resize(fixed_ids_.size());
  for (std::size_t k = 0; k < grains_.size(); ++k) {
    if (!grains_.line[k].fixed()) continue;
    const auto place = std::lower_bound(fixed_ids_.begin(), fixed_ids_.end(), grains_.id[k]) - fixed_ids_.begin();
    stretch.impulse[static_cast<std::size_t>(place)] = grains_.reaction[k];
    grains_.reaction[k] = {};
  }
  window_.push_back(std::move(stretch));
  while (window_.size() > 1 && window_[1].start <= time() - scene_.output.window + 1e-9 * time_step_) {
    window_.pop_front();
  }
}

void Simulation::record_track(const Contacts<2>& contacts) {
  const auto box = make_box(scene_);
  const auto in_heap = supported(grains_, contacts);
  TrackMoment moment{time(), {}};
  moment.grains.reserve(moving_);
  for (const auto k : by_id(grains_)) {
    const auto& grain = grains_.line[k];
    if (grain.fixed()) continue;
    const auto place = box.wrapped(grain.position);
    moment.grains.push_back({grains_.id[k], static_cast<float>(place[0]), static_cast<float>(place[1]),
                             static_cast<float>(grain.radius), static_cast<float>(kinetic_energy(grain)), in_heap[k]});
  }
  track_.push_back(std::move(moment));
}

Record Simulation::record() const {
  Record record;
  record.scene = scene_;
  record.contacts = contacts();
  auto& facts = record.facts;
  facts.status = status_;
  facts.message = message_;
  facts.time = time();
  facts.time_step = time_step_;
  facts.steps = step_;
  facts.threads = threads();
  facts.wall_seconds = wall_seconds();
  facts.grain_steps = grain_steps_;
  facts.released = released();
  facts.lost = grains_lost();
  facts.support_force = force_on_supports(record.contacts);
  record.grains = grains_;
  if (!std::is_sorted(grains_.id.begin(), grains_.id.end())) record.grains.reorder(by_id(grains_));
  const auto box = make_box(scene_);
  for (auto& grain : record.grains.line) grain.position = box.wrapped(grain.position);
  facts.state_hash = state_hash(record.grains, record.contacts);
  record.series = series_;
  record.walls = walls_;
  record.base = base_profile();
  record.track = track_;
  return record;
}

BaseProfile Simulation::base_profile() const {
  BaseProfile profile;
  if (window_.empty()) return profile;
  profile.window_start = window_.front().start;
  profile.window_end = window_.back().end;
  const double scale = 1.0 / ((profile.window_end - profile.window_start) * scene_.grain_weight());
  for (const auto k : by_id(grains_)) {
    if (!grains_.base[k]) continue;
    const auto place = std::lower_bound(fixed_ids_.begin(), fixed_ids_.end(), grains_.id[k]) - fixed_ids_.begin();
    Vec<2> impulse;
    for (const auto& stretch : window_) impulse += stretch.impulse[static_cast<std::size_t>(place)];
    profile.id.push_back(grains_.id[k]);
    profile.x.push_back(grains_.line[k].position[0]);
    profile.normal.push_back(-impulse[1] * scale);
    profile.shear.push_back(impulse[0] * scale);
  }
  return profile;
}

double Simulation::force_on_supports(const Contacts<2>& contacts) const {
  double force = 0.0;
  if (!window_.empty()) {
    const double duration = window_.back().end - window_.front().start;
    for (const auto& stretch : window_) {
      for (const auto& impulse : stretch.impulse) force -= impulse[1] / duration;
    }
  }
  for (const auto& contact : contacts.list) {
    if (contact.second < 0) force += force_of(contact)[1];
  }
  return force;
}

void Simulation::stop(Status status, std::string message) {
  status_ = status;
  message_ = std::move(message);
}

std::string Simulation::describe_trouble(const Contacts<2>& contacts) const {
  if (!scene_.method->traits().follows_time) return fmt::format("disc {} finds no place to rest", method_->made());
  std::vector<std::string> found;
  for (const auto k : by_id(grains_)) {
    const auto& grain = grains_.line[k];
    const double speed = magnitude(grain.velocity);
    const bool finite = std::isfinite(speed) && std::isfinite(grain.position[0]) && std::isfinite(grain.position[1]);
    if (!finite) {
      found.push_back(fmt::format("grain {} is not a number", grains_.id[k]));
    } else if (speed * time_step_ >= grain.radius) {
      found.push_back(fmt::format("grain {} moves at {:.3g}, more than its radius in a step", grains_.id[k], speed));
    }
  }
  for (const auto& contact : contacts.list) {
    if (contact.relative_overlap <= largest_overlap) continue;
    found.push_back(fmt::format("grains {} and {} overlap by {:.2g} diameters", contact.first, contact.second,
                                contact.relative_overlap));
  }
  constexpr std::size_t most = 8;
  std::string text = fmt::format("the grains cannot be followed beyond time {:.6g} (step {}): ", time(), step_);
  for (std::size_t k = 0; k < std::min(most, found.size()); ++k) text += (k > 0 ? "; " : "") + found[k];
  if (found.size() > most) text += fmt::format("; and {} more", found.size() - most);
  return text + ". A smaller method.time_step, a stiffer contact or a lower fall may help";
}

}  // namespace repose
