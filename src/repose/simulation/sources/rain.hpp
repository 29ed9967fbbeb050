// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/sources/drop.hpp"

namespace repose {

/// Rains grains over a width. Where many fall per time they are let go together, at moments a small part of a grain's
/// own time apart, so that the neighbours of all grains are not looked up for each.
class Rain final : public Drop {
 public:
  Rain(const Scene& scene, const DropSource& source, double time_step, std::int64_t first_id);

 private:
  long every() const override { return every_; }

  long every_;
};

}  // namespace repose
