// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/method.hpp"
#include "repose/scene/scene.hpp"

#include <memory>

namespace repose {

/// The method of the scene, ready to run. Each kind makes its own, in simulation/methods.
template <int D = 2>
std::unique_ptr<Method<D>> make_method(const Scene& scene) {
  return scene.method->make(scene, Dimension<D>{});
}

}  // namespace repose
