// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <algorithm>
#include <stdexcept>

namespace repose {

namespace {

template <int D>
RegistryIn<D>& registry() {
  static RegistryIn<D> all = [] {
    RegistryIn<D> made;
    for (const auto add : subjects<D>()) add(made);
    return made;
  }();
  return all;
}

template <int D>
const KnownMeasure* named_in(const std::string& name) {
  const auto& all = measures<D>();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& measure) { return measure.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const KnownMeasure* named(const std::string& name) {
  const auto* found = named_in<2>(name);
  return found != nullptr ? found : named_in<3>(name);
}

}  // namespace

void register_subject(Subject subject) {
  Registry added;
  subject(added);
  for (const auto& measure : added.measures) {
    if (named_in<2>(measure.name) != nullptr)
      throw std::invalid_argument("there is a measure " + measure.name + " already");
  }
  subject(registry<2>());
}

template <int D>
const std::vector<MeasureIn<D>>& measures() {
  return registry<D>().measures;
}
template <int D>
const std::vector<AnalysisGroupIn<D>>& analysis_groups() {
  return registry<D>().groups;
}
template const std::vector<MeasureIn<2>>& measures();
template const std::vector<MeasureIn<3>>& measures();
template const std::vector<AnalysisGroupIn<2>>& analysis_groups();
template const std::vector<AnalysisGroupIn<3>>& analysis_groups();

const KnownMeasure* find_measure(const std::string& name) {
  if (const auto* found = named(name)) return found;
  const auto end = name.rfind('.');
  if (end == std::string::npos) return nullptr;
  const auto* whole = named(name.substr(0, end));
  return whole != nullptr && whole->kind == KnownMeasure::Kind::estimate ? whole : nullptr;
}

}  // namespace repose
