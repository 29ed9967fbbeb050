// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/comparison/base_overlay.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "repose/record/record_file.hpp"
#include "repose/results/summary.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/sweep/folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* slope_measure = "angle_of_repose_deg.mean";

/// The summary of a finished run. Throws InputError unless it is whole and describes the last state.
Json finished_summary(const std::string& folder) {
  const auto path = folder + "/summary.json";
  for (const auto* name : {"run.h5", "summary.json", "analysis.h5"}) {
    if (!path_exists(std::filesystem::path(folder) / name)) {
      throw InputError(fmt::format("{}: holds neither an analysed run nor a sweep: no {}", folder, name));
    }
  }
  const auto facts = read_run_facts(folder);
  if (facts.status == Status::failed) throw InputError(fmt::format("{}: the run failed", folder));
  if (facts.status != Status::finished) {
    throw InputError(fmt::format("{}: the run has not finished ({}): `repose resume {}` continues it", folder,
                                 status_text(facts.status), folder));
  }
  const auto text = text_of_file(path);
  if (!is_whole_summary(text)) {
    throw InputError(fmt::format(
        "{}: damaged: its content differs from what Repose wrote; `repose analyse {}` writes it again", path, folder));
  }
  auto json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("state_hash", "") != facts.state_hash) {
    throw InputError(fmt::format("{}: does not describe the last state of the run; `repose analyse {}` writes it again",
                                 path, folder));
  }
  check_belongs(Hdf5Reader(folder + "/analysis.h5"), facts);
  return json;
}

std::vector<double> numbers(const Json& list) { return list.get<std::vector<double>>(); }

BinnedProfile read_bins(const Hdf5Reader& file, const std::string& group) {
  BinnedProfile bins;
  bins.bin_width = file.number(group, "bin_width");
  bins.x = file.dataset<double>(group + "/x");
  bins.normal = file.dataset<double>(group + "/normal");
  bins.normal_error = file.dataset<double>(group + "/normal_error");
  bins.shear = file.dataset<double>(group + "/shear");
  bins.shear_error = file.dataset<double>(group + "/shear_error");
  return bins;
}

/// Throws InputError unless the bins are those of the discs.
void check(const MeasuredBase& base, const std::string& name) {
  const auto& bins = base.bins;
  const auto count = bins.x.size();
  const bool lengths = bins.normal.size() == count && bins.normal_error.size() == count && bins.shear.size() == count &&
                       bins.shear_error.size() == count && base.discs.normal.size() == base.discs.x.size() &&
                       base.discs.shear.size() == base.discs.x.size();
  if (!lengths || binned(base.discs, bins.bin_width).x != bins.x) {
    throw InputError(fmt::format("{}: the bins do not match the base profile", name));
  }
}

/// The parameters of a model as JSON; null: not set.
Json parameters_json(const theory::Model& model) {
  Json json = Json::object();
  for (const auto& parameter : theory::parameters_of(model)) {
    auto& value = json[parameter.name] = nullptr;
    if (!parameter.is_set) continue;
    const auto number = Json::parse(parameter.value, nullptr, false);
    const bool word = parameter.unit.empty() || !number.is_number();  // infinity is a word too
    value = word ? Json(parameter.value) : number;
  }
  return json;
}

Json agreement_json(const Agreement& agreement) {
  return {{"chi_square", agreement.degrees > 0 ? Json(agreement.chi_square) : Json(nullptr)},
          {"degrees", agreement.degrees},
          {"bins", agreement.bins},
          {"rms", agreement.rms},
          {"rms_over_mean", agreement.rms_over_mean}};
}

Json comparison_json(const TheoryComparison& comparison) {
  const auto& residuals = comparison.residuals;
  return {{"model", std::string{theory::text_of(comparison.model).name}},
          {"parameters", parameters_json(comparison.model)},
          {"from_run", comparison.from_run},
          {"weight", comparison.weight},
          {"base",
           {{"centre", comparison.left + 0.5 * comparison.width},
            {"width", comparison.width},
            {"left", comparison.left},
            {"spacing", comparison.spacing}}},
          {"scale", comparison.scale},
          {"normal", agreement_json(comparison.normal)},
          {"shear", agreement_json(comparison.shear)},
          {"residuals",
           {{"x", residuals.x},
            {"normal", residuals.normal},
            {"normal_error", residuals.normal_error},
            {"shear", residuals.shear},
            {"shear_error", residuals.shear_error}}}};
}

Json list_json(const std::vector<BaseOverlay>& all) {
  Json list = Json::array();
  for (const auto& base : all) {
    for (const auto& comparison : base.models) {
      Json entry = Json::object();
      if (!base.point.empty()) entry = {{"point", base.point}, {"members", base.members}};
      entry.update(comparison_json(comparison));
      list.push_back(std::move(entry));
    }
  }
  return list;
}

/// Lists inside an object begin in the column of their key.
std::string indented(const std::string& text) {
  std::string all;
  for (const char c : text) {
    all += c;
    if (c == '\n') all += "  ";
  }
  return all;
}

void add_problems(const InputError& error, std::vector<std::string>& problems) {
  for (const auto& problem : error.problems()) {
    if (std::ranges::find(problems, problem) == problems.end()) problems.push_back(problem);
  }
}

BaseOverlay compare_models(const MeasuredBase& base, const std::vector<TheoryChoice>& choices,
                           std::vector<std::string>& problems) {
  BaseOverlay result;
  for (const auto& choice : choices) {
    try {
      result.models.push_back(compare(choice, base));
    } catch (const InputError& error) {
      add_problems(error, problems);
    }
  }
  return result;
}

std::vector<BaseOverlay> compare_sweep(const std::string& folder, const std::vector<TheoryChoice>& choices,
                                       std::vector<std::string>& problems) {
  const Hdf5Reader file(folder + "/sweep.h5");
  const auto open = std::ranges::count_if(file.texts("members/status"), [](const std::string& status) {
    return status != status_text(Status::finished) && status != status_text(Status::failed);
  });
  if (open > 0) {
    throw InputError(
        fmt::format("{0}: the sweep has not finished, {1} members are open: `repose sweep {0}/sweep.toml` "
                    "continues it",
                    folder, open));
  }
  const auto names = file.texts("points/name");
  std::vector<BaseOverlay> all;
  bool any = false;
  for (std::size_t p = 0; p < names.size(); ++p) {
    BaseOverlay overlay;
    try {
      const auto base = measured_base(folder, p);
      any = true;
      overlay = compare_models(base, choices, problems);
      overlay.members = file.integer(fmt::format("profiles/{:04}", p), "members");
    } catch (const InputError& error) {
      overlay.problem = error.what();
    }
    overlay.point = names[p];
    all.push_back(std::move(overlay));
  }
  if (!any)
    problems.push_back(fmt::format("{}: no point has a base profile that theory could be compared with", folder));
  return all;
}

void write(const std::string& folder, const std::vector<BaseOverlay>& all, bool sweep) {
  const auto path = folder + "/summary.json";
  const auto list = list_json(all);
  if (!sweep) {
    write_text_file(path, with_theory(text_of_file(path), indented(list.dump(2))));
    return;
  }
  const Hdf5Reader file(folder + "/sweep.h5");
  const Json json = {{"title", file.text("/", "title")}, {"repose_version", version}, {"theory", list}};
  write_text_file(path, with_checksum(json.dump(2)));
}

}  // namespace

TheoryChoice read_choice(const std::string& written, std::vector<std::string>& problems) {
  TheoryChoice choice;
  const auto colon = written.find(':');
  choice.model = written.substr(0, colon);
  const auto models = theory::default_models();
  if (std::ranges::none_of(models, [&](const auto& model) { return theory::text_of(model).name == choice.model; })) {
    problems.push_back(fmt::format("--theory {}: no such model of theory; must be {}", written, theory::model_names()));
  }
  if (colon == std::string::npos) return choice;
  std::size_t start = colon + 1;
  while (start <= written.size()) {
    const auto end = std::min(written.find(',', start), written.size());
    const auto setting = written.substr(start, end - start);
    if (auto pair = theory::read_setting(setting)) {
      choice.settings.push_back(std::move(*pair));
    } else {
      problems.push_back(fmt::format("--theory {}: {}: must be key=value", written, setting.empty() ? "''" : setting));
    }
    start = end + 1;
  }
  return choice;
}

MeasuredBase measured_base(const std::string& folder) {
  const auto json = finished_summary(folder);
  const Hdf5Reader file(folder + "/analysis.h5");
  if (json.at("base_profile").is_null() || !file.has("base")) {
    throw InputError(fmt::format("{}: no base profile: the heap stands on no base of grains and no plane", folder));
  }
  if (json.at("base_dip").is_null()) throw InputError(fmt::format("{}: nothing rests on the base", folder));
  MeasuredBase base;
  base.discs.x = numbers(json.at("base_profile").at("x"));
  base.discs.normal = numbers(json.at("base_profile").at("normal"));
  base.discs.shear = numbers(json.at("base_profile").at("shear"));
  base.bins = read_bins(file, "base");
  base.centre = json.at("base_dip").at("centre").get<double>();
  base.half_width = json.at("base_dip").at("half_width").get<double>();
  const auto& slope = json.at("angle_of_repose_deg").at("mean");
  if (slope.is_number()) base.slope_deg = slope.get<double>();
  check(base, folder + "/analysis.h5");
  return base;
}

MeasuredBase measured_base(const std::string& folder, std::size_t point) {
  const Hdf5Reader file(folder + "/sweep.h5");
  const auto group = fmt::format("profiles/{:04}", point);
  if (!file.has(group)) throw InputError("no base profile (no member has finished, or their bases differ)");
  MeasuredBase base;
  base.discs.x = file.dataset<double>(group + "/x");
  base.discs.normal = file.dataset<double>(group + "/normal");
  base.discs.shear = file.dataset<double>(group + "/shear");
  base.bins = read_bins(file, group + "/binned");
  base.centre = file.number(group, "centre");
  base.half_width = file.number(group, "half_width");
  if (!std::isfinite(base.centre) || !std::isfinite(base.half_width)) throw InputError("nothing rests on the base");
  const auto measure = fmt::format("measures/{}", slope_measure);
  if (file.has(measure)) {
    const double slope = file.dataset<double>(measure + "/mean").at(point);
    if (std::isfinite(slope)) base.slope_deg = slope;
  }
  check(base, folder + "/sweep.h5");
  return base;
}

std::vector<BaseOverlay> overlay_theory(const std::string& folder, const std::vector<std::string>& choices) {
  std::vector<std::string> problems;
  std::vector<TheoryChoice> chosen;
  for (const auto& written : choices) {
    const auto before = problems.size();
    auto choice = read_choice(written, problems);
    if (problems.size() == before) chosen.push_back(std::move(choice));
  }
  std::vector<BaseOverlay> all;
  try {
    const FolderLock lock(folder);
    const bool sweep = SweepFolder::is_one(folder);
    if (sweep) {
      all = compare_sweep(folder, chosen, problems);
    } else {
      all.push_back(compare_models(measured_base(folder), chosen, problems));
    }
    if (problems.empty()) write(folder, all, sweep);
  } catch (const InputError& error) {
    add_problems(error, problems);
  } catch (const Json::exception&) {
    problems.push_back(fmt::format("{}/summary.json: is no summary of this version of Repose", folder));
  }
  if (!problems.empty()) throw InputError(problems);
  return all;
}

}  // namespace repose
