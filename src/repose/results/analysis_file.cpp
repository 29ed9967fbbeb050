// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/analysis_file.hpp"

#include "repose/core/version.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/results/registry.hpp"

#include <cmath>
#include <limits>

namespace repose {

namespace {

/// The numbers of the grains, one row each.
template <int D>
std::vector<MeasureRow> rows_of(const MeasuredIn<D>& run) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<MeasureRow> rows;
  for (const auto& measured : measured_values(run)) {
    const auto& measure = measured.measure;  // no structured binding: clang 14 does not capture one
    const auto& value = measured.value;
    if (!measure.of_grains) continue;
    const auto add = [&](const std::string& name, double number, const std::string& meaning) {
      rows.push_back({name, std::isfinite(number) ? number : none, measure.unit, meaning});
    };
    if (measure.kind == KnownMeasure::Kind::number) {
      const auto* count = std::get_if<std::int64_t>(&value);
      const auto* number = std::get_if<double>(&value);
      add(measure.name, count ? static_cast<double>(*count) : number ? *number : none, measure.meaning);
    } else if (measure.kind == KnownMeasure::Kind::estimate) {
      const auto* estimate = std::get_if<Estimate>(&value);
      add(measure.name + ".mean", estimate ? estimate->mean : none, measure.meaning);
      add(measure.name + ".error", estimate ? estimate->error : none, "its standard error");
    }
  }
  return rows;
}

}  // namespace

const Group<std::vector<MeasureRow>>& measure_group() {
  static const Group<std::vector<MeasureRow>> group{
      "measures",
      "rows",
      {},
      {
          column("name", &MeasureRow::name, "", "dotted, as in summary.json"),
          column("value", &MeasureRow::value, "", "in the unit of the row; NaN where it is not defined"),
          column("unit", &MeasureRow::unit, "", "of the value"),
          column("meaning", &MeasureRow::meaning, "", "of the value"),
      }};
  return group;
}

template <int D>
void write_analysis(const std::string& path, const Record<D>& record, const Results<D>& results) {
  const MeasuredIn<D> run{record, results};
  Hdf5File file(path, record.scene.units);
  file.attribute("/", "format", std::string("repose-analysis"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "time", record.facts.time);
  file.attribute("/", "state_hash", record.facts.state_hash);
  file.attribute("/", "scene_hash", record.facts.scene_hash);
  write_group(file, measure_group(), rows_of(run));
  for (const auto& group : analysis_groups<D>()) group.write(file, run);
  file.commit();
}

template void write_analysis(const std::string&, const Record<2>&, const Results<2>&);
template void write_analysis(const std::string&, const Record<3>&, const Results<3>&);

}  // namespace repose
