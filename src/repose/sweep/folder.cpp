// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/folder.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/failure.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/io/named_file.hpp"
#include "repose/record/record_file.hpp"
#include "repose/results/column_layers.hpp"
#include "repose/results/summary.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/start.hpp"
#include "repose/scene/toml_text.hpp"
#include "repose/scene/write.hpp"
#include "repose/sweep/pooled_drops.hpp"
#include "repose/sweep/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;

namespace repose {

namespace {

constexpr const char* own_files[] = {"sweep.toml",  "table.csv",    "members.csv",  "claims.csv",
                                     "claims.json", "sweep.h5",     "response.csv", "response.json",
                                     "heights.csv", "heights.json", "drops.csv",    "summary.json"};
constexpr const char* own_folders[] = {"scenes", "members", "pictures", "leases", "slurm"};

/// The content of a file; "" if it cannot be read.
std::string content_of(const fs::path& path) {
  if (!why_not_readable(path.string()).empty()) return "";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Whether a folder has no more than a sweep leaves that was stopped before its sweep.toml was complete, or a batch
/// script that has not begun.
bool has_just_begun(const std::string& path) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const auto name = entry.path().filename().string();
    if (name != "scenes" && name != "sweep.toml.tmp" && name != "slurm") return false;
  }
  return !error;
}

/// Whether a folder has these files.
bool holds(const std::string& path, const std::vector<SweepFile>& files) {
  return std::all_of(files.begin(), files.end(), [&](const SweepFile& file) {
    const auto place = fs::path(path) / file.name;
    return file.copy_of.empty() ? content_of(place) == file.text : path_exists(place);
  });
}

/// Adds what the analysis of a member found beside its summary: the slices of its column, the drops of its slips.
void read_analysis(const std::string& path, MemberRow& row) {
  const Hdf5Reader file(path);
  if (file.has("column")) read_columns(file, "column", column_layers<2>(), row.column);
  if (file.has("slips")) row.drops = file.dataset<double>("slips/drop");
}

std::vector<Member> members_of(const SweepPlan& plan) {
  std::vector<Member> members;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    for (const auto seed : plan.seeds) members.push_back({p, seed});
  }
  return members;
}

std::string folder_of(const std::string& path, const SweepPlan& plan, const Member& member) {
  return fmt::format("{}/members/{}/seed-{}", path, plan.points[member.point].name, member.seed);
}

/// The scene of a member as its folder keeps it.
std::string text_of(const SweepPlan& plan, const Member& member) {
  Scene scene = plan.points[member.point].scene;
  scene.seed = member.seed;
  return scene_text(with_own_start(scene));
}

/// Names and values of all summaries side by side. Leaves out a name that is an object in another summary.
std::vector<std::string> union_of(const std::vector<std::vector<std::pair<std::string, double>>>& all) {
  std::vector<std::string> names;
  for (const auto& values : all) {
    for (const auto& [name, value] : values) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::vector<std::string> kept;
  for (const auto& name : names) {
    const auto inside = [&](const std::string& other) { return other.starts_with(name + "."); };
    if (std::none_of(names.begin(), names.end(), inside)) kept.push_back(name);
  }
  return kept;
}

}  // namespace

bool SweepFolder::is_one(const std::string& path) {
  std::error_code error;
  return fs::exists(fs::path(path) / "sweep.toml", error);
}

std::vector<std::string> SweepFolder::problems(const std::string& path, const SweepPlan& plan, bool overwrite) {
  auto found = folder_problems(path);
  std::error_code error;
  if (!found.empty() || !fs::exists(path, error) || fs::is_empty(path, error)) return found;
  if (!is_one(path) && has_just_begun(path)) return {};
  if (!is_one(path)) return {fmt::format("{}: folder is not empty and holds no sweep; choose another --out", path)};
  if (overwrite) return {};
  for (const auto& member : members_of(plan)) {
    const fs::path scene = fs::path(folder_of(path, plan, member)) / "scene.toml";
    if (!fs::exists(scene, error) || content_of(scene) == text_of(plan, member)) continue;
    found.push_back(
        fmt::format("{}: was made from another scene than this sweep's; choose another --out, or --overwrite",
                    scene.parent_path().string()));
    if (found.size() == 5) break;  // more would only repeat this
  }
  return found;
}

SweepFolder::SweepFolder(std::string path) : path_(std::move(path)) {
  if (!is_one(path_)) throw InputError(fmt::format("{}: holds no sweep: no sweep.toml", path_));
  plan_ = read_sweep(path_ + "/sweep.toml");
  members_ = members_of(plan_);
}

SweepFolder::SweepFolder(std::string path, const std::string& sweep_file, SweepPlan plan, bool overwrite,
                         SweepForm form, FolderLock::For writers)
    : path_(std::move(path)), plan_(std::move(plan)), members_(members_of(plan_)) {
  const auto files = self_contained(sweep_file, form);
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  constexpr double patience = 5.0;  // [s] members of a killed sweep may still hold the lock
  const auto start = std::chrono::steady_clock::now();
  // The first of several that share the folder writes the files alone; all then hold it together.
  while (writers == FolderLock::For::several && !(is_one(path_) && holds(path_, files))) {
    const bool late = std::chrono::steady_clock::now() - start > std::chrono::duration<double>(patience);
    try {
      lock_ = std::make_unique<FolderLock>(path_);
    } catch (const InputError&) {
      if (late) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      continue;
    }
    write_files(files, overwrite);
    lock_.reset();
  }
  lock_ = std::make_unique<FolderLock>(path_, patience, writers);
  if (writers == FolderLock::For::one) write_files(files, overwrite);
}

/// Removes an older sweep on request, and writes the sweep file and its scenes. The folder must be locked.
void SweepFolder::write_files(const std::vector<SweepFile>& files, bool overwrite) const {
  // Another sweep may have been here until now.
  if (const auto found = problems(path_, plan_, overwrite); !found.empty()) throw InputError(found);
  std::error_code error;
  if (overwrite && is_one(path_)) {
    for (const auto* name : own_folders) fs::remove_all(fs::path(path_) / name, error);
    for (const auto* name : own_files) fs::remove(fs::path(path_) / name, error);
  }
  fs::create_directories(fs::path(path_) / "scenes", error);
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  try {
    // The scenes come first: a folder with a sweep.toml must be readable.
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
      const auto place = path_ + "/" + file->name;
      if (file->copy_of.empty()) {
        write_text_file(place, file->text);
      } else if (!fs::equivalent(file->copy_of, place, error)) {  // a sweep continued from its own file has it
        fs::copy_file(file->copy_of, place, fs::copy_options::overwrite_existing);
      }
    }
  } catch (const std::exception& failure) {
    throw InputError(message_of(failure));
  }
}

void SweepFolder::check_place() const {
  if (lock_) lock_->check_place();
}

std::string SweepFolder::member_path(const Member& member) const { return folder_of(path_, plan_, member); }

Scene SweepFolder::scene_of(const Member& member) const {
  const auto& point = plan_.points[member.point];
  if (!point.starts_from) {
    auto scene = point.scene;
    scene.seed = member.seed;
    return scene;
  }
  auto overrides = point.overrides;
  overrides.seed = member.seed;
  const auto from = fs::absolute(member_path({*point.starts_from, member.seed})).string();
  overrides.set.push_back(fmt::format("start.from = {}", toml_quoted(from)));
  return read_scene(point.file, overrides);
}

std::string SweepFolder::status_of(const Member& member) const {
  const fs::path folder = member_path(member);
  std::error_code error;
  if (!fs::is_regular_file(folder / "run.h5", error)) return "";
  return summary_status(content_of(folder / "summary.json"));
}

std::vector<std::pair<std::string, double>> SweepFolder::measures(const Member& member) const {
  const auto path = member_path(member) + "/summary.json";
  return measures_of(content_of(path), path);
}

SweepTable SweepFolder::table() const {
  std::vector<MemberRow> rows;
  std::vector<std::vector<std::pair<std::string, double>>> values(members_.size());
  for (std::size_t k = 0; k < members_.size(); ++k) {
    MemberRow row{members_[k].point, members_[k].seed, status_of(members_[k]), {}, {}};
    if (row.status == "finished") {
      values[k] = measures(members_[k]);
      row.base = read_base(Hdf5Reader(member_path(members_[k]) + "/run.h5"));
      read_analysis(member_path(members_[k]) + "/analysis.h5", row);
    }
    rows.push_back(std::move(row));
  }
  const auto measures = union_of(values);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].values.assign(measures.size(), std::numeric_limits<double>::quiet_NaN());
    for (const auto& [name, value] : values[k]) {
      const auto column = std::find(measures.begin(), measures.end(), name);
      if (column != measures.end()) rows[k].values[static_cast<std::size_t>(column - measures.begin())] = value;
    }
  }
  return make_table(plan_, measures, std::move(rows));
}

void SweepFolder::write(const SweepTable& table) const {
  check_place();
  // Programs that share the sweep write the same tables one after the other.
  constexpr double patience = 600.0;  // [s]
  const FolderLock others_wait(path_ + "/scenes", patience);
  // The old summary compares theory with profiles that are about to change, and holds nothing else.
  std::error_code error;
  fs::remove(fs::path(path_) / "summary.json", error);
  write_text_file(path_ + "/table.csv", table_csv(plan_, table));
  write_text_file(path_ + "/members.csv", members_csv(plan_, table));
  if (!plan_.claims.empty()) {
    write_text_file(path_ + "/claims.csv", claims_csv(plan_, table));
    write_text_file(path_ + "/claims.json", claims_json(plan_, table));
  }
  if (!plan_.fits.empty()) {
    write_text_file(path_ + "/heights.csv", heights_csv(table.fits));
    write_text_file(path_ + "/heights.json", heights_json(table.fits));
  }
  write_sweep_file(path_ + "/sweep.h5", plan_, table);
  if (const auto drops = pool_drops(plan_, table); !drops.empty())
    write_text_file(path_ + "/drops.csv", drops_csv(drops));
  const auto responses = point_responses(
      plan_, table, [&](std::size_t member) { return read_last_state<2>(member_path(members_[member])); });
  if (responses.empty()) return;
  write_text_file(path_ + "/response.csv", response_csv(responses));
  write_text_file(path_ + "/response.json", response_json(responses));
}

std::size_t SweepFolder::analyse(const FurtherAnalysis& further) const {
  const FolderLock all(path_);
  const auto rigid = [](const auto& point) { return point.scene.method->solver() != nullptr; };
  if (further.force_range && std::none_of(plan_.points.begin(), plan_.points.end(), rigid)) {
    throw InputError(
        fmt::format("{}: no force range: only rigid grains have one, and no point is of contact-dynamics", path_));
  }
  std::size_t count = 0;
  for (const auto& member : members_) {
    const auto status = status_of(member);
    if (status.empty()) continue;
    const auto folder = member_path(member);
    const FolderLock lock(folder);
    with_dimension(run_dimension(folder), [&](auto dimension) {
      const auto record = read_record<dimension>(folder);
      // A sweep may compare methods, of which only that of rigid grains has a range.
      auto of_member = further;
      of_member.force_range &= record.scene.method->solver() != nullptr;
      write_results(folder, lock, record, repose::analyse(record, of_member));
    });
    ++count;
  }
  write(table());
  return count;
}

}  // namespace repose
