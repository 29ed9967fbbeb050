// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/inference.hpp"
#include "repose/comparison/base_overlay.hpp"
#include "repose/study/study.hpp"
#include "repose/sweep/determined.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// What is known of a number: its interval is a point where it is exact, and NaN where it has none.
struct Found {
  double value, error, low, high;
  std::string test = "exact";
  Json count = nullptr;
};

Found exactly(double value) { return {value, 0.0, value, value}; }

/// By the rule of all claims: the interval lies within the bounds, wholly outside, or neither.
const char* word_of(const Claim& claim, const Found& found) {
  if (std::isnan(found.value)) return "no data";
  if (found.low > claim.above && found.high < claim.below) return "agrees";
  if (found.high <= claim.above || found.low >= claim.below) return "disagrees";
  return "undecided";
}

/// A claim with the keys that claims on ensembles have.
Json judged(const Claim& claim, const std::string& kind, const std::string& points, const Found& found,
            const char* word) {
  return {{"claim", claim.text},
          {"source", claim.source},
          {"measure", claim.measure},
          {"kind", kind},
          {"points", points},
          {"above", json_number(claim.above)},
          {"below", json_number(claim.below)},
          {"value", json_number(found.value)},
          {"error", json_number(found.error)},
          {"verdict", word},
          {"low", json_number(found.low)},
          {"high", json_number(found.high)},
          {"test", found.test},
          {"n", found.count},
          {"verdict_holm", word}};
}

std::string written(const std::string& model, const std::vector<theory::Setting>& settings) {
  auto text = model;
  for (const auto& [key, value] : settings) text += fmt::format(" {}={}", key, value);
  return text;
}

/// The number of independent runs of a model that draws random numbers; 0 for others.
double runs_of(const theory::Model& model) {
  for (const auto& parameter : theory::parameters_of(model)) {
    if (parameter.name == "runs") return std::stod(parameter.value);
  }
  return 0.0;
}

/// A number NAME is exact unless its model has NAME_error too, the standard error between its runs.
Json judged(const ModelClaim& wanted) {
  const auto model = theory::make_model(wanted.model, wanted.settings);
  const auto table = theory::predict(model);
  const auto& name = wanted.claim.measure;
  auto found = exactly(table.number(name));
  for (const auto& number : table.numbers) {
    if (number.name != name + "_error" || !(number.value > 0.0)) continue;
    const double runs = runs_of(model);
    const auto inference = value_by_t(found.value, number.value, runs - 1.0);
    found = {found.value, number.value, inference.low, inference.high, "t", static_cast<std::size_t>(runs)};
  }
  return judged(wanted.claim, "model", written(wanted.model, wanted.settings), found, word_of(wanted.claim, found));
}

bool same_base(const BaseProfile& a, const BaseProfile& b) {
  return a.x == b.x && a.normal == b.normal && a.shear == b.shear;
}

/// The largest deviation over the largest force of the model: disc by disc where the model has a row for each loaded
/// disc, without any matching; otherwise in the bins of the measured base, where weight and width of the model are
/// matched.
double deviation(const ProfileClaim& wanted, const MeasuredBase& base) {
  const auto table = theory::predict(theory::make_model(wanted.against.model, wanted.against.settings));
  const auto& of_model = table.column(wanted.shear ? "shear" : "normal").values;
  std::vector<double> measured;
  std::vector<double> residual;
  if (static_cast<std::int64_t>(of_model.size()) == base.loaded_discs()) {
    const auto& forces = wanted.shear ? base.discs.shear : base.discs.normal;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      if (!base.loaded(base.discs.x[k])) continue;
      residual.push_back(forces[k] - of_model[measured.size()]);
      measured.push_back(forces[k]);
    }
  } else {
    const auto residuals = compare(wanted.against, base).residuals;
    residual = wanted.shear ? residuals.shear : residuals.normal;
    const auto& bins = wanted.shear ? base.bins.shear : base.bins.normal;
    for (const double x : residuals.x) {
      const auto bin = std::find(base.bins.x.begin(), base.bins.x.end(), x) - base.bins.x.begin();
      measured.push_back(bins[static_cast<std::size_t>(bin)]);
    }
  }
  double largest = 0.0;
  double scale = 0.0;
  for (std::size_t k = 0; k < residual.size(); ++k) {
    largest = std::max(largest, std::fabs(residual[k]));
    scale = std::max(scale, std::fabs(measured[k] - residual[k]));
  }
  return largest / scale;
}

Json judged(const ProfileClaim& wanted, const Study& study, const SweepTable& table, const std::string& folder) {
  std::size_t point = 0;
  while (study.plan.points[point].name != wanted.claim.points.front()) ++point;
  const MemberRow* first = nullptr;
  bool same = true;
  for (const auto& member : table.members) {
    if (member.point != point || member.status != "finished") continue;
    if (first == nullptr) first = &member;
    same &= same_base(member.base, first->base);
  }
  const double none = std::nan("");
  Found found{none, none, none, none};
  if (first != nullptr) found.value = deviation(wanted, measured_base(folder, point));
  if (same) found = exactly(found.value);
  // The rule for base forces of rigid grains (sweep/determined.hpp), which knows measures by their names.
  auto of_profile = wanted.claim;
  of_profile.measure = "profile.deviation";
  const bool determined = is_determined(of_profile, study.plan, table);
  const auto* word = determined || first == nullptr ? word_of(wanted.claim, found) : "not determined";
  const auto against = written(wanted.against.model, wanted.against.settings);
  return judged(wanted.claim, "profile", wanted.claim.points.front() + " against " + against, found, word);
}

}  // namespace

std::string study_json(const Study& study, SweepForm form, const SweepTable& table, const std::string& folder,
                       const std::string& place) {
  Json claims = Json::array();
  Json ensemble = nullptr;
  if (!study.ensemble.empty()) {
    SweepTable judged_table = table;
    judged_table.verdicts = judge_claims(study.plan, table);
    claims = Json::parse(claims_json(study.plan, judged_table))["claims"];
    Json points = Json::array();
    for (std::size_t p = 0; p < study.plan.points.size(); ++p) {
      points.push_back(
          {{"name", study.plan.points[p].name}, {"finished", table.finished[p]}, {"failed", table.failed[p]}});
    }
    ensemble = {{"title", study.plan.title},
                {"folder", fs::relative(folder, place).string()},
                {"seeds", study.plan.seeds},
                {"points", points}};
  }
  for (const auto& claim : study.profile_claims) claims.push_back(judged(claim, study, table, folder));
  for (const auto& claim : study.model_claims) claims.push_back(judged(claim));
  const Json all{
      {"study", study.name},    {"title", study.title},   {"source", study.source},
      {"states", study.states}, {"remark", study.remark}, {"form", form == SweepForm::quick ? "quick" : "full"},
      {"ensemble", ensemble},   {"claims", claims},       {"figure", Json::parse(study.figure)}};
  return all.dump(2) + "\n";
}

std::string study_text(const std::string& json) {
  const auto study = Json::parse(json);
  auto text = fmt::format("\n{}  {}\n", study["study"].get<std::string>(), study["title"].get<std::string>());
  const auto number = [](const Json& value) {
    return value.is_null() ? std::string("-") : fmt::format("{:.4g}", value.get<double>());
  };
  for (const auto& claim : study["claims"]) {
    text += fmt::format("  {:14}  {}\n", claim["verdict"].get<std::string>(), claim["claim"].get<std::string>());
    text += fmt::format("  {:14}  {}, 95 % interval {} to {}", "", number(claim["value"]), number(claim["low"]),
                        number(claim["high"]));
    if (!claim["n"].is_null()) text += fmt::format(", n = {}", claim["n"].get<std::size_t>());
    text += fmt::format("; claimed {} to {}\n", number(claim["above"]), number(claim["below"]));
  }
  return text;
}

}  // namespace repose
