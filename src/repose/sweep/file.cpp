// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>

namespace repose {

namespace {

void write_points(Hdf5File& file, const SweepPlan& plan, const SweepTable& table) {
  std::vector<std::string> names;
  std::vector<std::int64_t> finished;
  std::vector<std::int64_t> failed;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    names.push_back(plan.points[p].name);
    finished.push_back(static_cast<std::int64_t>(table.finished[p]));
    failed.push_back(static_cast<std::int64_t>(table.failed[p]));
  }
  file.group("points");
  file.texts("points/name", names, "name of each point");
  file.dataset("points/members", finished, 1, "", "finished members");
  file.dataset("points/failed", failed, 1, "", "failed members");
}

/// Parameters that differ between points, as numbers and as text.
void write_parameters(Hdf5File& file, const SweepPlan& plan) {
  file.group("parameters");
  file.group("parameter_text");
  for (const auto& key : plan.keys) {
    std::vector<double> numbers(plan.points.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::string> texts(plan.points.size());
    for (std::size_t p = 0; p < plan.points.size(); ++p) {
      for (const auto& parameter : plan.points[p].parameters) {
        if (parameter.key != key) continue;
        numbers[p] = parameter.number;
        texts[p] = parameter.text;
      }
    }
    if (std::set<std::string>(texts.begin(), texts.end()).size() < 2) continue;
    file.dataset("parameters/" + key, numbers, 1, "", "by point; not a number where the value is none");
    file.texts("parameter_text/" + key, texts, "by point, as TOML");
  }
}

void write_measures(Hdf5File& file, const SweepTable& table) {
  file.group("measures");
  for (std::size_t m = 0; m < table.measures.size(); ++m) {
    std::vector<double> mean;
    std::vector<double> error;
    std::vector<double> deviation;
    std::vector<std::int64_t> count;
    for (const auto& entries : table.entries) {
      mean.push_back(entries[m].mean);
      error.push_back(entries[m].error);
      deviation.push_back(entries[m].deviation);
      count.push_back(static_cast<std::int64_t>(entries[m].count));
    }
    const auto group = "measures/" + table.measures[m];
    file.group(group);
    file.dataset(group + "/mean", mean, 1, "", "over the finished members of each point");
    file.dataset(group + "/error", error, 1, "", "standard error of the mean");
    file.dataset(group + "/deviation", deviation, 1, "", "standard deviation between members");
    file.dataset(group + "/count", count, 1, "", "members where it is defined");
  }
}

void write_members(Hdf5File& file, const SweepTable& table) {
  std::vector<std::int64_t> point;
  std::vector<std::int64_t> seed;
  std::vector<std::string> status;
  for (const auto& member : table.members) {
    point.push_back(static_cast<std::int64_t>(member.point));
    seed.push_back(member.seed);
    status.push_back(member.status);
  }
  file.group("members");
  file.dataset("members/point", point, 1, "", "row of /points");
  file.dataset("members/seed", seed, 1, "", "seed");
  file.texts("members/status", status, "as in its summary; empty: not run yet");
  file.group("values");
  for (std::size_t m = 0; m + 2 < table.measures.size(); ++m) {  // the last two are of profiles
    std::vector<double> values;
    for (const auto& member : table.members) values.push_back(member.values[m]);
    file.dataset("values/" + table.measures[m], values, 1, "", "by member");
  }
}

void write_profile(Hdf5File& file, const std::string& group, const EnsembleProfile& profile) {
  file.group(group);
  file.attribute(group, "members", static_cast<std::int64_t>(profile.members));
  file.attribute(group, "dip_index", profile.dip_index.mean);
  file.attribute(group, "dip_index_error", profile.dip_index.error);
  file.attribute(group, "max_over_centre", profile.max_over_centre.mean);
  file.attribute(group, "max_over_centre_error", profile.max_over_centre.error);
  file.attribute(group, "centre", profile.centre);
  file.attribute(group, "half_width", profile.half_width);
  const auto columns = [&](const std::string& where, const std::vector<double>& x, const std::vector<double>& normal,
                           const std::vector<double>& normal_error, const std::vector<double>& shear,
                           const std::vector<double>& shear_error) {
    file.dataset(where + "/x", x, 1, "L", "centre");
    file.dataset(where + "/normal", normal, 1, "grain weights", "mean over members, positive downward");
    file.dataset(where + "/normal_error", normal_error, 1, "grain weights", "standard error between members");
    file.dataset(where + "/shear", shear, 1, "grain weights", "mean over members, positive to the right");
    file.dataset(where + "/shear_error", shear_error, 1, "grain weights", "standard error between members");
  };
  columns(group, profile.mean.x, profile.mean.normal, profile.normal_error, profile.mean.shear, profile.shear_error);
  const auto& bins = profile.binned;
  file.group(group + "/binned");
  file.attribute(group + "/binned", "bin_width", bins.bin_width);
  columns(group + "/binned", bins.x, bins.normal, bins.normal_error, bins.shear, bins.shear_error);
}

}  // namespace

void write_sweep_file(const std::string& path, const SweepPlan& plan, const SweepTable& table) {
  Hdf5File file(path);
  file.attribute("/", "format", std::string("repose-sweep"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "title", plan.title);
  file.attribute("/", "units", plan.points.front().scene.units);
  write_points(file, plan, table);
  write_parameters(file, plan);
  write_measures(file, table);
  write_members(file, table);
  file.group("profiles");
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (table.profiles[p]) write_profile(file, fmt::format("profiles/{:04}", p), *table.profiles[p]);
  }
  file.commit();
}

}  // namespace repose
