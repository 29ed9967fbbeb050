// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/deposition/spheres_roller.hpp"

#include <cstddef>
#include <cstdint>

namespace repose::deposition::spheres {

/// The search over every sphere and image: the reference that `Columns` must equal to the bit.
class BruteForce {
 public:
  BruteForce(const SphereDepositionSettings& settings, const Grains<3>& grains)
      : box_(settings.box), line_(grains.line) {}

  void add(std::int32_t) {}
  void prefetch(double, double) const {}
  void fall(Fall& fall) const { consider_all(fall); }
  void roll(Arc& arc) const { consider_all(arc); }

 private:
  template <class Path>
  void consider_all(Path& path) const {
    constexpr int most = 3;  // a sphere rolls over less than three widths of at least two diameters
    const int along_x = box_.periodic ? most : 0;
    const int along_y = box_.periodic_y ? most : 0;
    for (std::size_t k = 0; k < line_.size(); ++k) {
      const auto& sphere = line_[k];
      for (int i = -along_x; i <= along_x; ++i) {
        for (int j = -along_y; j <= along_y; ++j) {
          Vec<3> centre = sphere.position;
          if (i != 0) centre[0] += static_cast<double>(i) * box_.width();
          if (j != 0) centre[1] += static_cast<double>(j) * box_.depth();
          path.consider(centre, sphere.radius, static_cast<std::int32_t>(k));
        }
      }
    }
  }

  Box<3> box_;
  const std::vector<Grain<3>>& line_;
};

}  // namespace repose::deposition::spheres
