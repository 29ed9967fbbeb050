// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/api/analysis.hpp"

#include "repose/api/measures_of_record.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/results/summary.hpp"
#include "repose/run_folder/further_analysis.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>

namespace repose::api {

namespace {

std::vector<Measure> measures_in(const std::string& summary, const std::string& name) {
  std::vector<Measure> found;
  for (auto& [measure, value] : measures_of(summary, name)) found.push_back({measure, value});
  return found;
}

}  // namespace

template <int D>
std::vector<Measure> measures_of_record(const Record<D>& record) {
  return measures_in(summary_text(record, repose::analyse(record, {})), "summary");
}
template std::vector<Measure> measures_of_record(const Record<2>&);
template std::vector<Measure> measures_of_record(const Record<3>&);

std::vector<Measure> analyse(const std::string& folder) {
  const FolderLock lock(folder);
  with_dimension(run_dimension(folder), [&](auto dimension) {
    const auto record = read_record<dimension>(folder);
    write_results(folder, lock, record, repose::analyse(record, {}));
  });
  return measures(folder);
}

std::vector<Measure> measures(const std::string& folder) {
  const auto path = folder + "/summary.json";
  const auto text = text_of_file(path);
  if (!is_whole_summary(text)) throw InputError(fmt::format("{}: damaged, or no summary of a run", path));
  return measures_in(text, path);
}

double value_of(const std::vector<Measure>& measures, const std::string& name) {
  std::string known;
  for (const auto& measure : measures) {
    if (measure.name == name) return measure.value;
    known += (known.empty() ? "" : ", ") + measure.name;
  }
  throw InputError(fmt::format("{}: no such measure; the measures are {}", name, known));
}

}  // namespace repose::api
