// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fabric.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

// The sums of each block.
enum FabricSum : std::size_t { contacts, xx, yy, xy, folded_xy };
using Sums = std::array<double, 5>;

FabricTensor tensor_of(const std::vector<Sums>& blocks, FabricSum off_diagonal) {
  const auto mean = [&](FabricSum part) {
    return over_blocks(blocks, [part](const Sums& sum) { return sum[part] / sum[contacts]; }).mean;
  };
  FabricTensor tensor;
  tensor.xx = mean(xx);
  tensor.yy = mean(yy);
  tensor.xy = mean(off_diagonal);
  tensor.anisotropy = over_blocks(blocks, [off_diagonal](const Sums& sum) {
    return 2.0 * std::hypot(sum[yy] - sum[xx], 2.0 * sum[off_diagonal]) / sum[contacts];
  });
  tensor.direction_deg.mean = 0.5 * degrees_per_radian * std::atan2(2.0 * tensor.xy, tensor.yy - tensor.xx);
  // An axis has no sign, so the axis of a part is turned to the side of the axis of the whole before they are compared.
  const double whole = tensor.direction_deg.mean;
  tensor.direction_deg = over_blocks(blocks, [off_diagonal, whole](const Sums& sum) {
    const double angle = 0.5 * degrees_per_radian * std::atan2(2.0 * sum[off_diagonal], sum[yy] - sum[xx]);
    return angle - 180.0 * std::round((angle - whole) / 180.0);
  });
  if (tensor.direction_deg.mean <= -90.0) tensor.direction_deg.mean = 90.0;
  return tensor;
}

}  // namespace

std::optional<Fabric> measure_fabric(const Discs& discs, const ContactGraph& graph, const Slab& slab, std::size_t bins,
                                     std::size_t blocks) {
  Fabric fabric;
  std::vector<Sums> sums(blocks);
  std::array<double, 6> waves{};
  fabric.count.assign(bins, 0);
  const double per_bin = static_cast<double>(bins) / 180.0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (const auto j : graph.of(i)) {
      if (j <= i) continue;
      const Vec<2> branch = separation(discs.position[j], discs.position[i], slab.box);
      const double fraction = discs.radius[i] / (discs.radius[i] + discs.radius[j]);
      const Vec<2> point = slab.box.wrapped(discs.position[i] + branch * fraction);
      const double length = magnitude(branch);
      if (!slab.holds(point) || !(length > 0.0)) continue;
      ++fabric.contacts;
      const double sine = branch[0] / length;
      const double cosine = branch[1] / length;
      auto& sum = sums[block_of(slab, point[0], blocks)];
      sum[contacts] += 1.0;
      sum[xx] += sine * sine;
      sum[yy] += cosine * cosine;
      sum[xy] += sine * cosine;
      sum[folded_xy] += std::fabs(sine * cosine);
      const double cos_2 = cosine * cosine - sine * sine;
      const double sin_2 = 2.0 * sine * cosine;
      const double cos_4 = cos_2 * cos_2 - sin_2 * sin_2;
      const double sin_4 = 2.0 * sin_2 * cos_2;
      waves[0] += cos_2;
      waves[1] += sin_2;
      waves[2] += cos_4;
      waves[3] += sin_4;
      waves[4] += cos_4 * cos_2 - sin_4 * sin_2;
      waves[5] += sin_4 * cos_2 + cos_4 * sin_2;
      const double angle =
          degrees_per_radian * std::atan2(sine, cosine);  // from either end of the branch; modulo 180 below
      const auto bin = static_cast<std::int64_t>(std::floor((angle + 270.0) * per_bin - 0.5));
      ++fabric.count[static_cast<std::size_t>(bin) % bins];
    }
  }
  if (fabric.contacts == 0) return std::nullopt;
  const auto count = static_cast<double>(fabric.contacts);
  fabric.all = tensor_of(sums, xy);
  fabric.folded = tensor_of(sums, folded_xy);
  for (std::size_t k = 0; k < 3; ++k) {
    fabric.harmonics[k] = {2 * static_cast<int>(k) + 2, 2.0 * waves[2 * k] / count, 2.0 * waves[2 * k + 1] / count};
  }
  fabric.bin_width = 180.0 / static_cast<double>(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    const auto in_bin = static_cast<double>(fabric.count[k]);
    fabric.direction_deg.push_back(-90.0 + static_cast<double>(k + 1) * fabric.bin_width);
    fabric.density.push_back(in_bin / (count * fabric.bin_width));
    fabric.error.push_back(std::sqrt(in_bin) / (count * fabric.bin_width));
  }
  return fabric;
}

}  // namespace repose
