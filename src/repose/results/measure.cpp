// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/measure.hpp"

#include "repose/results/registry.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

bool has(const Scene& scene, Needs needs) {
  switch (needs) {
    case Needs::nothing:
      return true;
    case Needs::forces:
      return scene.method->traits().has_forces();
    case Needs::solver:
      return scene.method->solver() != nullptr;
    case Needs::collisions:
      return scene.method->traits().collides;
    case Needs::deposition:
      return scene.method->sticking_angle().has_value();
  }
  return false;
}

MeasureValue measure_value(Object value) { return value; }
MeasureValue measure_value(double value) {
  if (!std::isfinite(value)) return {};
  return value;
}
MeasureValue measure_value(std::string value) { return value; }
MeasureValue measure_value(std::vector<double> value) { return value; }
MeasureValue measure_value(std::vector<std::string> value) { return value; }
MeasureValue measure_value(const Estimate& value) { return value; }

template <int D>
std::vector<MeasuredValue> measured_values(const MeasuredIn<D>& run) {
  std::vector<MeasuredValue> values;
  std::vector<std::string> closed;  // beginnings of names below objects that are null or left out
  for (const auto& measure : measures<D>()) {
    const auto below = [&](const std::string& beginning) { return measure.name.starts_with(beginning); };
    if (std::any_of(closed.begin(), closed.end(), below)) continue;
    const bool exists = !measure.exists || measure.exists(run);
    auto value = exists && has(run.record.scene, measure.needs) ? measure.value(run) : MeasureValue{};
    if (measure.kind == KnownMeasure::Kind::object && !std::holds_alternative<Object>(value)) {
      closed.push_back(measure.name + ".");
    }
    if (exists) values.push_back({measure, std::move(value)});
  }
  return values;
}

template std::vector<MeasuredValue> measured_values(const MeasuredIn<2>&);
template std::vector<MeasuredValue> measured_values(const MeasuredIn<3>&);

}  // namespace repose
