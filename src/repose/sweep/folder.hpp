// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/folders.hpp"
#include "repose/run_folder/further_analysis.hpp"
#include "repose/sweep/plan.hpp"
#include "repose/sweep/table.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace repose {

/// One run of a sweep: a point with one of the seeds.
struct Member {
  std::size_t point = 0;
  std::int64_t seed = 0;
};

/// The folder of a sweep: sweep.toml and its scenes, one run folder per member, the tables; see
/// docs/reference/sweep.md.
class SweepFolder {
 public:
  static bool is_one(const std::string& path);
  /// The reasons why this sweep cannot be written into this folder, one line each. Changes nothing.
  static std::vector<std::string> problems(const std::string& path, const SweepPlan& plan, bool overwrite);

  /// Opens the folder of an earlier `repose sweep`. Throws InputError if `path` is no such folder.
  explicit SweepFolder(std::string path);
  /// Makes the folder, or continues the sweep in it; `overwrite` removes an older sweep first. The plan is that of
  /// `sweep_file` in this form. Locks the folder for as long as this object lives, against all others or against those
  /// that do not share it. Throws InputError, also if another program sweeps there.
  SweepFolder(std::string path, const std::string& sweep_file, SweepPlan plan, bool overwrite,
              SweepForm form = SweepForm::full, FolderLock::For writers = FolderLock::For::one);

  const std::string& path() const { return path_; }
  const SweepPlan& plan() const { return plan_; }
  /// All members, seeds of the first point first.
  const std::vector<Member>& members() const { return members_; }
  std::string member_path(const Member& member) const;
  /// Throws InputError where the member starts from one that has not finished.
  Scene scene_of(const Member& member) const;
  /// Throws RunError if the folder has been moved or deleted since it was locked.
  void check_place() const;
  /// The status in the summary of a member; "" without a readable summary, or without its run.h5.
  std::string status_of(const Member& member) const;

  /// Names and values of the measures of a member that has finished.
  std::vector<std::pair<std::string, double>> measures(const Member& member) const;

  /// Reads the summaries and base profiles of all members that have finished.
  SweepTable table() const;
  /// Writes table.csv, members.csv, claims.csv, claims.json and sweep.h5. Throws RunError.
  void write(const SweepTable& table) const;
  /// Analyses every member again, on request with its force range, and writes the tables. Returns the number of
  /// members.
  std::size_t analyse(const FurtherAnalysis& further = {}) const;

 private:
  void write_files(const std::vector<SweepFile>& files, bool overwrite) const;

  std::string path_;
  std::unique_ptr<FolderLock> lock_;  // null in a folder that is opened to be read
  SweepPlan plan_;
  std::vector<Member> members_;
};

}  // namespace repose
