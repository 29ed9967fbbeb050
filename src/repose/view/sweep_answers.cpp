// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/sweep_answers.hpp"

#include "repose/analysis/statistics.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/results/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

using Json = nlohmann::ordered_json;

SweepAnswers::SweepAnswers(const std::string& folder) : folder_(folder), seen_(folder_.members().size()) {}

std::string SweepAnswers::name_of(const Member& member) const {
  return fmt::format("{}/seed-{}", folder_.plan().points[member.point].name, member.seed);
}

const SweepAnswers::Seen& SweepAnswers::look_at(std::size_t member) {
  auto& seen = seen_[member];
  const auto path = folder_.member_path(folder_.members()[member]);
  const auto version = file_version(path + "/summary.json") + file_version(path + "/run.h5");
  if (!seen.status.empty() && version == seen.version) return seen;
  seen.version = version;
  const auto status = folder_.status_of(folder_.members()[member]);
  if (status == "finished" || status == "failed") {
    seen.status = status;
  } else {
    seen.status = version.empty() ? "waiting" : "running";
  }
  seen.measures.clear();
  seen.message.clear();
  try {
    if (status == "failed") seen.message = read_run_facts(path).message;
    if (status == "finished") seen.measures = folder_.measures(folder_.members()[member]);
  } catch (const InputError&) {  // being replaced, or damaged: without numbers
  }
  return seen;
}

Json SweepAnswers::state() {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::size_t> count;
  for (std::size_t k = 0; k < seen_.size(); ++k) ++count[look_at(k).status];
  return {{"finished", count["finished"]}, {"running", count["running"]}, {"failed", count["failed"]}};
}

Json SweepAnswers::means_of(std::size_t point) const {
  std::map<std::string, std::vector<double>> values;
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    if (folder_.members()[k].point != point) continue;
    for (const auto& [name, value] : seen_[k].measures) values[name].push_back(value);
  }
  auto means = Json::object();
  for (const auto& [name, sample] : values) {
    const auto mean = mean_of(sample);
    means[name] = {mean.mean, mean.error, mean.count};
  }
  return means;
}

std::string SweepAnswers::sweep_text() {
  const std::lock_guard lock(mutex_);
  const auto& plan = folder_.plan();
  auto points = Json::array();
  for (const auto& point : plan.points) {
    auto values = Json::object();
    for (const auto& parameter : point.parameters) {
      values[parameter.key] = std::isfinite(parameter.number) ? Json(parameter.number) : Json(parameter.text);
    }
    points.push_back({{"name", point.name}, {"values", values}, {"members", Json::array()}});
  }
  auto members = Json::array();
  std::vector<std::string> measures;
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const auto& member = folder_.members()[k];
    const auto& seen = look_at(k);
    auto numbers = Json::object();
    for (const auto& [name, value] : seen.measures) {
      numbers[name] = value;
      if (std::find(measures.begin(), measures.end(), name) == measures.end()) measures.push_back(name);
    }
    points[member.point]["members"].push_back(name_of(member));
    members.push_back({{"name", name_of(member)},
                       {"point", plan.points[member.point].name},
                       {"seed", member.seed},
                       {"status", seen.status},
                       {"message", seen.message},
                       {"measures", numbers}});
  }
  auto offered = Json::array();
  for (const auto& name : measures) {
    const auto* measure = find_measure(name);
    offered.push_back({{"name", name}, {"unit", measure == nullptr ? "" : measure->unit}});
  }
  auto means = Json::array();
  for (std::size_t p = 0; p < plan.points.size(); ++p) means.push_back(means_of(p));
  return Json{{"title", plan.title}, {"seeds", plan.seeds}, {"parameters", plan.keys}, {"points", points},
              {"members", members},  {"measures", offered}, {"means", means}}
      .dump();
}

RunAnswers* SweepAnswers::member(const std::string& name) {
  const auto& all = folder_.members();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return name_of(one) == name; });
  if (found == all.end()) return nullptr;
  const std::lock_guard lock(mutex_);
  auto& known = runs_[name];
  if (!known) known = std::make_unique<RunAnswers>(folder_.member_path(*found));
  return known.get();
}

Answer SweepAnswers::of_member(const std::string& address) {
  const auto point = address.find('/');
  const auto end = point == address.npos ? point : address.find('/', point + 1);
  if (end != address.npos) {
    if (auto* run = member(address.substr(0, end))) return run->answer(address.substr(end + 1));
  }
  return nothing(fmt::format("{}: no such member", address));
}

Answer SweepAnswers::answer(const std::string& address) try {
  if (address == "sweep") return json_answer(sweep_text());
  if (address.starts_with("members/")) return of_member(address.substr(8));
  return nothing(fmt::format("{}: no such address", address));
} catch (const InputError& error) {
  return nothing(error.what());
}

}  // namespace repose
