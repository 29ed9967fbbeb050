// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace repose {

/// The pair law of every pair of materials.
template <class Law>
class MaterialTable {
 public:
  explicit MaterialTable(Law only) : laws_{std::move(only)} {}

  /// `laws` is a symmetric table of materials x materials.
  MaterialTable(std::vector<Law> laws, std::size_t materials) : materials_(materials), laws_(std::move(laws)) {
    REPOSE_ASSERT(laws_.size() == materials_ * materials_ && materials_ > 0);
  }

  std::size_t materials() const { return materials_; }
  bool single() const { return laws_.size() == 1; }
  const Law& first() const { return laws_.front(); }
  const std::vector<Law>& all() const { return laws_; }
  const Law& of(std::size_t a, std::size_t b) const { return laws_[a * materials_ + b]; }

 private:
  std::size_t materials_ = 1;
  std::vector<Law> laws_;
};

}  // namespace repose
