// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/results/registry.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace repose {

namespace {

/// Whether a number of a summary describes the run, not the grains.
bool describes_run(const std::string& name) {
  const auto* measure = find_measure(name);
  return measure != nullptr && !measure->of_grains;
}

/// Collects the numbers below a node. A null counts as a number, so that every summary has the same measures.
void flatten(const nlohmann::ordered_json& node, const std::string& prefix,
             std::vector<std::pair<std::string, double>>& found) {
  for (const auto& [key, value] : node.items()) {
    const auto name = prefix.empty() ? key : prefix + "." + key;
    if (describes_run(name)) continue;
    if (value.is_object()) flatten(value, name, found);
    if (value.is_number()) found.emplace_back(name, value.get<double>());
    if (value.is_null()) found.emplace_back(name, std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

std::vector<std::pair<std::string, double>> measures_of(const std::string& summary, const std::string& name) {
  try {
    const auto json = nlohmann::ordered_json::parse(summary);
    std::vector<std::pair<std::string, double>> found;
    flatten(json, "", found);
    return found;
  } catch (const nlohmann::json::exception&) {
    throw InputError(fmt::format("{}: is not a summary", name));
  }
}

}  // namespace repose
