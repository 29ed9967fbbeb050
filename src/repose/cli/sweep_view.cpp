// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/sweep_view.hpp"

#include "repose/analysis/bootstrap.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/cli/progress.hpp"
#include "repose/cli/say.hpp"
#include "repose/simulation/expectation.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

namespace repose {

using Stage = MemberProgress::Stage;

namespace {

/// A measure of the table on the terminal, which has no room for all.
struct Shown {
  const char* measure;
  const char* head;
  int decimals;
};
constexpr Shown shown[] = {{"angle_of_repose_deg.mean", "angle [deg]", 2},
                           {"base_dip.index", "dip index", 3},
                           {"profile.dip_index", "dip of mean", 3},
                           {"coordination", "coordination", 3},
                           {"core.solid_fraction", "core fraction", 4},
                           {"column.load_ratio", "floor/weight", 3},
                           {"slips.stuck", "stuck", 3},
                           {"max_overlap", "overlap", 4}};
constexpr int column_width = 17;

std::string with_error(double mean, double error, int decimals) {
  if (std::isnan(mean)) return "-";
  if (std::isnan(error)) return fmt::format("{:.{}f}", mean, decimals);
  return fmt::format("{:.{}f} +- {:.{}f}", mean, decimals, error, decimals);
}

std::size_t name_width(const SweepPlan& plan) {
  std::size_t width = 5;
  for (const auto& point : plan.points) width = std::max(width, point.name.size());
  return width;
}

/// Which shown numbers are from some of the members only.
std::string missing_text(const SweepPlan& plan, const SweepTable& table) {
  std::string text;
  for (const auto& column : shown) {
    const auto found = std::find(table.measures.begin(), table.measures.end(), column.measure);
    if (found == table.measures.end()) continue;
    for (std::size_t p = 0; p < plan.points.size(); ++p) {
      const auto& entry = table.entries[p][static_cast<std::size_t>(found - table.measures.begin())];
      if (entry.missing == 0 || entry.count == 0) continue;
      text += fmt::format("{} at {}: {} of {} finished members have none\n", column.head, plan.points[p].name,
                          entry.missing, entry.missing + entry.count);
    }
  }
  return text;
}

std::string bounds_text(const Claim& claim) {
  if (claim.kind == Claim::Kind::equivalence) return fmt::format("equal within {:g}", claim.below);
  if (std::isfinite(claim.above) && std::isfinite(claim.below)) {
    return fmt::format("{:g} to {:g}", claim.above, claim.below);
  }
  return std::isfinite(claim.above) ? fmt::format("above {:g}", claim.above) : fmt::format("below {:g}", claim.below);
}

/// A claim with its verdict: one line of what was found, one of how it was judged.
std::string claim_text(const Claim& claim, const Verdict& verdict) {
  const auto& found = verdict.inference;
  auto text = fmt::format("{:10}  {}: ", verdict.word, claim.text);
  if (!std::isnan(found.value)) text += fmt::format("{:.4g} +- {:.2g}, ", found.value, found.error);
  text += fmt::format("claimed {}\n", bounds_text(claim));
  if (std::isnan(found.error)) return text;
  const bool fails = verdict.p_fails < verdict.p_holds;
  text += fmt::format("{:10}  {:.4g} to {:.4g} by {}, n = {}", "", found.low, found.high, found.test, found.count);
  if (verdict.missing > 0) text += fmt::format(", {} missing", verdict.missing);
  if (!std::isnan(found.bias)) text += fmt::format("; bias {:+.2g}", found.bias);
  if (!verdict.pair.first.empty()) text += fmt::format("; {} and {}", verdict.pair.first, verdict.pair.second);
  text += fmt::format("; p {:.2g}, Holm {:.2g}: {}\n", fails ? verdict.p_fails : verdict.p_holds,
                      fails ? verdict.p_fails_holm : verdict.p_holds_holm, verdict.holm_word);
  return text;
}

std::string fit_text(const HeightFit& fit) {
  if (!fit.problem.empty()) return fmt::format("fit {}: none: {}\n", fit.name, fit.problem);
  const auto value = [&](const char* measure) {
    const auto found = infer(fit, measure);
    return fmt::format("{:.4g} +- {:.2g}", found.value, found.error);
  };
  return fmt::format(
      "fit {}: lambda {} (chance {:.2g}); lambda_1 {}, lambda_2 {} (chance {:.2g}), ratio {}; K {}, from the loads "
      "{}\n",
      fit.name, value("lambda"), fit.chance_one, value("lambda_1"), value("lambda_2"), fit.chance_two, value("ratio"),
      value("stress_ratio"), value("stress_ratio_direct"));
}

/// What the numbers of a table mean, and the claims.
std::string claims_text(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "mean +- standard error of the members; of a mean profile by the bootstrap\n";
  text += missing_text(plan, table);
  for (const auto& fit : table.fits) text += fit_text(fit);
  if (plan.claims.empty()) return text;
  text += "\n";
  for (std::size_t k = 0; k < plan.claims.size(); ++k) text += claim_text(plan.claims[k], table.verdicts[k]);
  text += fmt::format(
      "{:g} % intervals; one-sided p at {:g} %; Holm: adjusted for the number of claims; bootstraps of {} resamples\n",
      100.0 * interval_probability, 100.0 * test_level, resamples);
  return text;
}

}  // namespace

std::string describe_plan(const SweepPlan& plan) {
  std::string text = fmt::format("sweep            {}\n", plan.title.empty() ? "(untitled)" : plan.title);
  text += fmt::format("members          {} points with {} seeds each\n", plan.points.size(), plan.seeds.size());
  double work = 0.0;
  for (const auto& point : plan.points) {
    const double each = expected_work(point.scene, expected_end(point.scene));
    text += fmt::format("  {:{}}  {:.3g} grain-steps each\n", point.name, name_width(plan), each);
    work += each * static_cast<double>(plan.seeds.size());
  }
  text += fmt::format("expected         {:.3g} grain-steps in all\nclaims           {}\n", work, plan.claims.size());
  return text;
}

std::string describe_table(const SweepFolder& folder, const SweepTable& table) {
  const auto& plan = folder.plan();
  const auto width = name_width(plan);
  std::string text = fmt::format("\n{:{}}  {:>7}", "point", width, "members");
  std::vector<std::pair<Shown, std::size_t>> columns;  // those that a member has, and the places of their measures
  for (const auto& column : shown) {
    const auto found = std::find(table.measures.begin(), table.measures.end(), column.measure);
    const auto m = static_cast<std::size_t>(found - table.measures.begin());
    const auto has = [&](const auto& entries) { return m < entries.size() && entries[m].count > 0; };
    if (std::any_of(table.entries.begin(), table.entries.end(), has)) columns.emplace_back(column, m);
  }
  for (const auto& [column, m] : columns) text += fmt::format("  {:>{}}", column.head, column_width);
  text += "\n";
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    text += fmt::format("{:{}}  {:>7}", plan.points[p].name, width, table.finished[p]);
    for (const auto& [column, m] : columns) {
      const auto& entry = table.entries[p][m];
      text += fmt::format("  {:>{}}", with_error(entry.mean, entry.error, column.decimals), column_width);
    }
    if (table.failed[p] > 0) text += fmt::format("  {} failed", table.failed[p]);
    text += "\n";
  }
  const bool has_drops = std::any_of(table.members.begin(), table.members.end(),
                                     [](const MemberRow& member) { return !member.drops.empty(); });
  text += claims_text(plan, table);
  text += fmt::format("\nwritten          {}/table.csv, members.csv, {}sweep.h5\n", folder.path(),
                      std::string(plan.claims.empty() ? "" : "claims.csv, claims.json, ") +
                          (plan.fits.empty() ? "" : "heights.csv, heights.json, ") + (has_drops ? "drops.csv, " : ""));
  return text;
}

SweepView::SweepView(const SweepFolder& folder, const Sweep& sweep, bool quiet)
    : folder_(folder),
      sweep_(sweep),
      quiet_(quiet),
      terminal_(::isatty(STDOUT_FILENO) == 1),
      share_at_start_(sweep.fraction()),
      results_(folder.members().size()) {
  if (quiet_) return;
  say("{}", describe_plan(folder.plan()));
  const auto earlier = sweep.count(Stage::finished) + sweep.count(Stage::failed);
  if (earlier > 0) say("resuming         {} members have already ended and are kept\n", earlier);
  say("output           {}\n", folder.path());
  std::fflush(stdout);
  for (std::size_t k = 0; k < results_.size(); ++k) {
    if (sweep.progress()[k].stage == Stage::finished) read_results(k);
  }
}

std::string SweepView::member_name(std::size_t member) const {
  const auto& [point, seed] = folder_.members()[member];
  return fmt::format("{} seed {}", folder_.plan().points[point].name, seed);
}

void SweepView::read_results(std::size_t member) {
  for (const auto& [name, value] : folder_.measures(folder_.members()[member])) results_[member][name] = value;
}

std::string SweepView::time_left() const {
  const double done = sweep_.fraction() - share_at_start_;
  if (done <= 0.0) return "-";
  return clock_text(sweep_.wall_seconds() * (1.0 - sweep_.fraction()) / done);
}

void SweepView::ended(std::size_t member) {
  const auto& progress = sweep_.progress()[member];
  if (progress.stage == Stage::failed) {
    finish();
    complain("{}: failed: {}\n", member_name(member), progress.message);
  } else {
    read_results(member);
  }
  if (quiet_ || terminal_) return;
  const auto ended = sweep_.count(Stage::finished) + sweep_.count(Stage::failed);
  std::string text = fmt::format("[{}/{}] {}: {} in {:.0f} s", ended, results_.size(), member_name(member),
                                 progress.stage == Stage::failed ? "failed" : "finished", progress.seconds);
  for (const auto& column : shown) {
    const auto value = results_[member].find(column.measure);
    if (value == results_[member].end() || std::isnan(value->second)) continue;
    text += fmt::format(", {} {:.{}f}", column.head, value->second, column.decimals);
  }
  say("{}; {} left\n", text, time_left());
  std::fflush(stdout);
}

std::string SweepView::live_table() const {
  const auto& plan = folder_.plan();
  const auto width = name_width(plan);
  std::string text = fmt::format("{:{}}  {:>9}  {:>7}", "point", width, "members", "running");
  for (const auto& column : {shown[0], shown[1], shown[3]}) text += fmt::format("  {:>{}}", column.head, column_width);
  text += "\n";
  constexpr std::size_t most_lines = 30;
  for (std::size_t p = 0; p < std::min(plan.points.size(), most_lines); ++p) {
    std::size_t finished = 0;
    std::string running;
    std::map<std::string, std::vector<double>> values;
    for (std::size_t k = 0; k < results_.size(); ++k) {
      if (folder_.members()[k].point != p) continue;
      const auto& progress = sweep_.progress()[k];
      if (progress.stage == Stage::finished) ++finished;
      if (progress.stage == Stage::running)
        running += fmt::format("{}{:.0f}%", running.empty() ? "" : " ", 100.0 * progress.fraction);
      for (const auto& [name, value] : results_[k]) values[name].push_back(value);
    }
    text += fmt::format("{:{}}  {:>9}  {:>7}", plan.points[p].name, width,
                        fmt::format("{}/{}", finished, plan.seeds.size()), running);
    for (const auto& column : {shown[0], shown[1], shown[3]}) {
      const auto estimate = mean_of(values[column.measure]);
      text += fmt::format("  {:>{}}", with_error(estimate.mean, estimate.error, column.decimals), column_width);
    }
    text += "\n";
  }
  if (plan.points.size() > most_lines) text += fmt::format("and {} more points\n", plan.points.size() - most_lines);
  text += fmt::format("{:.1f} %  {} finished, {} failed of {}  {} left\n", 100.0 * sweep_.fraction(),
                      sweep_.count(Stage::finished), sweep_.count(Stage::failed), results_.size(), time_left());
  return text;
}

void SweepView::tick() {
  if (quiet_ || !terminal_) return;
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < 0.5) return;
  last_ = now;
  finish();
  const auto text = live_table();
  say("{}", text);
  std::fflush(stdout);
  lines_drawn_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void SweepView::finish() {
  if (lines_drawn_ > 0) say("\033[{}A\033[J", lines_drawn_);
  std::fflush(stdout);
  lines_drawn_ = 0;
}

}  // namespace repose
