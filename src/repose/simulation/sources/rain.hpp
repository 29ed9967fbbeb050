// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/sources/drop.hpp"

namespace repose {

/// Rains grains over a width or an area. Grains that fall soon after each other are released together, at moments a
/// small part of a grain's own time apart, so that the neighbours of all grains are not looked up for each.
template <int D>
class Rain final : public Drop<D> {
 public:
  Rain(const Scene& scene, const DropSource& source, const TimeSteps& steps, std::int64_t first_id);

 private:
  double moment(double time) const override { return moments_.at_or_after(time); }

  Every moments_;
};

}  // namespace repose
