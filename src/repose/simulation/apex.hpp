// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/scene/scene.hpp"

#include <functional>
#include <limits>

namespace repose {

/// The height of the highest grain of a heap, above which a source pours.
///
/// A disc counts that touches anything: studies of heaps of discs are poured so. In a jet of spheres grains collide in
/// the air, and the source would climb its own jet: a sphere counts that hangs together with base or walls. Spheres are
/// many and come fast, so they are looked through every quarter of sqrt(d/g).
template <int D>
class Apex {
 public:
  explicit Apex(const Scene& scene);

  /// The height [L], at a time [T]; 0 without a heap. `contacts` gives those of the present state.
  double height(double time, const Grains<D>& grains, const std::function<const Contacts<D>&()>& contacts);

  void exchange(Archive& archive);

 private:
  double interval_ = 0.0;  // [T]
  double height_ = 0.0;
  double due_ = -std::numeric_limits<double>::infinity();
};

}  // namespace repose
