// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/run_answers.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/run_folder/moments.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/view/base_arrays.hpp"
#include "repose/view/field_arrays.hpp"
#include "repose/view/run_text.hpp"
#include "repose/view/series_arrays.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

namespace repose {

namespace {

Moment<2> last_moment(const Record<2>& run) {
  Moment<2> moment{run.facts.time, run.facts.steps, run.grains, {}};
  contacts_of(run).for_each(
      [&](const auto& block) { moment.contacts.list.insert(moment.contacts.list.end(), block.begin(), block.end()); });
  return moment;
}

/// The box around the grains in contact, or around all where there is no contact: grains in flight do not widen it, nor
/// do base grains beside the heap.
void box_around(const Moment<2>& moment, Vec<2>& low, Vec<2>& high) {
  std::vector<char> in_contact(moment.grains.size(), 0);
  for (const auto& contact : moment.contacts.list) {
    for (const auto id : {contact.first, contact.second}) {
      if (id >= 0) in_contact[*moment.grains.find(id)] = 1;
    }
  }
  const bool any = std::find(in_contact.begin(), in_contact.end(), 1) != in_contact.end();
  bool first = true;
  for (std::size_t k = 0; k < moment.grains.size(); ++k) {
    if (any && in_contact[k] == 0) continue;
    const auto& grain = moment.grains->line[k];
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] =
          first ? grain.position[axis] - grain.radius : std::min(low[axis], grain.position[axis] - grain.radius);
      high[axis] =
          first ? grain.position[axis] + grain.radius : std::max(high[axis], grain.position[axis] + grain.radius);
    }
    first = false;
  }
}

bool is_key(const std::string& key) {
  return key == "last" || (!key.empty() && key.size() < 20 &&
                           std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isdigit(c) != 0; }));
}

}  // namespace

std::string file_version(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return "";
  return fmt::format("{}.{} {} {}", found.st_mtim.tv_sec, found.st_mtim.tv_nsec, found.st_size, found.st_ino);
}

RunAnswers::Run RunAnswers::run() {
  const auto path = folder_ + "/run.h5";
  const auto version = file_version(path);
  if (version.empty()) throw InputError(fmt::format("{}: holds no run", folder_));
  const std::lock_guard lock(mutex_);
  if (run_ && version == version_) return run_;
  auto fresh = std::make_shared<Record<2>>(read_last_state<2>(folder_));
  const Hdf5Reader file(path);
  check_belongs(file, fresh->facts);
  read_series(file, *fresh);
  if (fresh->facts.scene_hash != scene_) extents_.clear();
  scene_ = fresh->facts.scene_hash;
  version_ = version;
  run_ = fresh;
  return run_;
}

RunAnswers::Extent RunAnswers::extent_of(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = extents_.find(name); found != extents_.end()) return found->second;
  }
  const auto moment = read_frame(frame_path(folder_, name), *run());
  Extent extent{moment.time, {}, {}};
  box_around(moment, extent.low, extent.high);
  const std::lock_guard lock(mutex_);
  return extents_[name] = extent;
}

std::vector<std::string> RunAnswers::frames_before_the_last(const Record<2>& run) {
  std::vector<std::string> names;
  for (const auto& name : saved_frames(folder_)) {
    try {
      if (extent_of(name).time < run.facts.time) names.push_back(name);
    } catch (const InputError&) {  // a damaged frame is left out; `repose resume` and `repose export` name it
    }
  }
  return names;
}

std::vector<std::string> RunAnswers::keys() {
  auto names = frames_before_the_last(*run());
  names.emplace_back("last");
  return names;
}

nlohmann::ordered_json RunAnswers::state() {
  const auto last = run();
  return {{"status", status_text(last->facts.status)},
          {"frames", saved_frames(folder_).size() + 1},
          {"rows", last->series.size()},
          {"time", last->facts.time}};
}

std::string RunAnswers::frame(const std::string& key, Precision precision) {
  const auto last = run();
  const bool forces = last->scene.method->traits().has_forces();
  if (key == "last") return frame_arrays(key, last_moment(*last), last->walls, forces, precision);
  const auto moment = read_frame(frame_path(folder_, key), *last);
  return frame_arrays(key, moment, walls_at(*last, moment.time), forces, precision);
}

std::string RunAnswers::run_text() {
  const auto last = run();
  RunBox box;
  box_around(last_moment(*last), box.low, box.high);
  std::vector<FrameTime> frames;
  for (const auto& name : frames_before_the_last(*last)) {
    const auto extent = extent_of(name);
    frames.push_back({name, extent.time});
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], extent.low[axis]);
      box.high[axis] = std::max(box.high[axis], extent.high[axis]);
    }
  }
  frames.push_back({"last", last->facts.time});
  return describe_run(folder_, *last, frames, box);
}

Answer RunAnswers::answer(const std::string& address) try {
  if (address == "run") return json_answer(run_text());
  if (address == "series") return arrays_answer(series_arrays(*run()));
  if (address == "base") return arrays_answer(base_arrays(folder_, run()->scene));
  if (address == "fields") return arrays_answer(field_arrays(folder_));
  if (address == "summary") return json_answer(text_of_file(folder_ + "/summary.json"));
  if (address.starts_with("frame/")) {
    const auto key = address.substr(6);
    if (is_key(key)) return arrays_answer(frame(key));
  }
  return nothing(fmt::format("{}: no such address", address));
} catch (const InputError& error) {
  return nothing(error.what());
}

}  // namespace repose
