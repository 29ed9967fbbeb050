// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"
#include "repose/sweep/ensemble_profile.hpp"
#include "repose/sweep/height_fit.hpp"
#include "repose/sweep/plan_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace repose {

namespace {

/// Claims of sweeps of older programs; the statistic that they judged has no test.
constexpr const char* no_spread =
    "{}spread: is judged as an equivalence now: write \"equivalent\" instead, and \"margin\" instead of \"below\"";

}  // namespace

void SweepReader::read_bounds(const toml::table& table, const std::string& prefix, Claim& claim) {
  const auto above = number(table, prefix, "above");
  const auto below = number(table, prefix, "below");
  const auto margin = number(table, prefix, "margin");
  if (claim.kind == Claim::Kind::equivalence) {
    if (above || below)
      problem(table, fmt::format("{}margin: an equivalence has a margin, not above or below", prefix));
    if (!margin)
      return problem(table, fmt::format("{}margin: missing: the largest difference that is no matter", prefix));
    if (*margin <= 0.0) problem(table, fmt::format("{}margin = {}: must be > 0", prefix, *margin));
    claim.above = -*margin;
    claim.below = *margin;
    return;
  }
  if (margin) problem(table, fmt::format("{}margin: goes with equivalent only; give above and below", prefix));
  claim.above = above.value_or(claim.above);
  claim.below = below.value_or(claim.below);
  if ((!above && !below) || claim.above >= claim.below) {
    problem(table, fmt::format("{}above: give above, below or both, with above < below", prefix));
  }
}

/// A measure must be a column of the table, and mean something for the methods of its points.
void SweepReader::check_measure(const toml::table& table, const std::string& prefix, const Claim& claim,
                                const SweepPlan& plan) {
  if (claim.measure.empty()) return;
  const auto of_profile = [&](const ProfileMeasure& measure) { return claim.measure == measure.name; };
  if (std::any_of(std::begin(profile_measures()), std::end(profile_measures()), of_profile)) return;
  const auto shown = fmt::format("{}measure = \"{}\": ", prefix, claim.measure);
  const auto* measure = find_measure(claim.measure);
  if (measure != nullptr && measure->name == claim.measure && measure->kind == KnownMeasure::Kind::estimate) {
    return problem(*table.get("measure"), fmt::format("{}is two numbers: {}.mean or .error", shown, claim.measure));
  }
  const bool of_estimate = claim.measure.ends_with(".mean") || claim.measure.ends_with(".error");
  const bool whole =
      measure != nullptr && measure->name == claim.measure && measure->kind == KnownMeasure::Kind::number;
  const bool part = measure != nullptr && measure->name != claim.measure && of_estimate;
  if (!(whole || part) || !measure->of_grains)
    return problem(*table.get("measure"), shown + "no such measure (`repose reference summary` lists them)");
  for (const auto& point : plan.points) {
    const bool meant = std::find(claim.points.begin(), claim.points.end(), point.name) != claim.points.end();
    if (!meant || !point.scene.method || has(point.scene, measure->needs)) continue;
    return problem(*table.get("measure"), fmt::format("{}has no value in point \"{}\", whose method is \"{}\"", shown,
                                                      point.name, point.scene.method->name()));
  }
}

/// A claim on a fit names one of the sweep, and one of its numbers; its points are those of the fit.
void SweepReader::check_fit(const toml::table& table, const std::string& prefix, Claim& claim, const SweepPlan& plan) {
  const auto& measures = height_fit_measures();
  if (!claim.measure.empty() && std::find(measures.begin(), measures.end(), claim.measure) == measures.end()) {
    problem(*table.get("measure"),
            fmt::format("{}measure = \"{}\": a fit has {}", prefix, claim.measure, fmt::join(measures, ", ")));
  }
  for (const auto& fit : plan.fits) {
    if (fit.name == claim.fit) return void(claim.points = fit.points);
  }
  problem(*table.get("fit"), fmt::format("{}fit = \"{}\": no such [[fit]]", prefix, claim.fit));
}

void SweepReader::read_claims(SweepPlan& plan) {
  const auto* list = list_of_tables("claim");
  if (list == nullptr) return;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto& table = *list->get(k)->as_table();
    const auto prefix = fmt::format("claim[{}].", k);
    if (table.contains("spread")) {
      problem(*table.get("spread"), fmt::format(no_spread, prefix));
      continue;
    }
    check_keys(table, prefix,
               {"text", "source", "measure", "point", "difference", "equivalent", "fit", "above", "below", "margin"});
    Claim claim;
    claim.text = text(table, prefix, "text", true);
    claim.source = text(table, prefix, "source", false);
    claim.measure = text(table, prefix, "measure", true);
    const auto point = text(table, prefix, "point", false);
    const auto difference = names(table, prefix, "difference");
    const auto equivalent = names(table, prefix, "equivalent");
    claim.fit = text(table, prefix, "fit", false);
    const int kinds = (point.empty() ? 0 : 1) + (difference.empty() ? 0 : 1) + (equivalent.empty() ? 0 : 1) +
                      (claim.fit.empty() ? 0 : 1);
    if (kinds != 1) {
      problem(table, fmt::format("{}point: give one of point, difference, equivalent and fit", prefix));
      continue;
    }
    if (!point.empty()) {
      claim.points = {point};
    } else if (!claim.fit.empty()) {
      claim.kind = Claim::Kind::fit;
      check_fit(table, prefix, claim, plan);
    } else if (!difference.empty()) {
      claim.kind = Claim::Kind::difference;
      claim.points = difference;
      if (difference.size() != 2) problem(table, fmt::format("{}difference: must be a list of two names", prefix));
    } else {
      claim.kind = Claim::Kind::equivalence;
      claim.points = equivalent;
    }
    read_bounds(table, prefix, claim);
    if (claim.kind != Claim::Kind::fit) check_measure(table, prefix, claim, plan);
    for (const auto& name : claim.points) {
      const auto same = [&](const SweepPoint& other) { return other.name == name; };
      if (std::any_of(plan.points.begin(), plan.points.end(), same)) continue;
      std::vector<std::string> known;
      for (const auto& other : plan.points) known.push_back(other.name);
      problem(table, fmt::format("{}points: no point \"{}\"; there are {}", prefix, name, fmt::join(known, ", ")));
    }
    plan.claims.push_back(std::move(claim));
  }
}

}  // namespace repose
