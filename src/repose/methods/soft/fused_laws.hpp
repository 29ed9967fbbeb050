// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/normal/continuous.hpp"
#include "repose/laws/normal/elastic_hertz.hpp"
#include "repose/laws/normal/hertz.hpp"
#include "repose/laws/normal/hooke.hpp"
#include "repose/laws/pair_law.hpp"
#include "repose/laws/tangential/cumulative.hpp"
#include "repose/laws/tangential/linear.hpp"
#include "repose/laws/tangential/mindlin.hpp"

namespace repose {

// The laws that have a fused kernel.
using HookeLinear = PairLaw<Hooke, Linear>;
using HookeCumulative = PairLaw<Hooke, Cumulative>;
using HertzMindlin = PairLaw<Hertz, Mindlin>;
using ElasticHertzMindlin = PairLaw<ElasticHertz, Mindlin>;
using ContinuousCumulative = PairLaw<Continuous, Cumulative>;

/// Whether a pack of pairs can go through the law: only a power that is whole has the same bits in a pack.
template <class Law>
bool goes_in_packs(const Law& law) {
  if constexpr (std::is_same_v<decltype(law.normal), Continuous>) return law.normal.whole_exponent != 0;
  return true;
}

}  // namespace repose

/// Calls use(D, Law) for every law of a fused kernel, to instantiate a template.
#define REPOSE_FOR_FUSED_LAWS_IN(D, use)                                                       \
  use(D, HookeLinear) use(D, HookeCumulative) use(D, HertzMindlin) use(D, ElasticHertzMindlin) \
      use(D, ContinuousCumulative)

/// The same for every dimension.
#define REPOSE_FOR_FUSED_LAWS(use) REPOSE_FOR_FUSED_LAWS_IN(2, use) REPOSE_FOR_FUSED_LAWS_IN(3, use)
