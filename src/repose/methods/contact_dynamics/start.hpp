// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"

#include <array>
#include <cstddef>

namespace repose::contact_dynamics {

/// How a sweep starts from what the sweep before it changed: at a new base, plus the change predicted there.
struct Start {
  enum class Kind {
    here,     ///< where the sweep before it ended
    restart,  ///< the base is the start of the sweep before, its change is predicted again
    combine   ///< the base also moves along a new step, to the least predicted change
  };
  static constexpr std::size_t most_others = 2;

  Kind kind = Kind::here;
  double leap = 0.0;       ///< restart: the base also moves by this multiple of the change; 0: no leap
  std::size_t others = 0;  ///< combine: number of remembered steps to which the new one is made orthogonal
  std::array<double, most_others> along_others{};
  double factor = 1.0;  ///< scales the new step and its image
  double along = 0.0;   ///< the length of the new step
};

/// The numbers of a search, impulses or velocities: one entry each.
struct History {
  double* base = nullptr;
  double* predicted = nullptr;                            ///< the predicted change
  double* change = nullptr;                               ///< of the last sweep
  double* step = nullptr;                                 ///< the new step
  double* image = nullptr;                                ///< the decrease of the change by it
  std::array<const double*, Start::most_others> steps{};  ///< the remembered ones, newest first
  std::array<const double*, Start::most_others> images{};
};

/// The image of the new step: orthogonal to the images of the first `Others` remembered steps, not scaled.
/// `at(p)` reads numbers of type T from the entry at hand.
template <std::size_t Others, class At>
REPOSE_FN auto image_of(const Start& by, const History& of, const At& at) {
  auto image = at(of.predicted) - at(of.change);
  for (std::size_t back = 0; back < Others; ++back) image += at(of.images[back]) * -by.along_others[back];
  return image;
}

/// Advances the entry at hand and returns its number at the start of the sweep. `at` reads numbers, `put` writes them.
template <Start::Kind Kind, std::size_t Others, class At, class Put>
REPOSE_FN auto start_of_sweep(const Start& by, const History& of, const At& at, const Put& put) {
  auto base = at(of.base);
  auto predicted = at(of.predicted);
  if constexpr (Kind == Start::Kind::restart) {
    base += predicted;
    predicted = at(of.change);
    if (by.leap > 0.0) base += predicted * by.leap;
  } else {
    auto image = image_of<Others>(by, of, at);
    auto step = predicted;
    for (std::size_t back = 0; back < Others; ++back) step += at(of.steps[back]) * -by.along_others[back];
    step *= by.factor;
    image *= by.factor;
    base += step * by.along;
    predicted += image * -by.along;
    put(of.step, step);
    put(of.image, image);
  }
  put(of.base, base);
  put(of.predicted, predicted);
  return base + predicted;
}

}  // namespace repose::contact_dynamics
