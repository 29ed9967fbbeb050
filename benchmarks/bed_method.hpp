// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/methods/method.hpp"

#include <memory>
#include <string>

namespace repose::bench {

/// The soft method with one of the laws of beds/README.md: "hooke", "hooke-cumulative" or "continuous"; spheres have
/// "hooke" alone. Throws std::runtime_error for another one.
template <int D>
std::unique_ptr<Method<D>> bed_method(const std::string& law, const Box<D>& box);

}  // namespace repose::bench
