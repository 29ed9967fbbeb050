// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/study/study.hpp"
#include "repose/sweep/form.hpp"
#include "repose/sweep/plan_reader.hpp"
#include "repose/sweep/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace repose {

namespace {

/// Reads the keys of a study file and collects what is wrong with them.
class StudyReader : TableReader {
 public:
  StudyReader(toml::table& root, std::string path) : TableReader(std::move(path)), root_(root) {}

  void read(Study& study, SweepForm form) {
    check_keys(root_, "", {"title", "source", "states", "remark", "ensemble", "force_range", "claim", "figure"});
    study.title = text(root_, "", "title", true);
    study.source = text(root_, "", "source", true);
    study.states = text(root_, "", "states", true);
    study.remark = text(root_, "", "remark", false);
    study.force_range = flag(root_, "", "force_range");
    read_figure(study);
    auto claims = take_claims();
    take_claims_on_theory(claims, study);
    read_ensemble(std::move(claims), study, form);
    check_points(study);
    const auto rigid = [](const SweepPoint& point) {
      return point.scene.method && point.scene.method->solver() != nullptr;
    };
    if (study.force_range && std::none_of(study.plan.points.begin(), study.plan.points.end(), rigid)) {
      problem(*root_.get("force_range"),
              "force_range: only rigid grains have one, and no point is of contact-dynamics");
    }
    if (study.plan.claims.empty() && study.model_claims.empty() && study.profile_claims.empty()) {
      problems_.push_back(fmt::format("{}: claim: missing: a study judges at least one [[claim]]", path_));
    }
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  void read_figure(Study& study) {
    const auto* node = root_.get("figure");
    if (node == nullptr) return problem(root_, "figure: missing");
    const auto* table = node->as_table();
    if (table == nullptr) return problem(*node, "figure: must be a table");
    std::ostringstream json;
    json << toml::json_formatter{*table};
    study.figure = json.str();
  }

  /// The list of claims, out of the file: only a node that is moved keeps its line.
  toml::array take_claims() {
    auto* node = root_.get("claim");
    if (node == nullptr) return {};
    auto* list = node->as_array();
    if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
      problem(*node, "claim: must be a list of tables, each headed [[claim]]");
      return {};
    }
    return std::move(*list);
  }

  /// Takes the claims on models and profiles out of the list.
  void take_claims_on_theory(toml::array& claims, Study& study) {
    for (std::size_t k = 0; k < claims.size();) {
      const auto& table = *claims.get(k)->as_table();
      if (table.contains("model")) {
        read_model_claim(table, study);
      } else if (table.contains("against")) {
        read_profile_claim(table, study);
      } else {
        ++k;
        continue;
      }
      claims.erase(claims.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  Claim common_part(const toml::table& table) {
    Claim claim;
    claim.text = text(table, "claim.", "text", true);
    claim.source = text(table, "claim.", "source", false);
    for (const auto& [key, bound] : {std::pair{"above", &claim.above}, {"below", &claim.below}}) {
      const auto* node = table.get(key);
      if (node != nullptr && !node->is_number()) problem(*node, fmt::format("claim.{}: must be a number", key));
      if (node != nullptr) *bound = node->value_or(*bound);
    }
    if ((!table.contains("above") && !table.contains("below")) || !(claim.above < claim.below)) {
      problem(table, "claim.above: give above, below or both, with above < below");
    }
    return claim;
  }

  std::vector<theory::Setting> settings(const toml::table& table) {
    std::vector<theory::Setting> found;
    const auto* set = table.get("set");
    if (set == nullptr) return found;
    if (!set->is_table()) {
      problem(*set, "claim.set: must be a table of parameters of the model");
      return found;
    }
    for (const auto& [key, value] : *set->as_table()) {
      found.emplace_back(std::string(key.str()), value.is_string() ? value.value_or(std::string()) : toml_text(value));
    }
    return found;
  }

  /// The prediction of a model; an empty one where the claim does not describe any.
  theory::Table prediction(const toml::table& table, const std::string& model,
                           const std::vector<theory::Setting>& with) {
    try {
      return theory::predict(theory::make_model(model, with));
    } catch (const InputError& error) {
      for (const auto& line : error.problems()) problem(table, "claim: " + line);
    }
    return {};
  }

  void read_model_claim(const toml::table& table, Study& study) {
    check_keys(table, "claim.", {"text", "source", "model", "set", "number", "above", "below"});
    ModelClaim claim{common_part(table), text(table, "claim.", "model", true), settings(table)};
    claim.claim.measure = text(table, "claim.", "number", true);
    const auto predicted = prediction(table, claim.model, claim.settings);
    std::vector<std::string> known;
    for (const auto& number : predicted.numbers) known.push_back(number.name);
    if (!predicted.columns.empty() && std::find(known.begin(), known.end(), claim.claim.measure) == known.end()) {
      problem(table,
              fmt::format("claim.number = \"{}\": the model has {}", claim.claim.measure, fmt::join(known, ", ")));
    }
    study.model_claims.push_back(std::move(claim));
  }

  void read_profile_claim(const toml::table& table, Study& study) {
    check_keys(table, "claim.", {"text", "source", "point", "against", "set", "force", "above", "below"});
    const auto force = text(table, "claim.", "force", true);
    if (!force.empty() && force != "normal" && force != "shear") {
      problem(table, fmt::format("claim.force = \"{}\": must be \"normal\" or \"shear\"", force));
    }
    ProfileClaim claim{common_part(table), {text(table, "claim.", "against", true), settings(table)}, force == "shear"};
    claim.claim.measure = fmt::format("deviation of the {} force", force);
    claim.claim.points = {text(table, "claim.", "point", true)};
    const auto predicted = prediction(table, claim.against.model, claim.against.settings);
    if (!predicted.columns.empty() && !predicted.has_column("x_over_b")) {
      problem(table, fmt::format("claim.against = \"{}\": is no model of base forces", claim.against.model));
    }
    study.profile_claims.push_back(std::move(claim));
  }

  void check_points(const Study& study) {
    for (const auto& claim : study.profile_claims) {
      const auto& name = claim.claim.points.front();
      const auto same = [&](const SweepPoint& point) { return point.name == name; };
      if (std::any_of(study.plan.points.begin(), study.plan.points.end(), same)) continue;
      problems_.push_back(fmt::format("{}: claim.point = \"{}\": no such point in the ensemble", path_, name));
    }
  }

  void read_ensemble(toml::array claims, Study& study, SweepForm form) {
    const auto given = text(root_, "", "ensemble", false);
    if (given.empty()) {
      if (!claims.empty()) problem(*claims.get(0), "claim: has no model, and the study has no ensemble");
      return;
    }
    study.ensemble = (fs::path(path_).parent_path() / given).lexically_normal().string();
    try {
      auto sweep = parsed_toml(text_of_file(study.ensemble), study.ensemble);
      take_form(sweep, form, study.ensemble);
      sweep.erase("claim");  // a sweep has claims of its own, which do not count here
      if (!claims.empty()) sweep.insert("claim", std::move(claims));
      study.plan = SweepReader(sweep, study.ensemble).read();
    } catch (const InputError& error) {
      problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
    }
  }

  toml::table& root_;
};

/// A name with its numbers padded, so that fig10 comes after fig9.
std::string sorting_key(const std::string& name) {
  std::string key;
  std::string digits;
  const auto pad = [&] {
    constexpr std::size_t width = 6;
    if (!digits.empty()) key += std::string(width - std::min(width, digits.size()), '0') + digits;
    digits.clear();
  };
  for (const char c : name) {
    if (c >= '0' && c <= '9') {
      digits += c;
      continue;
    }
    pad();
    key += c;
  }
  pad();
  return key;
}

}  // namespace

std::vector<StudyFile> find_studies(const std::string& folder) {
  std::vector<StudyFile> found;
  std::error_code error;
  for (const auto& group : fs::directory_iterator(folder, error)) {
    if (!group.is_directory(error)) continue;
    for (const auto& file : fs::directory_iterator(group.path(), error)) {
      if (file.path().extension() != ".toml") continue;
      found.push_back({group.path().filename().string() + "." + file.path().stem().string(), file.path().string()});
    }
  }
  if (found.empty()) throw InputError(fmt::format("{}: holds no studies (--studies DIR names their folder)", folder));
  std::sort(found.begin(), found.end(),
            [](const StudyFile& a, const StudyFile& b) { return sorting_key(a.name) < sorting_key(b.name); });
  return found;
}

std::vector<StudyFile> chosen_studies(const std::vector<StudyFile>& all, const std::vector<std::string>& names) {
  std::vector<StudyFile> chosen;
  std::vector<std::string> problems;
  std::set<std::string> taken;
  for (const auto& name : names) {
    bool known = false;
    for (const auto& study : all) {
      if (name != "all" && name != study.name && !study.name.starts_with(name + ".")) continue;
      known = true;
      if (taken.insert(study.name).second) chosen.push_back(study);
    }
    if (!known) problems.push_back(fmt::format("{}: no such study (`repose study list` names them)", name));
  }
  if (!problems.empty()) throw InputError(problems);
  return chosen;
}

Study read_study(const StudyFile& file, SweepForm form) {
  auto root = parsed_toml(text_of_file(file.path), file.path);
  Study study;
  study.name = file.name;
  study.file = file.path;
  StudyReader(root, file.path).read(study, form);
  return study;
}

}  // namespace repose
