// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"
#include "repose/laws/material_table.hpp"
#include "repose/methods/method.hpp"
#include "repose/methods/soft/fused_laws.hpp"
#include "repose/methods/soft/settings.hpp"

#include <memory>

namespace repose {

/// The soft method, `Soft<D, Law>`, for a law chosen when it is compiled. The library has, in 2D and 3D, the kernels of
/// the laws above and of AnyPairLaw; make_kernel.hpp compiles others.
template <int D, class Law>
std::unique_ptr<Method<D>> make_kernel(MaterialTable<Law> laws, SoftSettings<D> settings);

}  // namespace repose
