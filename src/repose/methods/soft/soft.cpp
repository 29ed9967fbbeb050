// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/soft.hpp"

namespace repose {

template <int D>
std::unique_ptr<Method<D>> make_soft(const NormalLaw& normal, const TangentialLaw& tangential,
                                     const SoftSettings<D>& settings) {
  return with_pair_law(normal, tangential, [&](const auto& law) -> std::unique_ptr<Method<D>> {
    using Law = std::decay_t<decltype(law)>;
    return std::make_unique<Soft<D, Law>>(soft::LawsOfMaterials<Law>(law), settings);
  });
}

template std::unique_ptr<Method<2>> make_soft(const NormalLaw&, const TangentialLaw&, const SoftSettings<2>&);

}  // namespace repose
