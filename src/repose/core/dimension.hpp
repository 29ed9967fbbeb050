// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"

#include <cstdint>
#include <type_traits>

namespace repose {

/// A number of dimensions as a type: it chooses among overloads, and gives templates their D.
template <int D>
using Dimension = std::integral_constant<int, D>;

/// Calls use(Dimension<2>{}) or use(Dimension<3>{}). The one place where the dimension of a scene becomes a template
/// argument.
template <class Use>
decltype(auto) with_dimension(std::int64_t dimension, const Use& use) {
  REPOSE_ASSERT(dimension == 2 || dimension == 3);
  return dimension == 3 ? use(Dimension<3>{}) : use(Dimension<2>{});
}

}  // namespace repose
