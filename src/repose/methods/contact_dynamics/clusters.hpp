// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace repose::contact_dynamics {

/// The clusters of bodies that contacts connect, named by one of their bodies. Bodies that impulses do not move connect
/// nothing.
class Clusters {
 public:
  template <int D>
  explicit Clusters(const Problem<D>& problem) : root_(problem.free.size()) {
    const auto moves = [&](std::uint32_t body) { return problem.free[body].inverse_mass > 0.0; };
    std::iota(root_.begin(), root_.end(), 0U);
    for (const auto& c : problem.contacts) {
      if (moves(c.first) && moves(c.second)) root_[root_of(c.first)] = root_of(c.second);
    }
    for (std::uint32_t body = 0; body < root_.size(); ++body) root_[body] = root_of(body);
    for (const auto& c : problem.contacts) of_contact_.push_back(root_[moves(c.first) ? c.first : c.second]);
  }

  std::uint32_t of(std::size_t contact) const { return of_contact_[contact]; }
  std::uint32_t of_body(std::uint32_t body) const { return root_[body]; }

 private:
  std::uint32_t root_of(std::uint32_t body) {
    while (root_[body] != body) {
      root_[body] = root_[root_[body]];
      body = root_[body];
    }
    return body;
  }

  std::vector<std::uint32_t> root_;
  std::vector<std::uint32_t> of_contact_;
};

}  // namespace repose::contact_dynamics
