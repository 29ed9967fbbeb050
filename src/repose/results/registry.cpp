// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <algorithm>
#include <stdexcept>

namespace repose {

namespace {

Registry& registry() {
  static Registry all = [] {
    Registry made;
    for (const auto add : subjects()) add(made);
    return made;
  }();
  return all;
}

const Measure* named(const std::string& name) {
  const auto& all = measures();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& measure) { return measure.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

void register_subject(Subject subject) {
  Registry added;
  subject(added);
  for (const auto& measure : added.measures) {
    if (named(measure.name) != nullptr) throw std::invalid_argument("there is a measure " + measure.name + " already");
  }
  subject(registry());
}

const std::vector<Measure>& measures() { return registry().measures; }
const std::vector<AnalysisGroup>& analysis_groups() { return registry().groups; }

const Measure* find_measure(const std::string& name) {
  if (const auto* found = named(name)) return found;
  const auto end = name.rfind('.');
  if (end == std::string::npos) return nullptr;
  const auto* whole = named(name.substr(0, end));
  return whole != nullptr && whole->kind == Measure::Kind::estimate ? whole : nullptr;
}

}  // namespace repose
