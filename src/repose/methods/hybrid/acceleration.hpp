// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/eigen.hpp"

#include <vector>

namespace repose::hybrid {

/// Anderson's acceleration of x <- x + f(x): the step goes to where f would vanish if it changed linearly with the
/// steps taken so far. It stands in for what the matrix behind f leaves out. Source: Anderson, J. ACM 12 (1965) 547;
/// Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715.
class Acceleration {
 public:
  using Numbers = Eigen::VectorXd;

  void forget() {
    directions_.clear();
    moves_.clear();
    previous_.resize(0);
  }

  /// The step instead of the plain one, f.
  Numbers step(const Numbers& plain) {
    if (previous_.size() > 0) learn(plain);
    previous_ = plain;
    taken_ = plain;
    for (std::size_t k = 0; k < directions_.size(); ++k) taken_ -= directions_[k].dot(plain) * moves_[k];
    return taken_;
  }

  /// The step was taken by this part alone.
  void shortened(double part) { taken_ *= part; }

 private:
  /// From the last step and the change of f over it, orthogonal to the changes before.
  void learn(const Numbers& plain) {
    constexpr std::size_t most = 10;    // older changes are of other contacts
    constexpr double rounding = 1e-12;  // a change within the span of those before
    if (directions_.size() == most) {
      directions_.clear();
      moves_.clear();
    }
    Numbers change = plain - previous_;
    Numbers move = taken_ + change;
    const double length = change.norm();
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      const double part = directions_[k].dot(change);
      change -= part * directions_[k];
      move -= part * moves_[k];
    }
    const double left = change.norm();
    if (!(left > rounding * length)) return;
    directions_.push_back(change / left);
    moves_.push_back(move / left);
  }

  std::vector<Numbers> directions_;  // changes of f, orthonormal
  std::vector<Numbers> moves_;       // the step and the change of f that go with each
  Numbers previous_, taken_;
};

}  // namespace repose::hybrid
