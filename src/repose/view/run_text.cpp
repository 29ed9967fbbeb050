// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/run_text.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

/// How numbers of a run are labelled.
Json units_of(const Scene& scene) {
  if (scene.units == "SI") {
    return {{"length", "m"},  {"time", "s"},   {"mass", "kg"},     {"force", "N"},
            {"speed", "m/s"}, {"energy", "J"}, {"pressure", "N/m"}};
  }
  if (scene.gravity == 0.0) {
    return {{"length", "L"},  {"time", "T"},         {"mass", "M"},       {"force", "M L/T²"},
            {"speed", "L/T"}, {"energy", "M L²/T²"}, {"pressure", "M/T²"}};
  }
  return {{"length", "d"},     {"time", "√(d/g)"},  {"mass", "m"},        {"force", "m g"},
          {"speed", "√(g d)"}, {"energy", "m g d"}, {"pressure", "m g/d"}};
}

double mean_force(const Record<2>& run) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto& contact : run.contacts.list) {
    if (contact.normal_force == 0.0) continue;
    sum += std::fabs(contact.normal_force);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// The avalanches that the analysis of this state found.
Json avalanches_of(const std::string& folder, const Record<2>& run) {
  auto list = Json::array();
  const auto path = folder + "/analysis.h5";
  if (!path_exists(path)) return list;
  const Hdf5Reader file(path);
  if (file.text_or("/", "state_hash", "") != run.facts.state_hash || !file.has("avalanches/start")) return list;
  const auto start = file.dataset<double>("avalanches/start");
  const auto end = file.dataset<double>("avalanches/end");
  const auto size = file.dataset<std::int64_t>("avalanches/size");
  for (std::size_t k = 0; k < std::min({start.size(), end.size(), size.size()}); ++k) {
    list.push_back({{"start", start[k]}, {"end", end[k]}, {"size", size[k]}});
  }
  return list;
}

bool analysis_has(const std::string& folder, const std::string& name) try {
  const auto path = folder + "/analysis.h5";
  return path_exists(path) && Hdf5Reader(path).has(name);
} catch (const InputError&) {
  return false;
}

/// The avalanches, or none where analysis.h5 is being written or is damaged: the run can be seen all the same.
Json readable_avalanches(const std::string& folder, const Record<2>& run) try {
  return avalanches_of(folder, run);
} catch (const InputError&) {
  return Json::array();
}

}  // namespace

std::string describe_run(const std::string& folder, const Record<2>& run, const std::vector<FrameTime>& frames,
                         const RunBox& box) {
  const auto& scene = run.scene;
  const auto& facts = run.facts;
  auto moments = Json::array();
  for (const auto& one : frames) moments.push_back({{"key", one.key}, {"time", one.time}});
  auto names = scene.material_names();
  const Hdf5Reader file(folder + "/run.h5");
  Json all{{"title", scene.title},
           {"method", file.text("/", "method")},
           {"units", scene.units},
           {"seed", scene.seed},
           {"dimension", 2},
           {"status", status_text(facts.status)},
           {"message", facts.message},
           {"time", facts.time},
           {"grains", run.grains.size()},
           {"released", facts.released},
           {"lost", facts.lost},
           {"box",
            {{"low", {box.low[0], box.low[1]}}, {"high", {box.high[0], box.high[1]}}, {"periodic", run.box.periodic}}},
           {"grain_diameter", scene.grains.diameter},
           {"grain_weight", file.number("/", "grain_weight")},
           {"gravity", {0.0, -scene.gravity}},
           {"materials", names},
           {"unit", units_of(scene)},
           {"frames", moments},
           {"force_scale", mean_force(run)},
           {"avalanches", readable_avalanches(folder, run)},
           {"has",
            {{"series", !run.series.empty()},
             {"base", file.has("base/x") || analysis_has(folder, "walls/pressure")},
             {"fields", analysis_has(folder, "fields/x")},
             {"summary", path_exists(folder + "/summary.json")}}}};
  if (run.box.periodic) all["box"]["period"] = run.box.width();
  return all.dump();
}

}  // namespace repose
