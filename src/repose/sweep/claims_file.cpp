// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/bootstrap.hpp"
#include "repose/sweep/csv_cells.hpp"
#include "repose/sweep/groups.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace repose {

namespace {

using Cell = std::variant<std::string, double, std::size_t>;

struct ClaimColumn {
  const char* name;
  const char* meaning;
  std::function<Cell(const Claim&, const Verdict&)> cell;
};

const char* name_of(Claim::Kind kind) {
  switch (kind) {
    case Claim::Kind::value:
      return "value";
    case Claim::Kind::difference:
      return "difference";
    case Claim::Kind::equivalence:
      return "equivalence";
    case Claim::Kind::fit:
      return "fit";
  }
  return "";
}

/// The columns of claims.csv and the keys of claims.json. New ones come last: programs read them by place, too.
const std::vector<ClaimColumn>& claim_columns() {
  const auto of_claim = [](auto Claim::*member) {
    return [member](const Claim& claim, const Verdict&) -> Cell { return claim.*member; };
  };
  const auto of_verdict = [](auto Verdict::*member) {
    return [member](const Claim&, const Verdict& verdict) -> Cell { return verdict.*member; };
  };
  const auto inferred = [](auto Inference::*member) {
    return [member](const Claim&, const Verdict& verdict) -> Cell { return verdict.inference.*member; };
  };
  static const std::vector<ClaimColumn> columns{
      {"claim", "its text", of_claim(&Claim::text)},
      {"source", "who states it", of_claim(&Claim::source)},
      {"measure", "a column of `table.csv`", of_claim(&Claim::measure)},
      {"kind", "value, difference, equivalence or fit",
       [](const Claim& claim, const Verdict&) -> Cell { return name_of(claim.kind); }},
      {"points", "names, with spaces between",
       [](const Claim& claim, const Verdict&) -> Cell { return fmt::format("{}", fmt::join(claim.points, " ")); }},
      {"above", "lower bound; of an equivalence -margin", of_claim(&Claim::above)},
      {"below", "upper bound; of an equivalence margin", of_claim(&Claim::below)},
      {"value", "of the statistic; of an equivalence the difference of the pair that decides",
       inferred(&Inference::value)},
      {"error", "its standard error", inferred(&Inference::error)},
      {"verdict", "by the 95 % interval alone", of_verdict(&Verdict::word)},
      {"low", "lower end of the 95 % interval of the statistic", inferred(&Inference::low)},
      {"high", "upper end", inferred(&Inference::high)},
      {"bias", "of the statistic, estimated by the bootstrap, not subtracted; none for means",
       inferred(&Inference::bias)},
      {"test", "t, paired t, Welch t, bootstrap, paired bootstrap, unpaired bootstrap or fit",
       inferred(&Inference::test)},
      {"n", "members that the statistic is from; seeds where it is paired; points of a fit",
       inferred(&Inference::count)},
      {"n_missing", "finished members that are left out, because they lack the measure or their partner does",
       of_verdict(&Verdict::missing)},
      {"pair", "of an equivalence: the two points that decide",
       [](const Claim&, const Verdict& verdict) -> Cell {
         return verdict.pair.first.empty() ? "" : verdict.pair.first + " " + verdict.pair.second;
       }},
      {"p_holds", "one-sided p-value by which the claim holds", of_verdict(&Verdict::p_holds)},
      {"p_fails", "one-sided p-value by which it fails", of_verdict(&Verdict::p_fails)},
      {"p_holds_holm", "p_holds, adjusted for the number of claims", of_verdict(&Verdict::p_holds_holm)},
      {"p_fails_holm", "p_fails, adjusted likewise", of_verdict(&Verdict::p_fails_holm)},
      {"verdict_holm", "by the adjusted p-values", of_verdict(&Verdict::holm_word)},
      {"fit", "name of the fit of which the measure is a number", of_claim(&Claim::fit)},
  };
  return columns;
}

std::string csv_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csv_text(*text);
  if (const auto* count = std::get_if<std::size_t>(&cell)) return fmt::format("{}", *count);
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? csv_number(number) : "";
}

nlohmann::ordered_json json_value(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::size_t>(&cell)) return *count;
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::string claims_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text;
  for (const auto& column : claim_columns()) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  text += "\n";
  for (std::size_t k = 0; k < plan.claims.size(); ++k) {
    std::string line;
    for (const auto& column : claim_columns()) {
      if (&column != &claim_columns().front()) line += ",";
      line += csv_cell(column.cell(plan.claims[k], table.verdicts[k]));
    }
    text += line + "\n";
  }
  return text;
}

std::string claims_json(const SweepPlan& plan, const SweepTable& table) {
  auto claims = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < plan.claims.size(); ++k) {
    nlohmann::ordered_json one;
    for (const auto& column : claim_columns()) {
      one[column.name] = json_value(column.cell(plan.claims[k], table.verdicts[k]));
    }
    claims.push_back(std::move(one));
  }
  const nlohmann::ordered_json all{{"interval", interval_probability},
                                   {"level", test_level},
                                   {"adjustment", "Holm"},
                                   {"resamples", resamples},
                                   {"claims", claims}};
  return all.dump(2) + "\n";
}

ReferenceTable claims_reference() {
  ReferenceTable reference{"claims", {"column", "meaning"}, {}};
  for (const auto& column : claim_columns()) {
    reference.rows.push_back({fmt::format("`{}`", column.name), column.meaning});
  }
  return reference;
}

}  // namespace repose
