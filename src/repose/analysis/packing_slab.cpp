// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/packing_slab.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

SlabResult find_slab(const Discs& discs, const Box<2>& box, const SlabOptions& options) {
  if (!(options.high > options.low)) {
    return {{}, fmt::format("the slab from {} to {} mean heights is empty", options.low, options.high)};
  }
  if (!std::isfinite(box.width()) || !(box.width() > 0.0)) {
    return {{}, "the packing is unbounded in x: it needs a periodic box or side walls"};
  }
  double base_sum = 0.0;
  double deposited_sum = 0.0;
  double deposited = 0.0;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const auto& centre = discs.position[k];
    if (!std::isfinite(centre[0]) || !std::isfinite(centre[1]) || !std::isfinite(discs.radius[k]) ||
        !(discs.radius[k] > 0.0)) {
      return {{}, fmt::format("disc {} has no finite position or no positive radius", k)};
    }
    (discs.base[k] ? base_sum : deposited_sum) += centre[1];
    deposited += discs.base[k] ? 0.0 : 1.0;
  }
  if (deposited == 0.0) return {{}, "nothing was deposited"};
  const double base = static_cast<double>(discs.size()) - deposited;
  if (!options.base_height && base == 0.0) return {{}, "there are no base grains to count heights from"};

  Slab slab;
  slab.box = box;
  slab.base_height = options.base_height.value_or(base_sum / base);
  slab.mean_height = deposited_sum / deposited - slab.base_height;
  slab.low = slab.base_height + options.low * slab.mean_height;
  slab.high = slab.base_height + options.high * slab.mean_height;
  if (!(slab.mean_height > 0.0)) return {{}, "the deposited discs lie no higher than the base"};
  for (std::size_t k = 0; k < discs.size(); ++k) {
    if (!discs.base[k] && slab.holds(discs.position[k])) return {slab, {}};
  }
  return {{}, fmt::format("no deposited centre lies in the slab, {:.6g} <= y < {:.6g}", slab.low, slab.high)};
}

std::vector<std::uint32_t> centres_in(const Discs& discs, const Slab& slab) {
  std::vector<std::uint32_t> inside;
  for (std::uint32_t k = 0; k < discs.size(); ++k) {
    if (!discs.base[k] && slab.holds(discs.position[k])) inside.push_back(k);
  }
  return inside;
}

}  // namespace repose
