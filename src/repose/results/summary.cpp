// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/summary.hpp"

#include "repose/results/measure.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(std::monostate) { return nullptr; }
Json json_of(Object) { return Json::object(); }
Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json_of(std::int64_t value) { return value; }
Json json_of(const std::string& value) { return value; }
Json json_of(const std::vector<double>& values) {
  auto list = Json::array();
  for (const double value : values) list.push_back(json_of(value));
  return list;
}
Json json_of(const std::vector<std::string>& values) { return values; }
Json json_of(const Estimate& value) { return {{"mean", json_of(value.mean)}, {"error", json_of(value.error)}}; }

/// The place of a dotted name; objects on the way to it are made.
Json& place_of(Json& json, std::string_view name) {
  const auto dot = name.find('.');
  if (dot == std::string_view::npos) return json[std::string(name)];
  return place_of(json[std::string(name.substr(0, dot))], name.substr(dot + 1));
}

}  // namespace

template <int D>
std::string summary_text(const Record<D>& record, const Results<D>& results) {
  Json json;
  for (const auto& [measure, value] : measured_values(MeasuredIn<D>{record, results})) {
    place_of(json, measure.name) = std::visit([](const auto& one) { return json_of(one); }, value);
  }
  return with_checksum(json.dump(2));
}

template std::string summary_text(const Record<2>&, const Results<2>&);
template std::string summary_text(const Record<3>&, const Results<3>&);

}  // namespace repose
