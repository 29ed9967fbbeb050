// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/ensemble_column.hpp"

#include <algorithm>

namespace repose {

std::optional<EnsembleColumn> ensemble_column(const std::vector<const std::vector<ColumnLayer>*>& members) {
  if (members.empty() || members.front()->empty()) return std::nullopt;
  const auto slices = members.front()->size();
  if (std::any_of(members.begin(), members.end(), [&](const auto* layers) { return layers->size() != slices; })) {
    return std::nullopt;
  }
  EnsembleColumn column;
  column.members = members.size();
  for (std::size_t k = 0; k < slices; ++k) {
    const auto over_members = [&](double ColumnLayer::*member) {
      std::vector<double> values;
      for (const auto* layers : members) values.push_back((*layers)[k].*member);
      return mean_of(values);
    };
    column.layers.push_back({over_members(&ColumnLayer::depth), over_members(&ColumnLayer::solid_fraction),
                             over_members(&ColumnLayer::pressure), over_members(&ColumnLayer::shear),
                             over_members(&ColumnLayer::stress), over_members(&ColumnLayer::load)});
    column.mass += over_members(&ColumnLayer::mass).mean;
  }
  return column;
}

}  // namespace repose
