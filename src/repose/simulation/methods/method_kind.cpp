// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/method_kind.hpp"

#include "repose/methods/method.hpp"

namespace repose {

std::unique_ptr<Method<3>> MethodKind::make(const Scene&, Dimension<3>) const { return nullptr; }

}  // namespace repose
