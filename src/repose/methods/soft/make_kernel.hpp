// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/soft/kernels.hpp"
#include "repose/methods/soft/soft.hpp"

#include <utility>

namespace repose {

// A kernel takes seconds to compile: each is instantiated in one source file, and only such files include this header.
template <int D, class Law>
std::unique_ptr<Method<D>> make_kernel(MaterialTable<Law> laws, SoftSettings<D> settings) {
  return std::make_unique<Soft<D, Law>>(std::move(laws), std::move(settings));
}

}  // namespace repose
