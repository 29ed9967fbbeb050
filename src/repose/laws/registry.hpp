// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/normal/continuous.hpp"
#include "repose/laws/normal/hooke.hpp"
#include "repose/laws/tangential/cumulative.hpp"
#include "repose/laws/tangential/linear.hpp"
#include "repose/laws/tangential/none.hpp"

#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace repose {

/// Every normal and tangential law: a new law is its header and one entry here.
using NormalLaw = std::variant<Continuous, Hooke>;
using TangentialLaw = std::variant<Cumulative, Linear, None>;

/// A normal and a tangential law that act together in one compiled kernel.
template <class Normal, class Tangential>
struct PairLaw {
  Normal normal{};
  Tangential tangential{};
};

/// Calls `use` with the PairLaw of the two laws: the one dispatch of a run.
template <class Use>
decltype(auto) with_pair_law(const NormalLaw& normal, const TangentialLaw& tangential, Use&& use) {
  return std::visit(
      [&](const auto& n, const auto& t) -> decltype(auto) {
        return use(PairLaw<std::decay_t<decltype(n)>, std::decay_t<decltype(t)>>{n, t});
      },
      normal, tangential);
}

}  // namespace repose
