// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/sweep_table.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace repose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Numbers of a summary that tell of the run, not of the grains.
const std::set<std::string> not_measures = {
    "seed", "steps", "time_step", "threads", "wall_seconds", "grain_steps_per_second", "force_threshold"};

/// Objects whose numbers are null together: listed even then, so that every summary has the same measures.
void flatten(const nlohmann::ordered_json& node, const std::string& prefix,
             std::vector<std::pair<std::string, double>>& found) {
  for (const auto& [key, value] : node.items()) {
    const auto name = prefix.empty() ? key : prefix + "." + key;
    if (not_measures.contains(name)) continue;
    if (value.is_object()) flatten(value, name, found);
    if (value.is_number()) found.emplace_back(name, value.get<double>());
    if (value.is_null()) found.emplace_back(name, none);
  }
}

double dip_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  return dip ? dip->index : none;
}

double max_over_centre_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  const auto ratio = dip ? max_over_centre(profile, dip->centre, dip->half_width) : std::nullopt;
  return ratio.value_or(none);
}

/// Mean profile of some members, without one of them.
BaseProfile mean_profile(const std::vector<const BaseProfile*>& members, std::size_t without) {
  BaseProfile mean = *members.front();
  std::fill(mean.normal.begin(), mean.normal.end(), 0.0);
  std::fill(mean.shear.begin(), mean.shear.end(), 0.0);
  double count = 0.0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (m == without) continue;
    count += 1.0;
    for (std::size_t k = 0; k < mean.x.size(); ++k) {
      mean.normal[k] += members[m]->normal[k];
      mean.shear[k] += members[m]->shear[k];
    }
  }
  for (std::size_t k = 0; k < mean.x.size(); ++k) {
    mean.normal[k] /= count;
    mean.shear[k] /= count;
  }
  return mean;
}

std::optional<EnsembleProfile> ensemble_profile(const std::vector<const BaseProfile*>& members, double bin_width) {
  if (members.empty() || members.front()->x.empty()) return std::nullopt;
  for (const auto* member : members) {
    if (member->x != members.front()->x) return std::nullopt;
  }
  EnsembleProfile profile;
  profile.members = members.size();
  profile.mean = mean_profile(members, members.size());
  const auto over_members = [&](const auto& value) {
    std::vector<double> values;
    for (std::size_t m = 0; m < members.size(); ++m) values.push_back(value(m));
    return mean_of(values);
  };
  for (std::size_t k = 0; k < profile.mean.x.size(); ++k) {
    profile.normal_error.push_back(over_members([&](std::size_t m) { return members[m]->normal[k]; }).error);
    profile.shear_error.push_back(over_members([&](std::size_t m) { return members[m]->shear[k]; }).error);
  }
  profile.binned = binned(profile.mean, bin_width);
  std::vector<BinnedProfile> each;
  for (const auto* member : members) each.push_back(binned(*member, bin_width));
  for (std::size_t k = 0; k < profile.binned.x.size(); ++k) {
    profile.binned.normal_error[k] = over_members([&](std::size_t m) { return each[m].normal[k]; }).error;
    profile.binned.shear_error[k] = over_members([&](std::size_t m) { return each[m].shear[k]; }).error;
  }
  const auto of_mean = [&](double (*statistic)(const BaseProfile&)) {
    return jackknife(members.size(), [&](std::size_t without) { return statistic(mean_profile(members, without)); });
  };
  profile.dip_index = of_mean(dip_of);
  profile.max_over_centre = of_mean(max_over_centre_of);
  const auto dip = base_dip(profile.mean);
  profile.centre = dip ? dip->centre : none;
  profile.half_width = dip ? dip->half_width : none;
  return profile;
}

Verdict verdict_of(const Claim& claim, const SweepPlan& plan, const SweepTable& table) {
  const auto column = std::find(table.measures.begin(), table.measures.end(), claim.measure) - table.measures.begin();
  const auto entry = [&](const std::string& name) {
    const auto same = [&](const SweepPoint& point) { return point.name == name; };
    const auto point = std::find_if(plan.points.begin(), plan.points.end(), same) - plan.points.begin();
    const auto missing = static_cast<std::size_t>(column) == table.measures.size();
    return missing ? Estimate{0, none, none, none}
                   : table.entries[static_cast<std::size_t>(point)][static_cast<std::size_t>(column)];
  };
  Verdict verdict{"no data", none, none};
  switch (claim.kind) {
    case Claim::Kind::value: {
      const auto only = entry(claim.points.front());
      verdict.value = only.mean;
      verdict.error = only.error;
      break;
    }
    case Claim::Kind::difference: {
      const auto first = entry(claim.points[0]);
      const auto second = entry(claim.points[1]);
      verdict.value = first.mean - second.mean;
      verdict.error = std::hypot(first.error, second.error);
      break;
    }
    case Claim::Kind::spread: {
      std::vector<Estimate> all;
      for (const auto& name : claim.points) all.push_back(entry(name));
      const auto undefined = [](const Estimate& estimate) { return std::isnan(estimate.mean); };
      if (std::any_of(all.begin(), all.end(), undefined)) return verdict;
      const auto less = [](const Estimate& a, const Estimate& b) { return a.mean < b.mean; };
      const auto [low, high] = std::minmax_element(all.begin(), all.end(), less);
      verdict.value = high->mean - low->mean;
      verdict.error = std::hypot(high->error, low->error);
      break;
    }
  }
  if (std::isnan(verdict.value) || std::isnan(verdict.error)) return verdict;
  const double low = verdict.value - 2.0 * verdict.error;
  const double high = verdict.value + 2.0 * verdict.error;
  if (low >= claim.above && high <= claim.below) {
    verdict.word = "agrees";
  } else if (high < claim.above || low > claim.below) {
    verdict.word = "disagrees";
  } else {
    verdict.word = "undecided";
  }
  return verdict;
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_number(double x) { return std::isnan(x) ? "" : fmt::format("{}", x); }

/// Value of a parameter at a point, "" where the point does not set it.
std::string parameter_text(const SweepPoint& point, const std::string& key) {
  for (const auto& parameter : point.parameters) {
    if (parameter.key == key) return parameter.text;
  }
  return "";
}

}  // namespace

std::vector<std::pair<std::string, double>> measures_of(const std::string& summary, const std::string& name) {
  try {
    const auto json = nlohmann::ordered_json::parse(summary);
    std::vector<std::pair<std::string, double>> found;
    flatten(json, "", found);
    return found;
  } catch (const nlohmann::json::exception&) {
    throw InputError(fmt::format("{}: is not a summary", name));
  }
}

SweepTable make_table(const SweepPlan& plan, std::vector<std::string> measures, std::vector<MemberRow> members) {
  SweepTable table;
  table.measures = std::move(measures);
  table.members = std::move(members);
  const auto own_measures = table.measures.size();
  table.measures.insert(table.measures.end(), {"profile.dip_index", "profile.max_over_centre"});
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    std::vector<const MemberRow*> finished;
    std::size_t failed = 0;
    for (const auto& member : table.members) {
      if (member.point != p) continue;
      if (member.status == "finished") finished.push_back(&member);
      if (member.status == "failed") ++failed;
    }
    table.finished.push_back(finished.size());
    table.failed.push_back(failed);
    std::vector<Estimate> entries;
    for (std::size_t m = 0; m < own_measures; ++m) {
      std::vector<double> values;
      for (const auto* member : finished) values.push_back(member->values[m]);
      entries.push_back(mean_of(values));
    }
    std::vector<const BaseProfile*> bases;
    for (const auto* member : finished) bases.push_back(&member->base);
    table.profiles.push_back(ensemble_profile(bases, plan.points[p].scene.analysis.base_bin));
    const auto& profile = table.profiles.back();
    const Estimate undefined{0, none, none, none};
    entries.push_back(profile ? profile->dip_index : undefined);
    entries.push_back(profile ? profile->max_over_centre : undefined);
    table.entries.push_back(std::move(entries));
  }
  for (const auto& claim : plan.claims) table.verdicts.push_back(verdict_of(claim, plan, table));
  return table;
}

std::string table_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "point";
  for (const auto& key : plan.keys) text += fmt::format(",{}", csv_text(key));
  text += ",finished,failed";
  for (const auto& name : table.measures) text += fmt::format(",{0},{0}:error,{0}:deviation,{0}:count", name);
  text += "\n";
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    text += csv_text(plan.points[p].name);
    for (const auto& key : plan.keys) text += fmt::format(",{}", csv_text(parameter_text(plan.points[p], key)));
    text += fmt::format(",{},{}", table.finished[p], table.failed[p]);
    for (const auto& entry : table.entries[p]) {
      text += fmt::format(",{},{},{},{}", csv_number(entry.mean), csv_number(entry.error), csv_number(entry.deviation),
                          entry.count);
    }
    text += "\n";
  }
  return text;
}

std::string members_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "point,seed,status";
  const auto own_measures = table.measures.size() - 2;  // the last two are of profiles
  for (std::size_t m = 0; m < own_measures; ++m) text += fmt::format(",{}", table.measures[m]);
  text += "\n";
  for (const auto& member : table.members) {
    text += fmt::format("{},{},{}", csv_text(plan.points[member.point].name), member.seed, member.status);
    for (const double value : member.values) text += fmt::format(",{}", csv_number(value));
    text += "\n";
  }
  return text;
}

std::string claims_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "claim,source,measure,kind,points,above,below,value,error,verdict\n";
  for (std::size_t k = 0; k < plan.claims.size(); ++k) {
    const auto& claim = plan.claims[k];
    const auto& verdict = table.verdicts[k];
    std::string points;
    for (const auto& name : claim.points) points += (points.empty() ? "" : " ") + name;
    const auto* kind = claim.kind == Claim::Kind::value        ? "value"
                       : claim.kind == Claim::Kind::difference ? "difference"
                                                               : "spread";
    const auto bound = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : std::string(); };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_text(claim.text), csv_text(claim.source), claim.measure,
                        kind, csv_text(points), bound(claim.above), bound(claim.below), csv_number(verdict.value),
                        csv_number(verdict.error), verdict.word);
  }
  return text;
}

}  // namespace repose
