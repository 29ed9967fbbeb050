// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/deposition/roller.hpp"

#include <cstdint>

namespace repose::deposition {

/// The search over every disc and image: the reference that `Columns` must equal to the bit.
class BruteForce {
 public:
  BruteForce(const DepositionSettings& settings, const Grains<2>& grains) : box_(settings.box), line_(grains.line) {}

  void add(std::int32_t) {}
  void prefetch(double) const {}
  void fall(Fall& fall) const { consider_all(fall); }
  void roll(Arc& arc) const { consider_all(arc); }

 private:
  template <class Meeting>
  void consider_all(Meeting& meeting) const {
    const int images = box_.periodic ? 3 : 0;  // a disc spans less than three widths of at least two diameters
    for (std::size_t k = 0; k < line_.size(); ++k) {
      const auto& disc = line_[k];
      for (int image = -images; image <= images; ++image) {
        const double shift = image == 0 ? 0.0 : static_cast<double>(image) * box_.width();
        meeting.consider({disc.position[0] + shift, disc.position[1], disc.radius, static_cast<std::int32_t>(k)});
      }
    }
  }

  Box<2> box_;
  const std::vector<Grain<2>>& line_;
};

}  // namespace repose::deposition
