// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/soft.hpp"

#include "repose/methods/soft/kernels.hpp"

#include <algorithm>
#include <optional>

namespace repose {

namespace {

/// The table as laws of one fused kernel, if every pair of materials has exactly these two laws.
template <class Normal, class Tangential>
std::optional<MaterialTable<PairLaw<Normal, Tangential>>> fused(const MaterialLaws& laws) {
  std::vector<PairLaw<Normal, Tangential>> table;
  for (const auto& pair : laws.table) {
    const auto* normal = std::get_if<Normal>(&pair.normal);
    const auto* tangential = std::get_if<Tangential>(&pair.tangential);
    const bool plain = std::holds_alternative<FreeRolling>(pair.rolling) &&
                       std::holds_alternative<NoCohesion>(pair.cohesion) &&
                       std::holds_alternative<NoTwisting>(pair.twisting);
    if (normal == nullptr || tangential == nullptr || !plain) return std::nullopt;
    table.push_back({*normal, *tangential, {}, {}, {}});
  }
  return MaterialTable<PairLaw<Normal, Tangential>>(std::move(table), laws.materials);
}

/// Makes the method with the first fused kernel that fits. Common combinations of laws have fused kernels.
template <int D, class... Laws>
std::unique_ptr<Method<D>> make_fused(const MaterialLaws& laws, const SoftSettings<D>& settings) {
  std::unique_ptr<Method<D>> made;
  const auto attempt = [&](auto&& found) {
    using Law = std::decay_t<decltype(found->first())>;
    if (!made && found) made = make_kernel<D, Law>(*found, settings);
  };
  (attempt(fused<decltype(Laws::normal), decltype(Laws::tangential)>(laws)), ...);
  return made;
}

}  // namespace

template <int D>
std::unique_ptr<Method<D>> make_soft(const MaterialLaws& laws, const SoftSettings<D>& settings) {
  if (!settings.audit && !settings.reference && !settings.damping.any()) {
    auto made = make_fused<D, HookeLinear, HertzMindlin, ElasticHertzMindlin, ContinuousCumulative, HookeCumulative>(
        laws, settings);
    if (made) return made;
  }
  std::vector<AnyPairLaw> table;
  for (const auto& pair : laws.table) table.push_back(any_pair_law(pair));
  return make_kernel<D, AnyPairLaw>(MaterialTable<AnyPairLaw>(std::move(table), laws.materials), settings);
}

template std::unique_ptr<Method<2>> make_soft(const MaterialLaws&, const SoftSettings<2>&);
template std::unique_ptr<Method<3>> make_soft(const MaterialLaws&, const SoftSettings<3>&);

}  // namespace repose
