// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/determinacy/equilibrium.hpp"
#include "repose/record/record.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// The forces on the base grains, or of the grains that a floor carries, as sums of contact forces.
struct BaseSums {
  std::vector<std::int64_t> id;
  std::vector<double> x;                ///< [L]
  std::vector<ForceSum> normal, shear;  ///< signs as in BaseProfile

  bool loaded(std::size_t k) const { return !normal[k].terms.empty(); }
  BaseProfile profile(const ContactForces& forces) const;

  /// The mean normal force over the base grains for which `is_in(x)`; without terms where there are none.
  template <class IsIn>
  ForceSum mean_normal(const IsIn& is_in) const {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (is_in(x[k])) members.push_back(k);
    }
    ForceSum sum;
    for (const auto k : members) sum.add(normal[k], 1.0 / static_cast<double>(members.size()));
    return sum;
  }
};

BaseSums base_sums(const Record<2>& record, const ContactProblem& posed);

}  // namespace repose
