// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// Who touches whom.
void add_network(Registry& to) {
  const auto network = [](auto member) { return [=](const Measured& run) { return run.results.network.*member; }; };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("solid_fraction", "", "disc area in the slab over its area, where a packing is measured",
              [](const Measured& run) -> std::optional<double> {
                if (!run.results.packing) return std::nullopt;
                return run.results.packing->solid_fraction.mean;
              }));
  add(measure("coordination", "", "mean number of contacts that count of a grain that touches something",
              network(&ForceNetwork::coordination)));
  add(measure("anisotropy", "", "2 (l1 - l2) of the fabric tensor <n n> of those contacts",
              network(&ForceNetwork::anisotropy)));
  add(measure("fabric_direction_deg", "deg",
              "axis of l1 from the horizontal; in a deposition that of abs(theta) from the vertical",
              network(&ForceNetwork::direction_deg)));
  add(measure("connectivity", "", "list: fraction of those grains with 0, 1, ... 5, and 6 or more such contacts",
              [](const Measured& run) -> std::optional<std::array<double, 7>> {
                if (!run.results.network.coordination) return std::nullopt;
                return run.results.network.connectivity;
              }));
}

}  // namespace repose
